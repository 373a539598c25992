/* unsampled.h - an upper bound on the irradiance that paths may have missed.
 *
 * Next-event estimation misses no emitter. Light that rays must find by their own
 * directions may be missed by all of them without leaving a trace in their spread: a
 * small extended emitter, or a lamp in a curved mirror. The bound is one path's worth
 * of the brightest of such emitters, or all that there can be of their light if that is
 * less.
 */
#ifndef PP_SIMULATE_SCENE_UNSAMPLED_H
#define PP_SIMULATE_SCENE_UNSAMPLED_H

#include "simulate/scene/light_scene.h"

/* Finds the scene's brightest extended emitter that has a place, once all its parts are
 * there. */
void pp_unsampled_find_glow(struct pp_light_scene *scene);

/* The bound at a point after that many paths. Counted are extended emitters (but for
 * skies with a pattern), and concentrated ones by the reflections by which next-event
 * estimation does not sample them, curved mirrors taken for plane ones; with
 * `by_chance`, where there is no next-event estimation, concentrated emitters
 * altogether. */
struct pp_rgb pp_unsampled_bound(const struct pp_light_scene *scene,
                                 struct pp_vec3 point, bool by_chance, long paths);

#endif
