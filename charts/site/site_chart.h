/* site_chart.h - the plan of a site to a true scale: its buildings, existing and
 * proposed, its rooms, and for each window its vertical sky component, by
 * storey. */
#ifndef PP_CHARTS_SITE_SITE_CHART_H
#define PP_CHARTS_SITE_SITE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/site_sheet.h"

/* Cuts off shapes that are farther from the rooms than one and a half times the rooms'
 * extent plus 30 m. */
enum pp_status pp_site_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_site_sheet *sheet,
                                  struct pp_error *err);

#endif
