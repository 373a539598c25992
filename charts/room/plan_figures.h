/* plan_figures.h - the numbers on a plan: values at the points and for the whole
 * working plane. */
#ifndef PP_CHARTS_ROOM_PLAN_FIGURES_H
#define PP_CHARTS_ROOM_PLAN_FIGURES_H

#include "charts/room/plan_chart.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/labels.h"

/* True if the receiver faces up on the working plane and has a value. */
bool pp_plan_figures_has(const struct pp_plan_chart *chart, int receiver);

/* Writes the receiver's value in per cent, without the sign. */
void pp_plan_figures_value(char *words, size_t room, const struct pp_plan_chart *chart,
                           int receiver);

/* True if the points are far enough apart on paper for values beside them. */
bool pp_plan_figures_fit(cairo_t *cr, const struct pp_style *style,
                         const struct pp_room_plan *plan,
                         const struct pp_plan_chart *chart);

/* Draws the points and, with `values`, writes the values of those on the working plane
 * beside them. A value for which there is no other place covers lines. */
void pp_plan_figures_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan,
                          const struct pp_plan_chart *chart, struct pp_labels *labels,
                          bool values);

/* Minimum, median, mean, uniformity and shares over the levels, as a sentence or two;
 * empty if there are none. */
void pp_plan_figures_say(char *text, size_t room, const struct pp_plan_chart *chart);

#endif
