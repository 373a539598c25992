/* draw_board.h - from a room and a point, or from options alone, to a diagram of the
 * drawing board on a canvas. */
#ifndef PP_CLI_CHART_DRAW_BOARD_H
#define PP_CLI_CHART_DRAW_BOARD_H

#include "charts/sheet/canvas.h"
#include "cli/chart/board_options.h"
#include "cli/rooms.h"

/* room NULL: a blank; else it has one receiver, where the diagram is drawn from a
 * point. */
typedef enum pp_status pp_board_drawer(struct pp_canvas *canvas,
                                       const struct pp_study_room *room,
                                       const struct pp_board_options *options,
                                       struct pp_error *err);

pp_board_drawer pp_draw_board_waldram;
pp_board_drawer pp_draw_board_pepper_pot;
pp_board_drawer pp_draw_board_protractor;
pp_board_drawer pp_draw_board_nomogram;

#endif
