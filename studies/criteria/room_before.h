/* room_before.h - the former state of a room: its counterpart before the
 * development. */
#ifndef PP_STUDIES_CRITERIA_ROOM_BEFORE_H
#define PP_STUDIES_CRITERIA_ROOM_BEFORE_H

#include "studies/study_room.h"

/* Rooms among which the former state of a room is searched. */
struct pp_rooms_before {
    const struct pp_study_room *list;
    int count;
    bool is_state; /* true: the same files in another state, in which a room may be
                    * missing; false: another file, which must have each room */
};

/* *found: the former state of a room, not owned. With is_state, this is the same room
 * of the same file; otherwise the room of the same name, or the only room if there is
 * one room now and one before (room_count: number of rooms now). NULL: the room did not
 * exist. *pairs: as from pp_pair_rooms (pair_rooms.h), to be freed. PP_BAD_INPUT, whose
 * message names the file, if the room cannot be paired. */
enum pp_status pp_room_before_find(const struct pp_study_room **found, int **pairs,
                                   const struct pp_study_room *room, int room_count,
                                   const struct pp_rooms_before *before,
                                   struct pp_error *err);

#endif
