/* scene_ground.c - see scene_ground.h. */
#include "simulate/scene/scene_ground.h"

#include <math.h>

#include "model/room/ground.h"

/* Beyond this the ground is taken for open: the shadow of a tower 300 m high there is
 * one part in ten million of what a window sees of the ground. */
static const double FARTHEST_M = 1e6;

struct pp_scene_ground pp_scene_ground_of(const struct pp_world *world,
                                          struct pp_vec3 centre)
{
    return (struct pp_scene_ground){.shaded = !world->ground_is_open,
                                    .level_m = pp_ground_level(world) - centre.z};
}

double pp_scene_ground_distance(const struct pp_scene_ground *ground, struct pp_vec3 p,
                                struct pp_vec3 u)
{
    double over = p.z - ground->level_m;
    if (!ground->shaded || !(u.z < 0.0) || !(over > 0.0))
        return INFINITY;
    double distance = over / -u.z;
    return distance < FARTHEST_M ? distance : INFINITY;
}
