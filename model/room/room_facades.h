/* room_facades.h - treats a room as part of a larger building, whose walls extend
 * beyond it. */
#ifndef PP_MODEL_ROOM_ROOM_FACADES_H
#define PP_MODEL_ROOM_ROOM_FACADES_H

#include "model/room/room.h"

/* Adds a facade to every vertical wall that has a window but no facade. The facade
 * extends by reach_m to both sides and upwards, and down to the ground, but not in
 * directions in which it would cross the room. It ends at a corner of the house if
 * there is a window round that corner. If any opening slopes, there is assumed to be no
 * building above, and facades do not extend upwards. `world` is the world of the
 * unchanged room. *added: number of new facades. */
enum pp_status pp_room_facades_add(struct pp_room *room, const struct pp_world *world,
                                   double reach_m, int *added, struct pp_error *err);

#endif
