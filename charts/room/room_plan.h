/* room_plan.h - the room seen from above and cut at its working plane, drawn to
 * scale. */
#ifndef PP_CHARTS_ROOM_ROOM_PLAN_H
#define PP_CHARTS_ROOM_ROOM_PLAN_H

#include "charts/room/plan_frame.h"
#include "charts/sheet/lettering.h"

/* Measures the room and chooses the largest usual scale at which it fits into the width
 * and height, together with its walls and reveals. style: gives the line weights. */
void pp_room_plan_fit(struct pp_room_plan *plan, const struct pp_world *world,
                      const struct pp_style *style, double width_mm, double height_mm);

/* Denominator of the largest usual scale (1:1, 2, 5, 10, 20, 25, 50, 75, 100, 125, 200,
 * 250, 500, 750 ... as on scale rules) that is not larger than 1:least. */
double pp_room_plan_usual_scale(double least);

/* Width (mm) of the border outside the plane on one side: space for walls, reveals,
 * facades and balconies, and for names and dimensions if the plan has them. */
double pp_room_plan_border(const struct pp_room_plan *plan,
                           const struct pp_style *style, enum pp_plan_side side);

/* Places the plan, with its borders, in the middle of a box, or, if `top` is set, at
 * the top of the box. */
void pp_room_plan_place(struct pp_room_plan *plan, const struct pp_style *style,
                        struct pp_box box, bool top);

/* Adds the outline of the working plane to the path. */
void pp_room_plan_path(cairo_t *cr, const struct pp_room_plan *plan);

/* Draws walls, doors, openings, free-standing surfaces in the room, and the parts in
 * plan_outside.h. */
void pp_room_plan_draw(cairo_t *cr, const struct pp_style *style,
                       const struct pp_room_plan *plan);

/* The first function is true if the plan has openings above the cut, drawn dashed. The
 * second is true if the cut meets free-standing surfaces in the room. */
bool pp_room_plan_has_overhead(const struct pp_world *world);
bool pp_room_plan_has_inside(const struct pp_world *world);

/* Draws a scale bar of a round length, 24 to 60 mm on A4 paper. x, y: upper left
 * corner. Returns its box. */
struct pp_box pp_room_plan_scale_bar(cairo_t *cr, const struct pp_style *style,
                                     double mm_per_m, double x, double y);

/* Draws an arrow to true north within a circle around x, y. north_rad: bearing of the
 * upward direction on paper. */
void pp_room_plan_north_arrow(cairo_t *cr, const struct pp_style *style,
                              double north_rad, double x, double y, double radius);

#endif
