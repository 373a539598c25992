/* brs_table_chart.h - the BRS simplified daylight table, typeset like the original. For
 * a point of a room, it also shows the places to be read, and the sum. */
#ifndef PP_CHARTS_DRAWING_BOARD_BRS_TABLE_CHART_H
#define PP_CHARTS_DRAWING_BOARD_BRS_TABLE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/brs_sheet.h"

/* Draws the table. A cross between cell centres marks an interpolated reading. */
enum pp_status pp_brs_table_chart_draw(struct pp_canvas *canvas,
                                       const struct pp_brs_sheet *sheet,
                                       struct pp_error *err);

#endif
