/* plan_names.h - names, dimensions and section marks on a plan.
 *
 * Names of windows and walls are outside the walls. Overall width and depth are beyond
 * the names, below and on the left of the plan. The marks "A" at both ends of a section
 * point in the direction of view. Rooflights are named inside their outline. A name
 * that would cover another is moved along its wall, or else left out.
 */
#ifndef PP_CHARTS_ROOM_PLAN_NAMES_H
#define PP_CHARTS_ROOM_PLAN_NAMES_H

#include "charts/room/plan_frame.h"
#include "charts/sheet/labels.h"

/* Space that the names need on a side of the plan, mm. */
double pp_plan_names_mm(const struct pp_style *style, enum pp_plan_side side);

/* Ends of a section on the plan, m. The view is to the left of the direction from the
 * first end to the second. */
struct pp_plan_mark {
    double from[2], to[2];
};

/* Draws names and dimensions; mark NULL: no section mark. */
void pp_plan_names_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan,
                        const struct pp_plan_mark *mark);

/* Registers the places of names inside the plan, and the fittings that the working plane
 * cuts, for labels drawn before them. */
void pp_plan_names_note(struct pp_labels *labels, cairo_t *cr,
                        const struct pp_style *style, const struct pp_room_plan *plan);

/* Words for a wall: its name, or "wall 5" if that is a number. */
enum { PP_PLAN_NAMES_WALL = 48 };
void pp_plan_names_wall(char words[PP_PLAN_NAMES_WALL], const char *name);

/* Draws a dimension line from x0, y0 to x1, y1, horizontal or vertical on paper, with
 * its length in metres on white in the middle, or beside the line if that is too
 * short. */
void pp_plan_names_dimension(cairo_t *cr, const struct pp_style *style, double x0,
                             double y0, double x1, double y1, double metres,
                             bool with_unit);

#endif
