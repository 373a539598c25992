/* polygons_cross.h - do two plane polygons go through each other? */
#ifndef PP_MODEL_GEOMETRY_POLYGONS_CROSS_H
#define PP_MODEL_GEOMETRY_POLYGONS_CROSS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/polygon.h"

/* Two polygons cross where, along a stretch of the line in which their planes meet and
 * for more than a millimetre, both go on to either side. Polygons that only touch,
 * share an edge, stand on one another or lie in one plane don't. `where` (may be NULL)
 * is the middle of the first such stretch. */
enum pp_status pp_polygons_cross(bool *cross, const struct pp_polygon *a,
                                 const struct pp_polygon *b, struct pp_vec3 *where,
                                 struct pp_error *err);

#endif
