/* window_number.h - a room with more or fewer equal windows in a wall, each in the
 * middle of its share of the wall's length. For window_sizes and gain_changes; inside
 * studies/sizing/ only. */
#ifndef PP_STUDIES_SIZING_WINDOW_NUMBER_H
#define PP_STUDIES_SIZING_WINDOW_NUMBER_H

#include "model/base/error.h"
#include "model/room/room.h"
#include "model/room/world.h"

/* Length of the wall that the opening is in, along its foot (m). */
double pp_window_number_wall_length(const struct pp_world *world, int opening);

/* Possible numbers of windows in ascending order, including the room's own number. The
 * caller frees *numbers. PP_BAD_INPUT unless the openings are in one wall and have the
 * same size and sill height. */
enum pp_status pp_window_number_choices(int **numbers, int *count,
                                        const struct pp_room *room, const int *openings,
                                        int opening_count, struct pp_error *err);

/* Makes the room with that number of windows instead of the given ones; the caller
 * destroys *changed. */
enum pp_status pp_window_number_room(struct pp_room **changed,
                                     const struct pp_room *room, const int *openings,
                                     int opening_count, int number,
                                     struct pp_error *err);

#endif
