/* plan_fill.h - the areas between the contours of a plan in colours or greys, and their
 * legend bar.
 *
 * A colour means the same daylight factor on every sheet: the scale is logarithmic,
 * from 0.2 to 15 %. The colours go from blue to yellow in order of their lightness, so
 * that they can be distinguished in a grey copy; they are light enough for lines and
 * figures on them. Greys are spread evenly over the areas of the sheet.
 */
#ifndef PP_CHARTS_ROOM_PLAN_FILL_H
#define PP_CHARTS_ROOM_PLAN_FILL_H

#include "charts/room/plan_chart.h"
#include "charts/room/room_plan.h"

/* Fills the plane; to be clipped by the caller. */
void pp_plan_fill_draw(cairo_t *cr, const struct pp_room_plan *plan,
                       const struct pp_daylight_plan *daylight, enum pp_plan_fill fill);

/* Draws the bar with a field for each area and the levels between them, from x, y on;
 * its height is pp_plan_fill_bar_mm. */
void pp_plan_fill_bar(cairo_t *cr, const struct pp_style *style,
                      const struct pp_daylight_plan *daylight, enum pp_plan_fill fill,
                      double x, double y, double width);
double pp_plan_fill_bar_mm(const struct pp_style *style);

#endif
