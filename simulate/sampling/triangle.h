/* triangle.h - areas and points of triangles. */
#ifndef PP_SIMULATE_SAMPLING_TRIANGLE_H
#define PP_SIMULATE_SAMPLING_TRIANGLE_H

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

#endif
