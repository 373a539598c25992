/* ground.h - the level of the ground, where the ground is a surface of a simulation. */
#ifndef PP_MODEL_ROOM_GROUND_H
#define PP_MODEL_ROOM_GROUND_H

#include "model/room/world.h"

/* z of the ground (m): the world's ground level, but no higher than the lowest point of
 * an opening, as if the ground were excavated in front of a low window. Without a room,
 * no higher than the lowest receiver. */
double pp_ground_level(const struct pp_world *world);

#endif
