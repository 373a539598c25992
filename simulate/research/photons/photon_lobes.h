/* photon_lobes.h - the lobes of a surface hit by light, and the choice of one of them.
 * Inside simulate/research/photons only.
 *
 * BRDFs are symmetric (scatter.h), so the same lobes serve photons and rays from
 * receivers.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_LOBES_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_LOBES_H

#include "simulate/research/photons/photon_state.h"
#include "simulate/sampling/scatter.h"

/* The lobes of the part that a ray has met or, with hit->part -1, of the ground. */
struct pp_lobes pp_photon_lobes_at(const struct pp_photon_state *state,
                                   const struct pp_light_hit *hit, struct pp_vec3 to);

/* Chooses a lobe by u in (0, 1), in proportion to weights[] times the throughput after
 * its share. PP_LOBE_COUNT if there is none, or by Russian roulette, which begins where
 * the throughput falls below `least`. The throughput is multiplied by the share
 * (without the weight) over the probability. weights: by lobe; NULL: 1 each. */
enum pp_lobe pp_photon_lobes_choose(const struct pp_lobes *lobes, const double *weights,
                                    double least, double u, struct pp_rgb *throughput);

/* Samples the ray that leaves by that lobe, from two numbers in (0, 1); false if it
 * would enter the surface. The throughput is multiplied by the rest of the share. */
bool pp_photon_lobes_turn(const struct pp_photon_state *state,
                          const struct pp_lobes *lobes, enum pp_lobe lobe,
                          const struct pp_light_hit *hit, double u, double v,
                          struct pp_light_ray *ray, struct pp_rgb *throughput);

#endif
