/* region.h - plane figures with holes, their union, difference and intersection.
 *
 * Overlays are GEOS's, which no other file knows. Coordinates are plain pairs in
 * whatever plane the caller means (the working plane, an opening's own plane).
 */
#ifndef PP_MODEL_GEOMETRY_REGION_H
#define PP_MODEL_GEOMETRY_REGION_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/bounds.h"

/* A closed line without its first point repeated. */
struct pp_ring {
    int count;
    double (*xy)[2];
};

/* Outer rings run counter-clockwise, holes clockwise, so that a signed sum over all
 * rings is the figure's; an outer ring is followed by its own holes. No rings: the
 * empty figure. */
struct pp_region {
    int count;
    struct pp_ring *rings;
};

/* Holds a GEOS context: one for each thread. The functions below change nothing
 * else. */
struct pp_clipper;
enum pp_status pp_region_clipper_create(struct pp_clipper **clipper,
                                        struct pp_error *err);
void pp_region_clipper_destroy(struct pp_clipper *clipper); /* NULL is allowed */

/* From now on unions, intersections and differences round coordinates to multiples of
 * `grid` (greater than 0), which makes them proof against edges that all but coincide
 * (snap rounding). 2^-50 of the largest coordinate is fine enough to cost no accuracy.
 * 0, as at first: no rounding. */
void pp_region_clipper_set_grid(struct pp_clipper *clipper, double grid);

/* The figure of one ring, in either direction; fewer than three points or no area give
 * the empty figure. A ring that crosses itself is an error. */
enum pp_status pp_region_of_ring(struct pp_clipper *clipper, struct pp_region *region,
                                 const double (*xy)[2], int count,
                                 struct pp_error *err);
/* The figure of any closed line, by crossings: a point is in it where a ray from there
 * crosses the line an odd number of times. Where the line runs there and back, as along
 * the bridge from a rim to a hole, it bounds nothing; a hole may run either way
 * round. */
enum pp_status pp_region_by_crossings(struct pp_clipper *clipper,
                                      struct pp_region *region, const double (*xy)[2],
                                      int count, struct pp_error *err);
enum pp_status pp_region_copy(struct pp_region *copy, const struct pp_region *region,
                              struct pp_error *err);
void pp_region_clear(struct pp_region *region); /* leaves the empty figure */

/* result may not be an input; it is empty on failure. */
enum pp_status pp_region_union(struct pp_clipper *clipper, struct pp_region *result,
                               const struct pp_region *parts, int count,
                               struct pp_error *err);
enum pp_status pp_region_intersection(struct pp_clipper *clipper,
                                      struct pp_region *result,
                                      const struct pp_region *a,
                                      const struct pp_region *b, struct pp_error *err);
enum pp_status pp_region_difference(struct pp_clipper *clipper,
                                    struct pp_region *result, const struct pp_region *a,
                                    const struct pp_region *minus,
                                    struct pp_error *err);

/* Triangles that cover the region and nothing else (constrained Delaunay), each
 * counter-clockwise: *triangles is *count arrays of three points, to be freed. */
enum pp_status pp_region_triangulate(struct pp_clipper *clipper,
                                     double (**triangles)[3][2], int *count,
                                     const struct pp_region *region,
                                     struct pp_error *err);

/* Has the ring an area, and does it nowhere meet itself? */
bool pp_region_ring_is_simple(struct pp_clipper *clipper, const double (*xy)[2],
                              int count);

/* Twice the area of the triangle a, b, c: above 0 where it turns to the left. */
static inline double pp_region_turn(const double a[2], const double b[2],
                                    const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Area of a ring, negative where it runs clockwise. */
double pp_region_ring_area(const double (*xy)[2], int count);

double pp_region_area(const struct pp_region *region);
struct pp_bounds2 pp_region_bounds(const struct pp_region *region);
bool pp_region_contains(const struct pp_region *region, double x, double y);
/* Distance from a point to the nearest edge; INFINITY for the empty figure. */
double pp_region_edge_distance(const struct pp_region *region, double x, double y);

#endif
