/* choose_window.h - the window that a chart is of. */
#ifndef PP_API_CHOOSE_WINDOW_H
#define PP_API_CHOOSE_WINDOW_H

#include "model/room/world.h"

/* Chooses the first opening, or the one given by its line in the room file or by its
 * wall, if it is the only one there. upright: only windows in walls. PP_BAD_INPUT with
 * the reason, or if there is none. */
enum pp_status pp_choose_window(int *window, const struct pp_world *world,
                                const char *words, bool upright, struct pp_error *err);

#endif
