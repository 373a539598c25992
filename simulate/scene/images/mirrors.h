/* mirrors.h - plane mirrors, by which next-event estimation also samples emitters.
 *
 * As for Radiance's `mirror` [WS98], directions to the emitter are sampled from the
 * image of the shading point behind the mirror, and unfolded again. Here, any surface
 * that mirrors is used. Light by curved mirrors, by weaker planes if there are many,
 * and by third reflections is only found by rays that reach the emitter by chance. The
 * light that such rays may miss is part of the stated error (unsampled.h).
 */
#ifndef PP_SIMULATE_SCENE_IMAGES_MIRRORS_H
#define PP_SIMULATE_SCENE_IMAGES_MIRRORS_H

#include "simulate/scene/light_scene.h"

/* A plane that contains at least one mirroring part. */
struct pp_mirror {
    struct pp_vec3 normal; /* unit, on either side */
    double offset_m;
    double share; /* greatest reflectance of the plane's parts at normal incidence */
};

/* Successive mirrors between a point and an emitter. Indices of mirror paths below may
 * be -1: the path without a mirror. */
enum { PP_MIRROR_PATH_MOST = 2 };
struct pp_mirror_path {
    int mirrors[PP_MIRROR_PATH_MOST]; /* -1 after the last */
    double share;                     /* product of the mirrors' shares */
};

/* Finds the scene's mirrors and mirror paths, after all its parts and emitters are
 * added. */
enum pp_status pp_mirrors_find(struct pp_light_scene *scene, struct pp_error *err);

/* The mirror path that consists of this path and a further mirror; -1: there is
 * none. */
int pp_mirrors_path_extend(const struct pp_light_scene *scene, int mirror_path,
                           int mirror);

/* The image of a point, and of a direction, behind the last mirror. */
struct pp_vec3 pp_mirrors_path_point(const struct pp_light_scene *scene,
                                     int mirror_path, struct pp_vec3 p);
struct pp_vec3 pp_mirrors_path_direction(const struct pp_light_scene *scene,
                                         int mirror_path, struct pp_vec3 u);

/* The direction in which a ray must leave the point, so that it leaves the last mirror
 * along u. */
struct pp_vec3 pp_mirrors_path_unfold(const struct pp_light_scene *scene,
                                      int mirror_path, struct pp_vec3 u);

#endif
