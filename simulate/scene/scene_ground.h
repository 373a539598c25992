/* scene_ground.h - the ground outside, for rays: an infinite horizontal plane, visible
 * from above.
 *
 * The ground is a diffuse surface like others, on which objects cast shadows; its
 * reflectance belongs to the environment (environment.h). Rays that run indoors, or
 * start below the ground, do not meet it. An open ground, without shadows, is not a
 * surface; it belongs to the light from outside.
 */
#ifndef PP_SIMULATE_SCENE_SCENE_GROUND_H
#define PP_SIMULATE_SCENE_SCENE_GROUND_H

#include <math.h>
#include <stdbool.h>

#include "model/geometry/vec.h"

/* Distance beyond which the ground counts as unobstructed. At this distance, the shadow
 * of a tower 300 m high covers 1e-7 of the ground visible from a window. */
#define PP_SCENE_GROUND_FARTHEST_M 1e6

struct pp_scene_ground {
    bool shaded;    /* false: the ground is not a surface */
    double level_m; /* z, from the scene's centre */
};

/* Distance at which the ray from p along u (unit), outdoors, meets the ground if
 * nothing is in front. INFINITY if it never meets the ground, or only beyond
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
