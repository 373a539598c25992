/* window_store.h - what is outside, as an opening sees it, worked out once.
 *
 * An opening is cut into patches, the smaller the nearer something stands outside. For
 * each patch and each direction (bins of equal projected solid angle) it holds the mean
 * radiance of the surfaces that are met there, if they are as far away as twice the
 * size of a patch. Sky, ground and skylines are not in it: whoever looks out still finds
 * out by a ray whether it meets a surface, so that the silhouettes stay sharp.
 */
#ifndef PP_SIMULATE_TRANSPORT_WINDOW_STORE_H
#define PP_SIMULATE_TRANSPORT_WINDOW_STORE_H

#include "simulate/scene/light_parts.h"
#include "simulate/transport/radiance.h"

/* The radiance of the surface that is met outside, at that distance along `to`, from a
 * point (from the scene's centre) of the window; false where the store has none. */
bool pp_window_store_radiance(const struct pp_window_store *store,
                              const struct pp_light_scene *scene, int window,
                              struct pp_vec3 point, struct pp_vec3 to,
                              double distance_m, struct pp_rgb *radiance);

/* ---- what the store is worked out with: light_windows.c ---- */

/* One sample of the radiance along a ray (from the centre) that leaves a window to the
 * outside, if it meets a surface: false if it does not. *distance_m is how far. */
bool pp_light_windows_outside_radiance(struct pp_radiance_state *state,
                                       const struct pp_light_ray *ray,
                                       struct pp_rgb *radiance, double *distance_m);

#endif
