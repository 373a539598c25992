/* named_block.h - a block of a room, found by its name: a box, with or without a roof, or
 * walls over a footprint. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_NAMED_BLOCK_H
#define PP_MODEL_ROOM_OUTSIDE_NAMED_BLOCK_H

#include "model/room/room_parts.h"

/* Finds the lowest and highest z of the surfaces of the block on that line: its roof,
 * or its walls over a footprint. The box itself is not included. */
void pp_named_block_reach(double reach_m[2], const struct pp_room *room, int line);

/* Line of the only block with that name; 0 if there is none, or several. *box: its
 * index among the room's boxes; -1: it has a footprint instead. */
int pp_named_block_find(const struct pp_room *room, const char *name, int *box);

/* Removes all boxes and surfaces of blocks with that name. *like: an unnamed box with
 * their properties. False if there are none. */
bool pp_named_block_take_out(struct pp_block *like, struct pp_room *room,
                             const char *name);

#endif
