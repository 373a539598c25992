/* plan_names.h - names, dimensions and section marks on a plan.
 *
 * Names of windows and walls are outside the walls. Overall dimensions are outside the
 * names, below and on the left of the plan. The marks "A" at both ends of a section
 * point in the direction of view. Rooflights are named inside their outlines. A name
 * that would cover another name is moved along its wall, or else omitted.
 */
#ifndef PP_CHARTS_ROOM_PLAN_NAMES_H
#define PP_CHARTS_ROOM_PLAN_NAMES_H

#include "charts/room/plan_frame.h"
#include "charts/sheet/labels.h"

/* Width of the strip for names and dimensions on a side of the plan, mm. */
double pp_plan_names_mm(const struct pp_style *style, enum pp_plan_side side);

/* Ends of a section on the plan, m. The view is to the left of the direction from the
 * first end to the second. */
struct pp_plan_mark {
    double from[2], to[2];
};

/* Draws names and dimensions, and the section mark unless `mark` is NULL. */
void pp_plan_names_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan,
                        const struct pp_plan_mark *mark);

/* Registers the places of names inside the plan, and the fittings cut by the working
 * plane, so that labels drawn earlier avoid them. */
void pp_plan_names_note(struct pp_labels *labels, cairo_t *cr,
                        const struct pp_style *style, const struct pp_room_plan *plan);

/* Name of a wall, or "wall 5" if its name is the number 5. */
enum { PP_PLAN_NAMES_WALL = 48 };
void pp_plan_names_wall(char words[PP_PLAN_NAMES_WALL], const char *name);

/* Draws a dimension line from x0, y0 to x1, y1, horizontal or vertical on paper. Its
 * length in metres is written on white in the middle, or beside the line if the line is
 * too short. */
void pp_plan_names_dimension(cairo_t *cr, const struct pp_style *style, double x0,
                             double y0, double x1, double y1, double metres,
                             bool with_unit);

#endif
