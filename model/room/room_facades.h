/* room_facades.h - treats a room as part of a larger building, whose walls extend
 * beyond it. */
#ifndef PP_MODEL_ROOM_ROOM_FACADES_H
#define PP_MODEL_ROOM_ROOM_FACADES_H

#include "model/room/room.h"

/* Adds a facade to every vertical wall with a name that has a window but no facade. The
 * facade extends by reach_m to both sides, upwards, and downwards, but not below the
 * ground. It does not extend to a side where it would cross the room, or where a window
 * is round the corner of the house. If any opening is not vertical, there is assumed to
 * be no building above, and facades do not extend upwards. `world` is the world of the
 * unchanged room. *added: number of new facades. */
enum pp_status pp_room_facades_add(struct pp_room *room, const struct pp_world *world,
                                   double reach_m, int *added, struct pp_error *err);

#endif
