/* polygons_cross.h - tests whether two plane polygons cross each other. */
#ifndef PP_MODEL_GEOMETRY_POLYGONS_CROSS_H
#define PP_MODEL_GEOMETRY_POLYGONS_CROSS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/polygon.h"

/* Two polygons cross if both extend to both sides of the intersection line of their
 * planes, along more than 1 mm of that line. Polygons that only touch, share an edge,
 * stand on one another or lie in one plane do not cross. `where` (may be NULL): middle
 * of the first interval along which they cross. */
enum pp_status pp_polygons_cross(bool *cross, const struct pp_polygon *a,
                                 const struct pp_polygon *b, struct pp_vec3 *where,
                                 struct pp_error *err);

#endif
