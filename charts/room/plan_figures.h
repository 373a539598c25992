/* plan_figures.h - the numbers on a plan: values at the points and for the whole
 * working plane. */
#ifndef PP_CHARTS_ROOM_PLAN_FIGURES_H
#define PP_CHARTS_ROOM_PLAN_FIGURES_H

#include "charts/room/plan_chart.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/labels.h"

/* Writes the figure at each receiver of the report that faces up on the working plane,
 * beside a mark, if there is space between the lines and the other figures; else draws
 * the mark alone. */
void pp_plan_figures_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan,
                          const struct pp_plan_chart *chart, struct pp_labels *labels);

/* Minimum, median, mean, uniformity and shares over the levels, as a sentence or two;
 * empty if there are none. */
void pp_plan_figures_say(char *text, size_t room, const struct pp_plan_chart *chart);

#endif
