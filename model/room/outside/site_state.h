/* site_state.h - the parts of a room and its surroundings that exist in a state of the
 * site. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_SITE_STATE_H
#define PP_MODEL_ROOM_OUTSIDE_SITE_STATE_H

#include "model/room/room_parts.h"

/* True if an object with that state exists in the other, PP_STATE_EXISTING or
 * PP_STATE_PROPOSED. */
bool pp_site_state_has(enum pp_site_state state, enum pp_site_state it);

/* Keeps only those of the room's parts that exist in the state, in order. */
void pp_site_state_keep(struct pp_room *room, enum pp_site_state state);

/* True if the room, or any of its parts, exists in one state only. */
bool pp_site_state_matters(const struct pp_room *room);

#endif
