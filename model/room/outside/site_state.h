/* site_state.h - what of a room and of what stands outside it is there in a state of the
 * site. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_SITE_STATE_H
#define PP_MODEL_ROOM_OUTSIDE_SITE_STATE_H

#include "model/room/room_parts.h"

/* Is a thing with that state there in the other, PP_STATE_EXISTING or
 * PP_STATE_PROPOSED? */
bool pp_site_state_has(enum pp_site_state state, enum pp_site_state it);

/* Leaves of the room's parts only those that there are in the state, in their order. */
void pp_site_state_keep(struct pp_room *room, enum pp_site_state state);

/* Is the room, or any of its parts, there in one state only? */
bool pp_site_state_matters(const struct pp_room *room);

#endif
