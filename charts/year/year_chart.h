/* year_chart.h - a room's daylight through a year on one sheet: a map of days and
 * hours, plans of autonomies and sun hours if the points are a grid, the share of the
 * occupied hours that reach an illuminance, and autonomies against the distance from the
 * main window wall.
 *
 * Colours run from dark to light, so that they keep their order in black and white.
 */
#ifndef PP_CHARTS_YEAR_YEAR_CHART_H
#define PP_CHARTS_YEAR_YEAR_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/annual_sheet.h"

enum pp_status pp_year_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_annual_sheet *sheet,
                                  struct pp_error *err);

#endif
