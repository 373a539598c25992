/* slats_chart.h - transmittance of a blind by profile angle: curves for light that
 * passes straight through and for light scattered upwards and downwards, a table, and a
 * section of the slats. */
#ifndef PP_CHARTS_SLATS_CHART_H
#define PP_CHARTS_SLATS_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/slat_sheet.h"

void pp_slats_chart_draw(struct pp_canvas *canvas, const struct pp_slat_sheet *sheet);

#endif
