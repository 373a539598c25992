/* light_path.h - a path of light followed from its ray to its end. Inside simulate/
 * only; all points are measured from the scene's centre.
 *
 * Paths run backwards, from the eye or a sensor. At each surface that scatters, light
 * of concentrated emitters and windows is added by next-event estimation
 * (light_sources.h, light_windows.h); then the path goes on by one of the material's
 * lobes. Light is counted by one of the two ways, never by both: if the path's own ray
 * comes to an emitter or a window that was sampled directly from where the ray starts,
 * it counts nothing. No weights of multiple importance sampling are needed.
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_PATH_H
#define PP_SIMULATE_TRANSPORT_LIGHT_PATH_H

#include "simulate/transport/path_vertex.h"
#include "simulate/transport/radiance_state.h"

/* Adds the light that the path finds at the surface or environment it has come to, and
 * turns the path to where it goes from there; false where it ends. */
bool pp_light_path_arrive(struct pp_radiance_state *state, struct pp_light_path *path,
                          enum pp_meeting meeting, const struct pp_light_hit *hit,
                          struct pp_rgb *total);

/* Follows a path to its end; what it meets first goes to *first (may be NULL). */
struct pp_rgb pp_light_path_follow(struct pp_radiance_state *state,
                                   struct pp_light_path *path,
                                   struct pp_light_hit *first);

/* Follows a path whose ray has met `hit` already. */
struct pp_rgb pp_light_path_follow_from(struct pp_radiance_state *state,
                                        struct pp_light_path *path,
                                        enum pp_meeting meeting,
                                        const struct pp_light_hit *hit);

#endif
