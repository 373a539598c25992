/* plan_figures.h - the numbers on a plan: values at the points and for the whole
 * working plane. */
#ifndef PP_CHARTS_ROOM_PLAN_FIGURES_H
#define PP_CHARTS_ROOM_PLAN_FIGURES_H

#include "charts/room/plan_chart.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/labels.h"

/* True if the receiver lies on the working plane, faces up and has a value. */
bool pp_plan_figures_has(const struct pp_plan_chart *chart, int receiver);

/* Writes the receiver's value in per cent, without the per cent sign. */
void pp_plan_figures_value(char *words, size_t room, const struct pp_plan_chart *chart,
                           int receiver);

/* True if the points are far enough apart on paper to write values beside them. */
bool pp_plan_figures_fit(cairo_t *cr, const struct pp_style *style,
                         const struct pp_room_plan *plan,
                         const struct pp_plan_chart *chart);

/* Position on paper of a receiver's value. */
struct pp_plan_figure {
    struct pp_box box;
    bool placed;
    bool on_lines; /* the value may cover lines, since there is no free place beside the
                    * point */
};

/* Finds places for the values at the report's receivers. Registers these places and the
 * points in `labels`. list: one entry for each receiver. Register lines beforehand;
 * place their labels afterwards. */
void pp_plan_figures_place(struct pp_plan_figure *list, cairo_t *cr,
                           const struct pp_style *style,
                           const struct pp_room_plan *plan,
                           const struct pp_plan_chart *chart, struct pp_labels *labels);

/* Draws the points of the chart's report, and the values at the places in `list`; NULL:
 * no values. */
void pp_plan_figures_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan,
                          const struct pp_plan_chart *chart,
                          const struct pp_plan_figure *list);

/* Appends minimum, median, mean and uniformity of the grid, the fractions of its points
 * that reach the levels, and the average over the plane, as one or two sentences.
 * Appends nothing if there are no such values. */
void pp_plan_figures_say(char *text, size_t room, const struct pp_plan_chart *chart);

#endif
