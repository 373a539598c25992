/* waldram_chart.h - Waldram's diagram: blank, or with a room's windows tinted, the
 * counted tenths of partly covered squares, and the sum below. */
#ifndef PP_CHARTS_DRAWING_BOARD_WALDRAM_CHART_H
#define PP_CHARTS_DRAWING_BOARD_WALDRAM_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/board_sheets.h"

enum pp_status pp_waldram_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_waldram_sheet *sheet,
                                     struct pp_error *err);

#endif
