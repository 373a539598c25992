/* triangle.h - areas and points of triangles. */
#ifndef PP_SIMULATE_SAMPLING_TRIANGLE_H
#define PP_SIMULATE_SAMPLING_TRIANGLE_H

#include <math.h>
#include <stdbool.h>

#include "model/geometry/vec.h"

static inline double pp_triangle_area(const struct pp_vec3 corners[3])
{
    return pp_vec_length(pp_vec_cross(pp_vec_sub(corners[1], corners[0]),
                                      pp_vec_sub(corners[2], corners[0])))
           / 2.0;
}

/* A point of the triangle, uniform by area for two numbers in (0, 1). */
static inline struct pp_vec3 pp_triangle_point(const struct pp_vec3 corners[3],
                                               double u, double v)
{
    double root = sqrt(u);
    return pp_vec_add(pp_vec_scale(corners[0], 1.0 - root),
                      pp_vec_add(pp_vec_scale(corners[1], root * (1.0 - v)),
                                 pp_vec_scale(corners[2], root * v)));
}

/* A point of one of several triangles, uniform by area. area_m2: total area of the
 * triangles. */
static inline struct pp_vec3 pp_triangle_point_of(const struct pp_vec3 (*triangles)[3],
                                                  int count, double area_m2, double u,
                                                  double v)
{
    double left = u * area_m2, own = pp_triangle_area(triangles[0]);
    int i = 0;
    while (left > own && i + 1 < count) {
        left -= own;
        own = pp_triangle_area(triangles[++i]);
    }
    return pp_triangle_point(triangles[i], fmin(left / own, 1.0), v);
}

/* True if a point of the triangle's plane is in the triangle, with a tolerance for
 * rounding. */
static inline bool pp_triangle_has(const struct pp_vec3 t[3], struct pp_vec3 p)
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        const struct pp_vec3 corner[3] = {t[k], t[(k + 1) % 3], p};
        sum += pp_triangle_area(corner);
    }
    return sum < pp_triangle_area(t) * (1.0 + 1e-9);
}

#endif
