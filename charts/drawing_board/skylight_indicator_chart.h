/* skylight_indicator_chart.h - the skylight indicator: marks of equal value on a plan
 * around a window. The sheet is blank, to be laid on a site plan, or shows the
 * obstructions of a room's window. */
#ifndef PP_CHARTS_DRAWING_BOARD_SKYLIGHT_INDICATOR_CHART_H
#define PP_CHARTS_DRAWING_BOARD_SKYLIGHT_INDICATOR_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/skylight_indicator_sheet.h"

/* Draws the indicator. The unit of length is a distance equal to the height. On paper
 * the unit is a multiple of 5 mm, or of 1 mm on small sheets, and is stated below the
 * diagram. */
enum pp_status pp_skylight_indicator_chart_draw(
    struct pp_canvas *canvas, const struct pp_skylight_indicator_sheet *sheet,
    struct pp_error *err);

#endif
