/* projection.h - a plane as seen from a point: the frame in which directions are drawn.
 *
 * The view is a central projection from the eye on a plane at distance_m, in which
 * straight edges stay straight. A direction is a point (x, y) of the plane: metres
 * along `along` and `up` from the foot of the perpendicular through the eye. Points of
 * space are (X, Y, Z) in the same axes with the eye at the origin, Z along `toward`.
 */
#ifndef PP_MODEL_GEOMETRY_PROJECTION_H
#define PP_MODEL_GEOMETRY_PROJECTION_H

#include "model/geometry/vec.h"

struct pp_projection {
    struct pp_vec3 eye;
    struct pp_vec3 along, up, toward; /* unit; along x up = -toward */
    double distance_m;                /* greater than 0 */
};

/* Converts a point of space to the axes of the view. */
static inline struct pp_vec3 pp_projection_point(const struct pp_projection *view,
                                                 struct pp_vec3 point)
{
    struct pp_vec3 v = pp_vec_sub(point, view->eye);
    return pp_vec(pp_vec_dot(v, view->along), pp_vec_dot(v, view->up),
                  pp_vec_dot(v, view->toward));
}

/* Converts a direction to the axes of the view. */
static inline struct pp_vec3 pp_projection_direction(const struct pp_projection *view,
                                                     struct pp_vec3 v)
{
    return pp_vec(pp_vec_dot(v, view->along), pp_vec_dot(v, view->up),
                  pp_vec_dot(v, view->toward));
}

/* Converts a vector from the axes of the view to those of the room. */
static inline struct pp_vec3 pp_projection_to_room(const struct pp_projection *view,
                                                   struct pp_vec3 own)
{
    struct pp_vec3 v = pp_vec_scale(view->along, own.x);
    return pp_vec_along(pp_vec_along(v, own.y, view->up), own.z, view->toward);
}

#endif
