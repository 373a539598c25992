/* site_state.h - the parts of a room and its surroundings that exist in a state of the
 * site. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_SITE_STATE_H
#define PP_MODEL_ROOM_OUTSIDE_SITE_STATE_H

#include "model/room/room_parts.h"

/* True if a part with state `it` exists in `state` of the site. */
bool pp_site_state_has(enum pp_site_state state, enum pp_site_state it);

/* Removes the parts of the room that do not exist in the state; keeps their order. */
void pp_site_state_keep(struct pp_room *room, enum pp_site_state state);

/* Set of the states of the room and its parts, as bits 1 << enum pp_site_state; 1 if
 * all parts always exist. */
unsigned pp_site_state_set(const struct pp_room *room);

#endif
