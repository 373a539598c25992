/* light_path.h - a path of light followed from its ray to its end. Inside simulate/
 * only; all points are measured from the scene's centre.
 *
 * Paths run backwards, from the eye or a sensor. At each surface that scatters, light
 * of concentrated emitters and windows is added by next-event estimation
 * (light_sources.h, sample_openings.h). Then the path continues by one of the
 * material's lobes. Its ray may reach an emitter or a window that was sampled directly
 * at the ray's origin. After a diffuse lobe, this light counts as zero. After a gloss,
 * it has the weight of multiple importance sampling.
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_PATH_H
#define PP_SIMULATE_TRANSPORT_LIGHT_PATH_H

#include "simulate/transport/irradiance.h"
#include "simulate/transport/path_vertex.h"
#include "simulate/transport/radiance_state.h"

/* Adds the light found at the surface or environment that the path has reached, and
 * sets the path's next ray; false if the path ends. */
bool pp_light_path_arrive(struct pp_radiance_state *state, struct pp_light_path *path,
                          enum pp_meeting meeting, const struct pp_light_hit *hit,
                          struct pp_rgb *total);

/* Follows a path to its end; the first hit is stored in *first (may be NULL). */
struct pp_rgb pp_light_path_follow(struct pp_radiance_state *state,
                                   struct pp_light_path *path,
                                   struct pp_light_hit *first);

/* Path that continues outside from a window that was sampled directly. */
static inline struct pp_light_path pp_light_path_outside(
    const struct pp_radiance_state *state, const struct pp_light_ray *ray, int vertex,
    int depth)
{
    return (struct pp_light_path){.ray = *ray,
                                  .throughput = pp_rgb_grey(1.0),
                                  .least = state->options.least,
                                  .sampled = PP_DIRECTLY_SAMPLED_ALL,
                                  .sampled_in = PP_OUTDOORS,
                                  .mirror_path = -1,
                                  .arrival = {.reflector = -1},
                                  .depth = depth,
                                  .vertex = vertex,
                                  .from_window = true};
}

/* One sample of the light from all windows that the shading point sends to the eye.
 * Adds it to the sky or the outside of *sum. Light that comes from the room through
 * another opening, from a side of a niche, or by an image in a reflector is added to
 * the rest. */
void pp_light_path_windows(struct pp_radiance_state *state,
                           const struct pp_shading_point *shading,
                           struct pp_irradiance *sum);

/* One sample of the light of other openings that the glass of a room's openings
 * reflects into the room (glass_images.h), often none; added to the rest. Rays that
 * reach openings by reflection in that glass must then exclude this light. */
void pp_light_path_glass(struct pp_radiance_state *state,
                         const struct pp_shading_point *shading,
                         struct pp_glass_view *view, struct pp_irradiance *sum);

#endif
