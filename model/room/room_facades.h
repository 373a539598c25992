/* room_facades.h - a room as part of a larger house: walls that go on. */
#ifndef PP_MODEL_ROOM_ROOM_FACADES_H
#define PP_MODEL_ROOM_ROOM_FACADES_H

#include "model/room/room.h"

/* Adds a facade to every vertical wall with a window that has none. It extends by
 * reach_m to the left and the right and upwards, and down to the ground, each as far as
 * it stays out of the room. It does not extend upwards if an opening slopes, since
 * there is no building above it. `world` is that of the unchanged room. *added: number
 * of walls that got one. */
enum pp_status pp_room_facades_add(struct pp_room *room, const struct pp_world *world,
                                   double reach_m, int *added, struct pp_error *err);

#endif
