/* plan_table.h - table of the values at the points of a plan, for points too close
 * together for values beside them. For points of a grid, each row has one y, from the
 * top of the plan down, and each column has one x. Other points are listed. */
#ifndef PP_CHARTS_ROOM_PLAN_TABLE_H
#define PP_CHARTS_ROOM_PLAN_TABLE_H

#include "charts/room/plan_chart.h"

/* Draws the table from the upper left corner of `box`. If `drawn` is false, only
 * measures. Returns the box of the table. A list uses the full height of `box`. */
struct pp_box pp_plan_table_draw(cairo_t *cr, const struct pp_style *style,
                                 const struct pp_plan_chart *chart, struct pp_box box,
                                 bool drawn);

#endif
