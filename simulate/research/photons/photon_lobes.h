/* photon_lobes.h - the lobes of a surface that light has come to, and the choice of one
 * of them. Inside simulate/research/photons only.
 *
 * BRDFs are the same either way (scatter.h), so that the lobes serve light that comes
 * from the "eye" as they serve light that goes there.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_LOBES_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_LOBES_H

#include "simulate/research/photons/photon_state.h"
#include "simulate/sampling/scatter.h"

/* The lobes where a ray has met a part or, with hit->part -1, the ground. */
struct pp_lobes pp_photon_lobes_at(const struct pp_photon_state *state,
                                   const struct pp_light_hit *hit, struct pp_vec3 to);

/* A lobe by u in (0, 1), in proportion to weights[] times what its share leaves of the
 * throughput, or PP_LOBE_COUNT where there is none, or by Russian roulette, which begins where what is
 * left falls below `least`. The throughput is multiplied by the share (without the
 * weight) over the chance. weights: by lobe; NULL: 1 each. */
enum pp_lobe pp_photon_lobes_choose(const struct pp_lobes *lobes, const double *weights,
                                    double least, double u, struct pp_rgb *throughput);

/* The ray that leaves by that lobe and two numbers in (0, 1); false where it would go
 * into the surface. The throughput is multiplied by what remains of the share. */
bool pp_photon_lobes_turn(const struct pp_photon_state *state,
                          const struct pp_lobes *lobes, enum pp_lobe lobe,
                          const struct pp_light_hit *hit, double u, double v,
                          struct pp_light_ray *ray, struct pp_rgb *throughput);

#endif
