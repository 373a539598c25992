/* slope_rectangles.h - an opening that is not vertical, and the obstructions seen
 * through it, as rectangles in its plane, for protractors and tables.
 *
 * Lengths are divided by the distance d from the point to the plane, and measured from
 * the foot of the perpendicular: b up the slope, x along the horizontal edges, to the
 * right as seen from inside. All edges of a horizontal opening are level: its section
 * is perpendicular to the longer ones. The visible part above the point's horizon is
 * the rectangle itself; any other shape is read as a rectangle of equal area, with the
 * same centre and proportions. An obstruction is the rectangle of equal area with the
 * jambs of the hidden part, and with the hidden part's edge nearer to the zenith; this
 * rectangle lies within that of the opening.
 */
#ifndef PP_METHODS_VIEW_SLOPE_RECTANGLES_H
#define PP_METHODS_VIEW_SLOPE_RECTANGLES_H

#include "model/geometry/angle.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

/* A slope that differs by less than this angle from 0, a right angle or a published
 * slope counts as equal to that slope. */
#define PP_SLOPE_RECTANGLES_TOLERANCE_RAD 1e-3

struct pp_slope_rectangle {
    double left, right, low, high;
    bool hidden;   /* true: an obstruction; false: the whole visible part */
    double factor; /* luminance factor of the obstruction; 1 for the sky */
};

struct pp_slope_rectangles {
    double slope_rad;
    int count; /* 0: the point does not see the opening; else the whole is first */
    struct pp_slope_rectangle *list;
};

/* Slope of an opening (rad): 0 horizontal, pi/2 vertical, more than pi/2 if its outer
 * side faces down. */
double pp_slope_rectangles_slope(const struct pp_opening *opening);

/* The direction of x of an opening of that slope. */
struct pp_vec3 pp_slope_rectangles_along(const struct pp_opening *opening,
                                         double slope_rad);

/* Altitude (rad) in section of an edge at b, more than pi/2 where the plane leans over
 * the point; 0 below the horizon. */
double pp_slope_rectangles_altitude(double b, struct pp_angle slope);

/* Rectangles as seen from the point. On success the caller clears *rectangles. */
enum pp_status pp_slope_rectangles_init(struct pp_slope_rectangles *rectangles,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 point, struct pp_error *err);
void pp_slope_rectangles_clear(struct pp_slope_rectangles *rectangles);

#endif
