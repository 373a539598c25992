/* en17037_chart.h - the four parts of EN 17037 on one sheet. The sheet shows the level
 * that the room reaches in each part, plans of the illuminance by both methods for
 * daylight provision, a table of figures and targets, and the assumptions. */
#ifndef PP_CHARTS_YEAR_EN17037_CHART_H
#define PP_CHARTS_YEAR_EN17037_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/en17037_sheet.h"

enum pp_status pp_en17037_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_en17037_sheet *sheet,
                                     struct pp_error *err);

#endif
