/* elevation_chart.h - elevations of the walls of a site at a common scale, with the
 * vertical sky component over the area of each wall and at each window. */
#ifndef PP_CHARTS_SITE_ELEVATION_CHART_H
#define PP_CHARTS_SITE_ELEVATION_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/site_sheet.h"

/* Draws all elevations in rows on one sheet, at the largest common scale at which they
 * fit. */
enum pp_status pp_elevation_chart_draw(struct pp_canvas *canvas,
                                       const struct pp_elevation_sheet *sheet,
                                       struct pp_error *err);

#endif
