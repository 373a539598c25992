/* photon_lobes.h - the lobes of a surface hit by light, and the choice of one of them.
 * Inside simulate/research/photons only.
 *
 * BRDFs are symmetric (scatter.h), so photons and rays from receivers use the same
 * lobes.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_LOBES_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_LOBES_H

#include "simulate/research/photons/photon_state.h"
#include "simulate/sampling/scatter.h"

/* Lobes of the surface that a ray has hit; if hit->part is -1, of the ground. */
struct pp_lobes pp_photon_lobes_at(const struct pp_photon_state *state,
                                   const struct pp_light_hit *hit, struct pp_vec3 to);

/* Chooses a lobe by u in (0, 1), with probabilities proportional to weights[] times the
 * lobe's share of the throughput. Multiplies the throughput by this share (without the
 * weight), divided by the probability. Returns PP_LOBE_COUNT if there is no lobe, or if
 * Russian roulette ends the path; roulette begins where the throughput falls below
 * `least`. weights: by lobe; NULL: 1 each. */
enum pp_lobe pp_photon_lobes_choose(const struct pp_lobes *lobes, const double *weights,
                                    double least, double u, struct pp_rgb *throughput);

/* Samples the ray that leaves by this lobe, from two numbers in (0, 1). False if the
 * ray would enter the surface. Multiplies the throughput by the remaining factor of
 * BSDF x cosine / pdf. */
bool pp_photon_lobes_turn(const struct pp_photon_state *state,
                          const struct pp_lobes *lobes, enum pp_lobe lobe,
                          const struct pp_light_hit *hit, double u, double v,
                          struct pp_light_ray *ray, struct pp_rgb *throughput);

#endif
