/* region.h - plane figures with holes, their union, difference and intersection.
 *
 * The only door to GEOS. Coordinates are plain pairs; what plane they lie in is the
 * caller's affair (the working plane, an opening's own plane).
 */
#ifndef PP_MODEL_GEOMETRY_REGION_H
#define PP_MODEL_GEOMETRY_REGION_H

#include <stdbool.h>

#include "model/base/error.h"

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

/* A GEOS context. One a thread; the functions below change nothing else. */
struct pp_clipper;
enum pp_status pp_region_clipper_create(struct pp_clipper **clipper,
                                        struct pp_error *err);
void pp_region_clipper_destroy(struct pp_clipper *clipper); /* NULL is allowed */

/* From now on unions, intersections and differences round coordinates to multiples of
 * `grid` (greater than 0), which makes them proof against edges that all but coincide
 * (snap rounding). 2^-50 of the largest
 * coordinate is fine enough to cost no accuracy. 0,
 * as at first: no rounding. */
void pp_region_clipper_set_grid(struct pp_clipper *clipper, double grid);

/* The figure of one ring, in either direction; fewer than three points or no area give
 * the empty figure. A ring that crosses itself is an error. */
enum pp_status pp_region_of_ring(struct pp_clipper *clipper, struct pp_region *region,
                                 const double (*xy)[2], int count,
                                 struct pp_error *err);
/* The figure of any closed line, by crossings: a point is in it where a ray from there
 * crosses the line an odd number of times. What the line runs there and back, such as
 * the seam between a rim and a hole, bounds nothing; a hole may run either way round. */
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

/* Does the ring meet itself or have no area? */
bool pp_region_ring_is_simple(struct pp_clipper *clipper, const double (*xy)[2],
                              int count);

double pp_region_area(const struct pp_region *region);
bool pp_region_contains(const struct pp_region *region, double x, double y);
/* Distance from a point to the nearest edge; INFINITY for the empty figure. */
double pp_region_edge_distance(const struct pp_region *region, double x, double y);

#endif
