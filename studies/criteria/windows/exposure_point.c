/* exposure_point.c - see exposure_point.h. */
#include "studies/criteria/windows/exposure_point.h"

#include <math.h>

/* Extent of the opening along its own axes, from its first corner: left, right, low,
 * high. */
static void extent_of_opening(double extent[4], const struct pp_opening *opening)
{
    const struct pp_polygon *outline = &opening->inner;
    extent[0] = extent[2] = INFINITY;
    extent[1] = extent[3] = -INFINITY;
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 off = pp_vec_sub(outline->vertices[i], outline->vertices[0]);
        double x = pp_vec_dot(off, opening->along), y = pp_vec_dot(off, opening->up);
        extent[0] = fmin(extent[0], x);
        extent[1] = fmax(extent[1], x);
        extent[2] = fmin(extent[2], y);
        extent[3] = fmax(extent[3], y);
    }
}

/* Point midway across, at y along the opening's upward axis from its first corner. */
static struct pp_vec3 middle_at(const struct pp_opening *opening,
                                const double extent[4], double y)
{
    struct pp_vec3 middle = pp_vec_along(opening->inner.vertices[0],
                                         0.5 * (extent[0] + extent[1]), opening->along);
    return pp_vec_along(middle, y, opening->up);
}

struct pp_vec3 pp_exposure_point_centre(const struct pp_opening *opening)
{
    double extent[4];
    extent_of_opening(extent, opening);
    return middle_at(opening, extent, 0.5 * (extent[2] + extent[3]));
}

struct pp_vec3 pp_exposure_point(const struct pp_opening *opening, double above_floor_m,
                                 double above_sill_m)
{
    double extent[4];
    extent_of_opening(extent, opening);
    double y = 0.5 * (extent[2] + extent[3]);
    if (fabs(opening->slope_rad - PP_PI / 2.0) < 1.0 * PP_RAD) {
        double floor = above_floor_m - opening->inner.vertices[0].z;
        y = fmin(extent[3], fmax(extent[2] + above_sill_m, floor));
    }
    return middle_at(opening, extent, y);
}
