/* scene_ground.h - the ground outside, for rays: an infinite horizontal plane, visible
 * from above.
 *
 * It is a diffuse surface like others, in the shadow of objects on it; its reflectance
 * belongs to the environment (environment.h). Rays that are indoors, or start below it,
 * do not meet it. An open ground is not a surface: it belongs to the light from
 * outside.
 */
#ifndef PP_SIMULATE_SCENE_SCENE_GROUND_H
#define PP_SIMULATE_SCENE_SCENE_GROUND_H

#include <math.h>
#include <stdbool.h>

#include "model/geometry/vec.h"

/* Distance beyond which the ground counts as unobstructed: the shadow of a tower 300 m
 * high there covers 1e-7 of the ground visible from a window. */
#define PP_SCENE_GROUND_FARTHEST_M 1e6

struct pp_scene_ground {
    bool shaded;    /* false: the ground is not a surface */
    double level_m; /* z, from the scene's centre */
};

/* Distance at which the ray from p along u (unit), outdoors, meets the ground if
 * nothing is in front; INFINITY: it does not, or only beyond
 * PP_SCENE_GROUND_FARTHEST_M. */
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
