/* plan_names.h - names, dimensions and section marks on a plan.
 *
 * Outside the walls are the names of windows and walls; beyond them, below and on the
 * left, the overall width and depth. The marks "A" at both ends of a section point the
 * way that it is seen. Rooflights are named inside their outline. A name that would
 * cover another is moved along its wall, or else left out.
 */
#ifndef PP_CHARTS_ROOM_PLAN_NAMES_H
#define PP_CHARTS_ROOM_PLAN_NAMES_H

#include "charts/room/room_plan.h"
#include "charts/sheet/labels.h"

/* Space that the names need on a side of the plan, mm. */
double pp_plan_names_mm(const struct pp_style *style, enum pp_plan_side side);

/* Ends of a section on the plan, m; seen towards the left of the way from the first to
 * the second. */
struct pp_plan_mark {
    double from[2], to[2];
};

/* Draws names and dimensions; mark NULL: no section mark. */
void pp_plan_names_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan,
                        const struct pp_plan_mark *mark);

/* Notes the places of names inside the plan, for labels drawn before them. */
void pp_plan_names_note(struct pp_labels *labels, cairo_t *cr,
                        const struct pp_style *style, const struct pp_room_plan *plan);

/* Draws a dimension line from x0, y0 to x1, y1, level or upright, with its length in
 * metres on white in the middle, or beside a line that is too short for it. */
void pp_plan_names_dimension(cairo_t *cr, const struct pp_style *style, double x0,
                             double y0, double x1, double y1, double metres,
                             bool with_unit);

#endif
