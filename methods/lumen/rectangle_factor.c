/* rectangle_factor.c - sums G of rectangle_factor.h over the corners of two
 * rectangles. */
#include "methods/lumen/rectangle_factor.h"

#include <math.h>

#include "model/geometry/vec.h"

double pp_rectangle_factor_area(const struct pp_aligned_rectangle *rectangle)
{
    double area_m2 = 1.0;
    for (int axis = 0; axis < 3; axis++)
        if (axis != rectangle->axis)
            area_m2 *= rectangle->high[axis] - rectangle->low[axis];
    return area_m2;
}

/* a b atan(a / b), 0 if b is 0. */
static double arc(double a, double b)
{
    return b > 0.0 ? a * b * atan(a / b) : 0.0;
}

/* k ln x, 0 if both vanish. */
static double logarithm(double k, double x)
{
    return x > 0.0 ? k * log(x) : 0.0;
}

/* G of parallel rectangles. */
static double parallel(double u, double v, double z)
{
    return (arc(v, hypot(u, z)) + arc(u, hypot(v, z))
            - logarithm(z * z / 2.0, u * u + v * v + z * z))
           / (2.0 * PP_PI);
}

/* G of perpendicular rectangles. */
static double square(double x, double s, double t)
{
    double r2 = x * x + s * s;
    return (arc(t, sqrt(r2)) - logarithm((r2 - t * t) / 4.0, r2 + t * t))
           / (2.0 * PP_PI);
}

static double corner(const struct pp_aligned_rectangle *r, int axis, int which)
{
    return which ? r->high[axis] : r->low[axis];
}

/* Exchange area of two rectangles normal to the same axis. */
static double exchange_parallel(const struct pp_aligned_rectangle *a,
                                const struct pp_aligned_rectangle *b)
{
    int along = (a->axis + 1) % 3, across = (a->axis + 2) % 3;
    double z = fabs(a->low[a->axis] - b->low[a->axis]), sum = 0.0;
    if (z == 0.0)
        return 0.0;
    for (int i = 0; i < 16; i++) {
        int odd = (i ^ i >> 1 ^ i >> 2 ^ i >> 3) & 1;
        double u = corner(a, along, i & 1) - corner(b, along, i >> 1 & 1);
        double v = corner(a, across, i >> 2 & 1) - corner(b, across, i >> 3 & 1);
        sum += (odd ? -1.0 : 1.0) * parallel(u, v, z);
    }
    return sum;
}

/* The lower (which = 0) or upper bound of the distance of r from a plane normal to
 * `axis` at `place`. */
static double distance(const struct pp_aligned_rectangle *r, int axis, double place,
                       int which)
{
    double low = fabs(r->low[axis] - place), high = fabs(r->high[axis] - place);
    return which ? fmax(low, high) : fmin(low, high);
}

/* Exchange area of two rectangles normal to different axes. */
static double exchange_square(const struct pp_aligned_rectangle *a,
                              const struct pp_aligned_rectangle *b)
{
    int common = 3 - a->axis - b->axis;
    double sum = 0.0;
    for (int i = 0; i < 16; i++) {
        int odd = (i ^ i >> 1 ^ i >> 2 ^ i >> 3) & 1;
        double x = distance(a, b->axis, b->low[b->axis], i & 1);
        double s = distance(b, a->axis, a->low[a->axis], i >> 1 & 1);
        double t = corner(a, common, i >> 2 & 1) - corner(b, common, i >> 3 & 1);
        sum += (odd ? -1.0 : 1.0) * square(x, s, t);
    }
    return sum;
}

double pp_rectangle_factor_exchange_area(const struct pp_aligned_rectangle *a,
                                         const struct pp_aligned_rectangle *b)
{
    return a->axis == b->axis ? exchange_parallel(a, b) : exchange_square(a, b);
}
