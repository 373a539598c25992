/* geos_region.h - rings and regions to GEOS and back.
 *
 * A region goes to GEOS as a multipolygon and comes back from it ring by ring, each
 * outer ring followed by its own holes. Parts of lower dimension (points and lines
 * where two figures only touch) are dropped. The only file that includes GEOS's header.
 * Inside model/geometry/ only.
 */
#ifndef PP_MODEL_GEOMETRY_GEOS_REGION_H
#define PP_MODEL_GEOMETRY_GEOS_REGION_H

#include <geos_c.h>

#include "model/base/error.h"
#include "model/geometry/region.h"

/* A closed ring; NULL on failure. count is at least 3. */
GEOSGeometry *pp_geos_region_ring(GEOSContextHandle_t geos, const double (*xy)[2],
                                  int count);

/* All of `count` regions as one collection of polygons; NULL on failure. */
GEOSGeometry *pp_geos_region_polygons(GEOSContextHandle_t geos,
                                      const struct pp_region *regions, int count);

/* Turns shape into *region and destroys it. Rings less than two steps of the grid (0: none)
 * wide are rounding and left out. */
enum pp_status pp_geos_region_from(struct pp_region *region, GEOSContextHandle_t geos,
                                   GEOSGeometry *shape, double grid,
                                   struct pp_error *err);

#endif
