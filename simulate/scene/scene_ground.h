/* scene_ground.h - the ground outside as rays meet it: an endless level plane, seen from
 * above.
 *
 * It is a surface like others, diffuse, in the shadow of what stands on it; what it
 * reflects is the environment's (environment.h). Rays that are indoors don't meet it, nor
 * do those that start below it. An open ground is no surface: it belongs to the light
 * from outside.
 */
#ifndef PP_SIMULATE_SCENE_SCENE_GROUND_H
#define PP_SIMULATE_SCENE_SCENE_GROUND_H

#include <stdbool.h>

#include "model/room/world.h"

struct pp_scene_ground {
    bool shaded;    /* false: the ground is no surface */
    double level_m; /* z, from the scene's centre */
};

struct pp_scene_ground pp_scene_ground_of(const struct pp_world *world,
                                          struct pp_vec3 centre);

/* The distance at which the ray from p along u (unit), outdoors, comes to the ground, if
 * nothing stands before it; INFINITY: never, or farther away than light is followed. */
double pp_scene_ground_distance(const struct pp_scene_ground *ground, struct pp_vec3 p,
                                struct pp_vec3 u);

#endif
