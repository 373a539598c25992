/* unsampled.h - upper bounds on the light that paths may have missed.
 *
 * Next-event estimation misses no emitter and no opening that it samples, with one
 * exception. If no path has found any light, all paths may have missed a slit through
 * which one more path would have found the light of all openings. Other light, from a
 * small extended emitter or from a lamp seen in a curved mirror, is found only by
 * chance. If all paths miss such light, their spread does not show it. The bound is the
 * contribution of one path that finds the brightest such emitter, or the light of all
 * such emitters if that is less.
 */
#ifndef PP_SIMULATE_SCENE_UNSAMPLED_H
#define PP_SIMULATE_SCENE_UNSAMPLED_H

#include "simulate/scene/emitters.h"
#include "simulate/scene/light_scene.h"

/* Finds the radiance of the scene's brightest extended emitter that is not distant,
 * after all parts are added. */
void pp_unsampled_find_glow(struct pp_light_scene *scene);

/* Fraction of an emitter's light that may arrive by reflections which next-event
 * estimation does not sample. For a distant emitter, it is determined by 4,096 rays of
 * the emitter over the whole scene. If none of these rays is reflected in that way, the
 * fraction is that of one ray. Called once, after the scene is complete. */
double pp_unsampled_probe(const struct pp_light_scene *scene,
                          const struct pp_emitter *emitter);

/* Irradiances at a point of a scene. by_chance: light that is found only by chance;
 * brightest: radiance of the brightest emitter of such light; all: light of all
 * emitters and the sky, if nothing obstructed them. Light found only by chance comes
 * from extended emitters (except skies with a pattern), and from concentrated emitters
 * by reflections that next-event estimation does not sample, with curved mirrors
 * treated as plane ones. With the argument by_chance there is no next-event estimation,
 * and all concentrated emitters are included. shares: pp_unsampled_probe of each
 * emitter. */
struct pp_unsampled {
    struct pp_rgb by_chance, brightest, all;
};

struct pp_unsampled pp_unsampled_at(const struct pp_light_scene *scene,
                                    struct pp_vec3 point, bool by_chance,
                                    const double *shares);

/* Upper bound after this many paths. found: true if the light differs between
 * randomisations; otherwise even light that is sampled may have been missed. */
struct pp_rgb pp_unsampled_bound(const struct pp_unsampled *unsampled, bool found,
                                 double paths);

/* Rough, conservative upper bound of each component of the daylight factor at a point
 * of a room (PP_SC to PP_IRC), for unobstructed openings; 0 if no light path exists.
 * position: in the scene's coordinates; NULL: anywhere on the working plane. */
struct pp_room_bound {
    double part[3];
};

struct pp_room_bound pp_unsampled_of_room(const struct pp_light_scene *scene,
                                          const struct pp_vec3 *position,
                                          struct pp_vec3 normal);

/* Upper bound of a component, or of the sum of all components, that no path has found,
 * after `straight` paths of direct and `reflected` paths of reflected light. Bit i of
 * `found` is set if component i was found. */
double pp_unsampled_of_component(const struct pp_room_bound *most, int component,
                                 unsigned found, double straight, double reflected);

#endif
