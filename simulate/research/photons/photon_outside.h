/* photon_outside.h - the light from outside at a place along one direction.
 *
 * The light of sky, open ground and skylines is known. From a surface, or from ground
 * in the shadow of one, a separate path is followed, one direction after another. Light
 * that has passed through the room before is not included. Photons carry this light,
 * since they may leave through one opening and return through any.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_OUTSIDE_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_OUTSIDE_H

#include "simulate/research/photons/photon_state.h"

/* Radiance that arrives from outdoors against the direction of the ray. *is_sky: true
 * if the light comes directly from the sky. free: the ray meets no surface. vertex:
 * index of the path's random numbers. */
struct pp_rgb pp_photon_outside(struct pp_photon_state *state, struct pp_light_ray ray,
                                bool free, int vertex, bool *is_sky);

#endif
