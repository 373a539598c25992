/* plan_table.h - table of the values at the points of a plan, for points too close for
 * values beside them. Points of a grid make a table of rows of equal y, from the top of
 * the plan down, and columns of equal x; others make a list. */
#ifndef PP_CHARTS_ROOM_PLAN_TABLE_H
#define PP_CHARTS_ROOM_PLAN_TABLE_H

#include "charts/room/plan_chart.h"

/* Draws the table from the upper left corner of the box, and returns the box that it
 * fills; `drawn` false: only measures it. A list uses the height of the box. */
struct pp_box pp_plan_table_draw(cairo_t *cr, const struct pp_style *style,
                                 const struct pp_plan_chart *chart, struct pp_box box,
                                 bool drawn);

#endif
