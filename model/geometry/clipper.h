/* clipper.h - regions out of rings, their union, difference and intersection, and the
 * triangles that cover them.
 *
 * Overlays are GEOS's (geos_region.h).
 */
#ifndef PP_MODEL_GEOMETRY_CLIPPER_H
#define PP_MODEL_GEOMETRY_CLIPPER_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/region.h"

/* Holds a GEOS context: one for each thread. The functions below change
 * nothing else. */
struct pp_clipper;
enum pp_status pp_clipper_create(struct pp_clipper **clipper, struct pp_error *err);
void pp_clipper_destroy(struct pp_clipper *clipper); /* NULL is allowed */

/* Makes unions, intersections and differences round coordinates to multiples of `grid`
 * (greater than 0). Such snap rounding makes them robust against edges that almost
 * coincide. 2^-50 of the largest coordinate is fine enough to cost no accuracy. 0, the
 * default: no rounding. */
void pp_clipper_set_grid(struct pp_clipper *clipper, double grid);

/* The figure of one ring, in either direction; fewer than three points or no area give
 * the empty figure. A ring that crosses itself is an error. */
enum pp_status pp_clipper_of_ring(struct pp_clipper *clipper, struct pp_region *region,
                                  const double (*xy)[2], int count,
                                  struct pp_error *err);
/* The figure of any closed line, by crossings: a point is in it where a ray from there
 * crosses the line an odd number of times. Where the line runs there and back, as along
 * the bridge from a rim to a hole, it bounds nothing; a hole may run either way
 * round. */
enum pp_status pp_clipper_by_crossings(struct pp_clipper *clipper,
                                       struct pp_region *region, const double (*xy)[2],
                                       int count, struct pp_error *err);

/* result may not be an input; it is empty on failure. */
enum pp_status pp_clipper_union(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *parts, int count,
                                struct pp_error *err);
enum pp_status pp_clipper_intersection(struct pp_clipper *clipper,
                                       struct pp_region *result,
                                       const struct pp_region *a,
                                       const struct pp_region *b, struct pp_error *err);
enum pp_status pp_clipper_difference(struct pp_clipper *clipper,
                                     struct pp_region *result,
                                     const struct pp_region *a,
                                     const struct pp_region *minus,
                                     struct pp_error *err);

/* Subtracts a region from another, which is unchanged on failure. */
enum pp_status pp_clipper_take_away(struct pp_clipper *clipper,
                                    struct pp_region *region,
                                    const struct pp_region *minus,
                                    struct pp_error *err);

/* The part of a region that is farther than `distance` (greater than 0) from its edge;
 * inner corners of the region, which a circle would round, stay sharp. */
enum pp_status pp_clipper_inset(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *region, double distance,
                                struct pp_error *err);

/* The region with all gaps filled, in it and between its pieces, that are narrower than
 * `width` (greater than 0); its outer corners stay sharp. */
enum pp_status pp_clipper_close_gaps(struct pp_clipper *clipper,
                                     struct pp_region *result,
                                     const struct pp_region *region, double width,
                                     struct pp_error *err);

/* Triangles that cover the region and nothing else (constrained Delaunay), each
 * counter-clockwise: *triangles is *count arrays of three points, to be freed. */
enum pp_status pp_clipper_triangulate(struct pp_clipper *clipper,
                                      double (**triangles)[3][2], int *count,
                                      const struct pp_region *region,
                                      struct pp_error *err);

/* Tests whether the ring has an area and nowhere meets itself. */
enum pp_status pp_clipper_ring_is_simple(bool *simple, struct pp_clipper *clipper,
                                         const double (*xy)[2], int count,
                                         struct pp_error *err);

#endif
