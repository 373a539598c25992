/* ground.h - the level at which light meets the ground outside. */
#ifndef PP_MODEL_ROOM_GROUND_H
#define PP_MODEL_ROOM_GROUND_H

#include "model/room/world.h"

/* z of the ground as a surface, in m: the world's ground level, but no higher than the
 * lowest point of an opening (of a receiver, where there is no room), as if the ground
 * were dug away before a window that it would bury. */
double pp_ground_level(const struct pp_world *world);

#endif
