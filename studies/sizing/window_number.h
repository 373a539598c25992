/* window_number.h - changes the number of equal windows in a wall. Each window is in
 * the middle of an equal part of the wall's length. For use by window_sizes and
 * gain_changes, inside studies/sizing/ only. */
#ifndef PP_STUDIES_SIZING_WINDOW_NUMBER_H
#define PP_STUDIES_SIZING_WINDOW_NUMBER_H

#include "model/base/error.h"
#include "model/room/room.h"
#include "model/room/world.h"

/* Length (m) of the wall that contains the opening, along its foot. */
double pp_window_number_wall_length(const struct pp_world *world, int opening);

/* Lists the possible numbers of windows in ascending order, including the present
 * number. The caller frees *numbers. PP_BAD_INPUT unless the openings are in the same
 * wall and have the same size and sill height. */
enum pp_status pp_window_number_choices(int **numbers, int *count,
                                        const struct pp_room *room, const int *openings,
                                        int opening_count, struct pp_error *err);

/* Makes a room with `number` windows in place of the given openings. The caller
 * destroys *changed. */
enum pp_status pp_window_number_room(struct pp_room **changed,
                                     const struct pp_room *room, const int *openings,
                                     int opening_count, int number,
                                     struct pp_error *err);

#endif
