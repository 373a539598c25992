/* room_before.h - the former state of a room: its counterpart before the
 * development. */
#ifndef PP_STUDIES_CRITERIA_ROOM_BEFORE_H
#define PP_STUDIES_CRITERIA_ROOM_BEFORE_H

#include "studies/study_room.h"

/* The rooms before. */
struct pp_rooms_before {
    const struct pp_study_room *list;
    int count;
    bool is_state; /* the former rooms are those of the same files in another state,
                   * where a room may be missing; else of another file, where it may
                   * not */
};

/* *found is one of the rooms before: the same of the same file in its other state, the one of
 * the same name, or the only one where there is but one of each (room_count is how many
 * there are now); NULL: there was none. *pairs are its openings as of pp_pair_rooms
 * (pair_rooms.h), to be freed. PP_BAD_INPUT says what is no pair, with the file. */
enum pp_status pp_room_before_find(const struct pp_study_room **found, int **pairs,
                                   const struct pp_study_room *room, int room_count,
                                   const struct pp_rooms_before *before,
                                   struct pp_error *err);

#endif
