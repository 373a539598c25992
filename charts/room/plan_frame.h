/* plan_frame.h - the extent of a plan, and positions on paper. The y axis points up on
 * paper. Walls have no thickness in the model; they are drawn as a thick line outside
 * their inside face. Windows are drawn in this line as in architects' plans. */
#ifndef PP_CHARTS_ROOM_PLAN_FRAME_H
#define PP_CHARTS_ROOM_PLAN_FRAME_H

#include "charts/sheet/style.h"
#include "model/geometry/bounds.h"
#include "model/room/world.h"

/* Sides of a plan on paper. */
enum pp_plan_side { PP_PLAN_LEFT, PP_PLAN_RIGHT, PP_PLAN_ABOVE, PP_PLAN_BELOW };

struct pp_room_plan {
    const struct pp_world *world;
    struct pp_bounds2 extent; /* extent of the plane, m */
    double scale;             /* denominator of the scale: 50 for 1:50 */
    double least_scale;       /* largest permitted scale, as a denominator, set by the
                               * caller; 0: no limit */
    bool named;               /* set by the caller: names and dimensions are drawn in
                               * the border (plan_names.h) */
    double mm_per_m;
    double x, y; /* position on paper (mm) of the low corner of `extent` */
};

/* Width of the border without names and dimensions, mm. */
double pp_plan_frame_walls_mm(const struct pp_room_plan *plan,
                              const struct pp_style *style, enum pp_plan_side side);

/* Thickness of the line that represents a wall, mm. */
double pp_plan_frame_wall_mm(const struct pp_style *style);

/* Ends on paper of a window, door or wall, left and right as seen from inside, and the
 * unit vector out of the room. The outline must be vertical. */
void pp_plan_frame_ends(const struct pp_room_plan *plan,
                        const struct pp_polygon *outline, double ends[2][2],
                        double out[2]);

/* True if the opening is in a wall at the edge of the plane, not in a roof or in a
 * monitor inside the plan. */
bool pp_plan_frame_is_in_wall(const struct pp_world *world,
                              const struct pp_opening *opening);

/* Position on paper (mm) of a point in the room (m). */
double pp_plan_frame_x(const struct pp_room_plan *plan, double x);
double pp_plan_frame_y(const struct pp_room_plan *plan, double y);

/* True if the surface is part of a balcony, overhang, fin or shelf of one of the room's
 * windows. */
bool pp_plan_frame_is_shade(const struct pp_surface *surface);

#endif
