/* photon_outside.h - the light that comes to a place from outside along one direction.
 *
 * Of sky, open ground and skylines it is known; a surface, or the ground in its shadow,
 * reflects what a path of its own finds there, one direction after another. Light that
 * has come through the room before is left out here: photons bring it, which leave by one
 * opening and come back by any.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_OUTSIDE_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_OUTSIDE_H

#include "simulate/research/photons/photon_state.h"

/* The radiance that comes against the ray, outdoors; *is_sky: is it the sky's,
 * straight? free: no surface is met. vertex: of its random numbers. */
struct pp_rgb pp_photon_outside(struct pp_photon_state *state, struct pp_light_ray ray,
                                bool free, int vertex, bool *is_sky);

#endif
