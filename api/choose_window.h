/* choose_window.h - the window that a chart is of. */
#ifndef PP_API_CHOOSE_WINDOW_H
#define PP_API_CHOOSE_WINDOW_H

#include "model/room/world.h"

/* The first opening, unless the words choose one: by its line in the room file, or by its
 * wall, whose only one it is. upright: of windows in walls only. PP_BAD_INPUT says what is
 * wrong, or that there is none. */
enum pp_status pp_choose_window(int *window, const struct pp_world *world,
                                const char *words, bool upright, struct pp_error *err);

#endif
