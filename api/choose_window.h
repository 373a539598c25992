/* choose_window.h - selects the window that a chart shows. */
#ifndef PP_API_CHOOSE_WINDOW_H
#define PP_API_CHOOSE_WINDOW_H

#include "model/room/world.h"

/* Selects an opening by its name, by its wall if it is the only one there, or by its
 * line in the room file; words NULL: the first opening, or the first vertical one if
 * `upright`. PP_BAD_INPUT if there is no such window, or if it is not vertical although
 * `upright` is set. */
enum pp_status pp_choose_window(int *window, const struct pp_world *world,
                                const char *words, bool upright, struct pp_error *err);

#endif
