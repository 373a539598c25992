/* geos_region.h - converts rings and regions to GEOS and back.
 *
 * A region becomes a multipolygon in GEOS. In the result each outer ring is followed by
 * its holes. Parts of lower dimension (points and lines where two regions only touch)
 * are dropped. Only this file includes the header of GEOS. Inside model/geometry/ only.
 */
#ifndef PP_MODEL_GEOMETRY_GEOS_REGION_H
#define PP_MODEL_GEOMETRY_GEOS_REGION_H

#include <geos_c.h>

#include "model/base/error.h"
#include "model/geometry/region.h"

/* Converts a closed ring of 3 or more points; NULL on failure. */
GEOSGeometry *pp_geos_region_ring(GEOSContextHandle_t geos, const double (*xy)[2],
                                  int count);

/* Converts `count` regions to one collection of polygons; NULL on failure. */
GEOSGeometry *pp_geos_region_polygons(GEOSContextHandle_t geos,
                                      const struct pp_region *regions, int count);

/* Converts shape to *region and destroys it. Rings narrower than two grid steps (0: no
 * grid) are rounding errors and are left out. */
enum pp_status pp_geos_region_from(struct pp_region *region, GEOSContextHandle_t geos,
                                   GEOSGeometry *shape, double grid,
                                   struct pp_error *err);

#endif
