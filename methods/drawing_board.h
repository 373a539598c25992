/* drawing_board.h - what the sheets of the graphical methods share: whether a method
 * holds a room, and which of its windows go on one diagram. */
#ifndef PP_METHODS_DRAWING_BOARD_H
#define PP_METHODS_DRAWING_BOARD_H

#include "methods/method.h"

/* PP_OK where the method holds the room as the receiver sees it; else PP_BAD_INPUT and
 * why. */
enum pp_status pp_drawing_board_check(const struct pp_method *method,
                                      const struct pp_world *world,
                                      const struct pp_receiver *receiver,
                                      struct pp_error *err);

/* The index of the first opening that stands on one diagram with opening `index`: that
 * faces the same way and has glass, or none, like it; `index` itself where none does
 * before it. */
int pp_drawing_board_first_alike(const struct pp_world *world, int index);

/* How many openings stand on one diagram with opening `first`, it included. */
int pp_drawing_board_count_alike(const struct pp_world *world, int first);

/* How many diagrams a room needs. */
int pp_drawing_board_diagram_count(const struct pp_world *world);

#endif
