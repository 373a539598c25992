/* year_chart.h - daylight in a room through a year on one sheet: a map of days and
 * hours, plans of daylight autonomy, useful illuminance and sun hours if the points are
 * a grid, and two panels of curves. One shows the fraction of occupied hours in which
 * each illuminance is reached. The other shows daylight autonomy and useful illuminance
 * against distance from the main window wall.
 *
 * Colours range from dark to light, so that their order is also visible in grey.
 */
#ifndef PP_CHARTS_YEAR_YEAR_CHART_H
#define PP_CHARTS_YEAR_YEAR_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/annual_sheet.h"

enum pp_status pp_year_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_annual_sheet *sheet,
                                  struct pp_error *err);

#endif
