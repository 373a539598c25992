/* waldram_plot.h - one panel of a Waldram diagram on paper. */
#ifndef PP_CHARTS_DRAWING_BOARD_WALDRAM_PLOT_H
#define PP_CHARTS_DRAWING_BOARD_WALDRAM_PLOT_H

#include <stdbool.h>

#include "charts/sheet/lettering.h"
#include "charts/sheet/style.h"
#include "model/results/board_sheets.h"

struct pp_waldram_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_waldram_sheet *sheet;
};

/* Line style of droop lines of edges parallel to the window, or perpendicular to it. */
struct pp_curve_style pp_waldram_plot_droop_style(const struct pp_style *style,
                                                  bool across);

/* Largest side of a square (mm) at which a panel with its scales and text fits into
 * this width and height. */
double pp_waldram_plot_square(const struct pp_waldram_drawing *drawing,
                              const struct pp_waldram_panel *panel, double width,
                              double height);

/* Draws a panel of the sheet in the middle of `room`. `first` is the index of the
 * panel's first window. */
void pp_waldram_plot_draw(const struct pp_waldram_drawing *drawing,
                          const struct pp_waldram_panel *panel, int first,
                          struct pp_box room);

#endif
