/* ground.c - see ground.h. */
#include "model/room/ground.h"

#include <math.h>

double pp_ground_level(const struct pp_world *world)
{
    double level = world->ground_level_m;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outer = &world->openings[i].outer;
        for (int k = 0; k < outer->count; k++)
            level = fmin(level, outer->vertices[k].z);
    }
    for (int i = 0; world->face_count == 0 && i < world->receiver_count; i++)
        level = fmin(level, world->receivers[i].position.z);
    return level;
}
