/* bounds.h - bounding boxes, in two and three dimensions.
 *
 * An empty box has low = infinity and high = -infinity; adding points extends it.
 * Coordinates have the unit of the points.
 */
#ifndef PP_MODEL_GEOMETRY_BOUNDS_H
#define PP_MODEL_GEOMETRY_BOUNDS_H

#include <math.h>

#include "model/geometry/vec.h"

struct pp_bounds2 {
    double low[2], high[2];
};

struct pp_bounds3 {
    struct pp_vec3 low, high;
};

static inline struct pp_bounds2 pp_bounds2_empty(void)
{
    return (struct pp_bounds2){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

static inline struct pp_bounds3 pp_bounds3_empty(void)
{
    return (struct pp_bounds3){pp_vec(INFINITY, INFINITY, INFINITY),
                               pp_vec(-INFINITY, -INFINITY, -INFINITY)};
}

static inline void pp_bounds2_add(struct pp_bounds2 *bounds, double x, double y)
{
    bounds->low[0] = fmin(bounds->low[0], x);
    bounds->low[1] = fmin(bounds->low[1], y);
    bounds->high[0] = fmax(bounds->high[0], x);
    bounds->high[1] = fmax(bounds->high[1], y);
}

static inline void pp_bounds3_add(struct pp_bounds3 *bounds, struct pp_vec3 point)
{
    bounds->low = pp_vec(fmin(bounds->low.x, point.x), fmin(bounds->low.y, point.y),
                         fmin(bounds->low.z, point.z));
    bounds->high = pp_vec(fmax(bounds->high.x, point.x), fmax(bounds->high.y, point.y),
                          fmax(bounds->high.z, point.z));
}

static inline struct pp_vec3 pp_bounds3_middle(const struct pp_bounds3 *bounds)
{
    return pp_vec_scale(pp_vec_add(bounds->low, bounds->high), 0.5);
}

#endif
