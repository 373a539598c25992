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

#include <math.h>
#include <stdbool.h>

#include "model/geometry/vec.h"

/* Distance beyond which the ground counts as unobstructed: the shadow of a tower 300 m
 * high is there 1e-7 of the ground that a window sees. */
#define PP_SCENE_GROUND_FARTHEST_M 1e6

struct pp_scene_ground {
    bool shaded;    /* false: the ground is no surface */
    double level_m; /* z, from the scene's centre */
};

/* The distance at which the ray from p along u (unit), outdoors, comes to the ground, if
 * nothing stands before it; INFINITY: never, or farther away than light is followed. */
static inline double pp_scene_ground_distance(const struct pp_scene_ground *ground,
                                              struct pp_vec3 p, struct pp_vec3 u)
{
    double over = p.z - ground->level_m;
    if (!ground->shaded || !(u.z < 0.0) || !(over > 0.0))
        return INFINITY;
    double distance = over / -u.z;
    return distance < PP_SCENE_GROUND_FARTHEST_M ? distance : INFINITY;
}

#endif
