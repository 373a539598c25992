/* skylight_indicator_chart.h - the skylight indicator: marks of equal worth on a plan
 * about a window, blank to lay on a site plan, or with the obstructions of a room's
 * window. */
#ifndef PP_CHARTS_DRAWING_BOARD_SKYLIGHT_INDICATOR_CHART_H
#define PP_CHARTS_DRAWING_BOARD_SKYLIGHT_INDICATOR_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/skylight_indicator_sheet.h"

/* The drawing's radius is a whole number of 5 mm for each unit of distance over height
 * where the sheet has the room, and of 1 mm on small ones; it stands at the foot. */
enum pp_status pp_skylight_indicator_chart_draw(
    struct pp_canvas *canvas, const struct pp_skylight_indicator_sheet *sheet,
    struct pp_error *err);

#endif
