/* plan_outside.h - parts of a plan above and below the cut: facades, balconies and
 * other shading of windows, crowns of trees, and outlines of furniture. */
#ifndef PP_CHARTS_ROOM_PLAN_OUTSIDE_H
#define PP_CHARTS_ROOM_PLAN_OUTSIDE_H

#include "charts/room/plan_frame.h"

/* Draws objects above the cut with dashed lines and objects below the cut with thin
 * solid lines. Facades are drawn where the cut meets them. */
void pp_plan_outside_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan);

#endif
