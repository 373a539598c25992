/* room_plan.h - the room seen from above and cut at its working plane, to a true scale.
 *
 * True y runs up on paper. Walls have no thickness in the model: on paper they have the
 * weight of a line, outside their inside face; windows are drawn in it as architects
 * do.
 */
#ifndef PP_CHARTS_ROOM_ROOM_PLAN_H
#define PP_CHARTS_ROOM_ROOM_PLAN_H

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"
#include "model/geometry/bounds.h"
#include "model/room/world.h"

struct pp_room_plan {
    const struct pp_world *world;
    struct pp_bounds2 extent; /* of the plane, m */
    double scale;             /* 50 for 1:50 */
    double least_scale;       /* set by the caller: not larger than that; 0: any */
    double mm_per_m;
    double x, y; /* on paper, of the extent's low x and y */
};

/* Measures the room and chooses the largest usual scale at which it fits into the
 * width and height, its walls and reveals included; `style` gives their weight. */
void pp_room_plan_fit(struct pp_room_plan *plan, const struct pp_world *world,
                      const struct pp_style *style, double width_mm, double height_mm);

/* The usual scale (1:20, 25, 50, 75, 100, 125, 200, 250, 500, 750 ... as on scale rules)
 * that is the largest not over 1:least. */
double pp_room_plan_usual_scale(double least);

/* Extent of walls and reveals beyond the plane on each side, mm. */
double pp_room_plan_border(const struct pp_room_plan *plan,
                           const struct pp_style *style);

/* Position on paper (mm) of a place in the room. */
double pp_room_plan_x(const struct pp_room_plan *plan, double x);
double pp_room_plan_y(const struct pp_room_plan *plan, double y);

/* Adds the outline of the working plane to the path. */
void pp_room_plan_path(cairo_t *cr, const struct pp_room_plan *plan);

/* Walls, openings, and surfaces that stand free in the room. */
void pp_room_plan_draw(cairo_t *cr, const struct pp_style *style,
                       const struct pp_room_plan *plan);

/* Has the plan openings above the cut, drawn dashed? Surfaces that stand in the room and
 * are cut? */
bool pp_room_plan_has_overhead(const struct pp_world *world);
bool pp_room_plan_has_inside(const struct pp_world *world);

/* A bar of a round length, 20 to 60 mm; x, y its upper left corner. Returns its box. */
struct pp_box pp_room_plan_scale_bar(cairo_t *cr, const struct pp_style *style,
                                     double mm_per_m, double x, double y);

/* An arrow to true north within a circle about x, y; north_rad is the bearing of up. */
void pp_room_plan_north_arrow(cairo_t *cr, const struct pp_style *style,
                              double north_rad, double x, double y, double radius);

#endif
