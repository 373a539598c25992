/* room_plan.h - the room seen from above and cut at its working plane, to a true scale. */
#ifndef PP_CHARTS_ROOM_ROOM_PLAN_H
#define PP_CHARTS_ROOM_ROOM_PLAN_H

#include "charts/room/plan_frame.h"
#include "charts/sheet/lettering.h"

/* Measures the room and chooses the largest common scale at which it fits into the
 * width and height, with its walls and reveals; `style` gives their line weights. */
void pp_room_plan_fit(struct pp_room_plan *plan, const struct pp_world *world,
                      const struct pp_style *style, double width_mm, double height_mm);

/* Largest common scale (1:20, 25, 50, 75, 100, 125, 200, 250, 500, 750 ... as on scale
 * rules) not larger than 1:least. */
double pp_room_plan_usual_scale(double least);

/* Width, mm, of the border outside the plane on one side: space for walls, reveals,
 * facades and balconies, and for names and dimensions if the plan is named. */
double pp_room_plan_border(const struct pp_room_plan *plan,
                           const struct pp_style *style, enum pp_plan_side side);

/* Places the plan, with its borders, in the middle of a box; `top`: at its top. */
void pp_room_plan_place(struct pp_room_plan *plan, const struct pp_style *style,
                        struct pp_box box, bool top);

/* Adds the outline of the working plane to the path. */
void pp_room_plan_path(cairo_t *cr, const struct pp_room_plan *plan);

/* Draws walls, openings, and free-standing surfaces in the room. */
void pp_room_plan_draw(cairo_t *cr, const struct pp_style *style,
                       const struct pp_room_plan *plan);

/* True if the plan has openings above the cut, drawn dashed; true if free-standing
 * surfaces in the room are cut. */
bool pp_room_plan_has_overhead(const struct pp_world *world);
bool pp_room_plan_has_inside(const struct pp_world *world);

/* Draws a scale bar of a round length, 20 to 60 mm; x, y: its upper left corner.
 * Returns its box. */
struct pp_box pp_room_plan_scale_bar(cairo_t *cr, const struct pp_style *style,
                                     double mm_per_m, double x, double y);

/* An arrow to true north within a circle about x, y; north_rad is the bearing of up. */
void pp_room_plan_north_arrow(cairo_t *cr, const struct pp_style *style,
                              double north_rad, double x, double y, double radius);

#endif
