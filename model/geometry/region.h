/* region.h - plane regions with holes: area, extent, and contained points, by sums over
 * their rings.
 *
 * Coordinates are pairs in any plane chosen by the caller (working plane, plane of an
 * opening). model/geometry/clipper.h makes and clips regions.
 */
#ifndef PP_MODEL_GEOMETRY_REGION_H
#define PP_MODEL_GEOMETRY_REGION_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/bounds.h"

/* A closed line; the first point is not repeated. */
struct pp_ring {
    int count;
    double (*xy)[2];
};

/* A region. Outer rings are counter-clockwise, holes clockwise, so that signed sums
 * over all rings are sums over the region. Each outer ring is followed by its holes. A
 * region without rings is empty. */
struct pp_region {
    int count;
    struct pp_ring *rings;
};

enum pp_status pp_region_copy(struct pp_region *copy, const struct pp_region *region,
                              struct pp_error *err);
void pp_region_clear(struct pp_region *region); /* the region is then empty */

/* Twice the area of the triangle a, b, c; positive for a left turn. */
static inline double pp_region_turn(const double a[2], const double b[2],
                                    const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Area of a ring; negative if clockwise. */
double pp_region_ring_area(const double (*xy)[2], int count);

/* True if a ring with these bounds is a rectangle with edges parallel to the axes, to
 * within PP_ROUNDING_M. */
bool pp_region_ring_is_upright(const double (*xy)[2], int count,
                               const struct pp_bounds2 *bounds);

double pp_region_area(const struct pp_region *region);
struct pp_bounds2 pp_region_bounds(const struct pp_region *region);
bool pp_region_contains(const struct pp_region *region, double x, double y);
/* Number of points within the region. */
int pp_region_count_inside(const struct pp_region *region, double (*points)[2],
                           int count);
/* Distance from a point to the nearest edge; INFINITY for an empty region. */
double pp_region_edge_distance(const struct pp_region *region, double x, double y);

#endif
