/* convex_parts.h - divides a plane polygon into convex parts. */
#ifndef PP_MODEL_GEOMETRY_CONVEX_PARTS_H
#define PP_MODEL_GEOMETRY_CONVEX_PARTS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/polygon.h"

bool pp_convex_parts_is_convex(const struct pp_polygon *outline);

/* Triangulates a polygon that is not convex: *triangles is *count times three vertex
 * indices, freed by the caller; NULL and 0 for a convex polygon. */
enum pp_status pp_convex_parts_triangles(int (**triangles)[3], int *count,
                                         const struct pp_polygon *outline,
                                         struct pp_error *err);

#endif
