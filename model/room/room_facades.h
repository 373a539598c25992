/* room_facades.h - a room as part of a larger house: walls that go on. */
#ifndef PP_MODEL_ROOM_ROOM_FACADES_H
#define PP_MODEL_ROOM_ROOM_FACADES_H

#include "model/room/room.h"

/* Gives every upright wall with a window that has no facade one that goes on by reach_m
 * to the left and the right, up and down to the ground, each as far as it stays out of
 * the room; not up where an opening is not upright, since above that there is no house.
 * `world` is the room's as it was. *added: how many walls have got one. */
enum pp_status pp_room_facades_add(struct pp_room *room, const struct pp_world *world,
                                   double reach_m, int *added, struct pp_error *err);

#endif
