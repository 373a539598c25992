/* skylight_indicator_chart.h - the skylight indicator: marks of equal value on a plan
 * round a window, blank to lay on a site plan, or with the obstructions of a room's
 * window. */
#ifndef PP_CHARTS_DRAWING_BOARD_SKYLIGHT_INDICATOR_CHART_H
#define PP_CHARTS_DRAWING_BOARD_SKYLIGHT_INDICATOR_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/skylight_indicator_sheet.h"

/* The length of one unit of distance over height is a multiple of 5 mm if the sheet is
 * large enough, and of 1 mm on small ones; it is stated at the foot. */
enum pp_status pp_skylight_indicator_chart_draw(
    struct pp_canvas *canvas, const struct pp_skylight_indicator_sheet *sheet,
    struct pp_error *err);

#endif
