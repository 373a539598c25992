/* site_chart.h - plan of a site, to scale: existing and proposed buildings, rooms, and
 * the vertical sky component of each window, by storey. */
#ifndef PP_CHARTS_SITE_SITE_CHART_H
#define PP_CHARTS_SITE_SITE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/site_sheet.h"

/* Draws the plan. Shapes are cut off at a distance from the rooms: 1.5 times the extent
 * of the rooms, but at least 30 m. If the sheet has a plot, the plan shows only the
 * extent of the rooms and the plot. */
enum pp_status pp_site_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_site_sheet *sheet,
                                  struct pp_error *err);

#endif
