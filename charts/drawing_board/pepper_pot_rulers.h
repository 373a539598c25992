/* pepper_pot_rulers.h - what a pepper-pot diagram is measured by: a ruler, the rule of its
 * scale, and metres at the windows' distances. */
#ifndef PP_CHARTS_DRAWING_BOARD_PEPPER_POT_RULERS_H
#define PP_CHARTS_DRAWING_BOARD_PEPPER_POT_RULERS_H

#include <stdbool.h>

#include "charts/drawing_board/pepper_pot_plot.h"

/* Draws them into `room`, only if `drawn`; returns their height. */
double pp_pepper_pot_rulers_draw(const struct pp_pepper_pot_drawing *drawing,
                                 struct pp_box room, bool drawn);

#endif
