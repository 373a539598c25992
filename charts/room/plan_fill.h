/* plan_fill.h - fills the areas between the contours of a plan with colours or greys,
 * and draws their legend bar.
 *
 * A colour represents the same daylight factor on every sheet: the scale is
 * logarithmic, from 0.2 to 15 %. The colours become lighter from blue to yellow, so
 * that they can be distinguished in a grey copy. Lines and figures are legible on all
 * of them. Greys are evenly spaced over the areas of the sheet.
 */
#ifndef PP_CHARTS_ROOM_PLAN_FILL_H
#define PP_CHARTS_ROOM_PLAN_FILL_H

#include "charts/room/plan_chart.h"
#include "charts/room/room_plan.h"

/* Fills the plane. The caller must clip to the plane. */
void pp_plan_fill_draw(cairo_t *cr, const struct pp_room_plan *plan,
                       const struct pp_daylight_plan *daylight, enum pp_plan_fill fill);

/* Draws a bar with a field for each area, and the levels between the fields. x, y:
 * upper left corner. The height of the bar is pp_plan_fill_bar_mm. */
void pp_plan_fill_bar(cairo_t *cr, const struct pp_style *style,
                      const struct pp_daylight_plan *daylight, enum pp_plan_fill fill,
                      double x, double y, double width);
double pp_plan_fill_bar_mm(const struct pp_style *style);

#endif
