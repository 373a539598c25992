/* window_number.h - a room with more or fewer windows of one kind in a wall: each in
 * the middle of its share of the wall's length. What window_sizes is made of; inside
 * studies/sizing/ only.
 */
#ifndef PP_STUDIES_SIZING_WINDOW_NUMBER_H
#define PP_STUDIES_SIZING_WINDOW_NUMBER_H

#include "model/base/error.h"
#include "model/room/room.h"

/* The numbers of windows that can be, in order, those of the room as it is among them;
 * *numbers is the caller's. PP_BAD_INPUT where the openings are not alike. */
enum pp_status pp_window_number_choices(int **numbers, int *count,
                                        const struct pp_room *room, const int *openings,
                                        int opening_count, struct pp_error *err);

/* The room with that number of windows in place of these; the caller's. */
enum pp_status pp_window_number_room(struct pp_room **changed,
                                     const struct pp_room *room, const int *openings,
                                     int opening_count, int number,
                                     struct pp_error *err);

#endif
