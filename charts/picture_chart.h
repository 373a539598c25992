/* picture_chart.h - a picture on a sheet with its scale, contour lines and marks. */
#ifndef PP_CHARTS_PICTURE_CHART_H
#define PP_CHARTS_PICTURE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/picture_sheet.h"

enum pp_status pp_picture_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_picture_sheet *sheet,
                                     struct pp_error *err);

/* True if a landscape sheet suits the picture better. */
bool pp_picture_chart_landscape(const struct pp_picture_sheet *sheet);

#endif
