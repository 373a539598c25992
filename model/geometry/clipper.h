/* clipper.h - union, intersection and difference of regions, and triangles that cover
 * them.
 *
 * Overlays use GEOS (geos_region.h).
 */
#ifndef PP_MODEL_GEOMETRY_CLIPPER_H
#define PP_MODEL_GEOMETRY_CLIPPER_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/region.h"

/* Holds a GEOS context; one for each thread. The functions below change only this
 * object. */
struct pp_clipper;
enum pp_status pp_clipper_create(struct pp_clipper **clipper, struct pp_error *err);
void pp_clipper_destroy(struct pp_clipper *clipper); /* NULL is allowed */

/* Sets the grid (greater than 0) to which unions, intersections and differences round
 * coordinates. Such snap rounding makes overlays robust against edges that almost
 * coincide. A grid of 2^-50 of the largest coordinate costs no accuracy. 0, the
 * default: no rounding. */
void pp_clipper_set_grid(struct pp_clipper *clipper, double grid);

/* Makes the region enclosed by one ring of either direction. It is empty if the ring
 * has fewer than three points or no area. PP_BAD_INPUT for a ring that touches or
 * crosses itself. */
enum pp_status pp_clipper_of_ring(struct pp_clipper *clipper, struct pp_region *region,
                                  const double (*xy)[2], int count,
                                  struct pp_error *err);
/* Makes the region enclosed by any closed line, by the even-odd rule. A part of the
 * line that is traversed in both directions, like the bridge from an outline to a hole,
 * bounds nothing. Holes may have either direction. */
enum pp_status pp_clipper_by_crossings(struct pp_clipper *clipper,
                                       struct pp_region *region, const double (*xy)[2],
                                       int count, struct pp_error *err);

/* Overlays; `result` must not be an input, and is empty on failure. */
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

/* Subtracts `minus` from the region, which is unchanged on failure. */
enum pp_status pp_clipper_take_away(struct pp_clipper *clipper,
                                    struct pp_region *region,
                                    const struct pp_region *minus,
                                    struct pp_error *err);

/* Part of a region farther than `distance` (greater than 0) from the region's edge.
 * Reflex corners stay sharp instead of being rounded. */
enum pp_status pp_clipper_inset(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *region, double distance,
                                struct pp_error *err);

/* Fills all gaps narrower than `width` (greater than 0) inside the region and between
 * its pieces; outer corners stay sharp. */
enum pp_status pp_clipper_close_gaps(struct pp_clipper *clipper,
                                     struct pp_region *result,
                                     const struct pp_region *region, double width,
                                     struct pp_error *err);

/* Triangles that cover exactly the region (constrained Delaunay), counter-clockwise.
 * The caller frees *triangles, an array of *count triangles. */
enum pp_status pp_clipper_triangulate(struct pp_clipper *clipper,
                                      double (**triangles)[3][2], int *count,
                                      const struct pp_region *region,
                                      struct pp_error *err);

/* Sets *simple to true if the ring has an area and does not touch itself. */
enum pp_status pp_clipper_ring_is_simple(bool *simple, struct pp_clipper *clipper,
                                         const double (*xy)[2], int count,
                                         struct pp_error *err);

#endif
