/* contour.h - level curves of a function over a plane region.
 *
 * The function is sampled on a triangle mesh (field.h), whose triangles are halved
 * (longest edge first [RIV84]) near the requested levels. The curve is followed from
 * triangle to triangle (level_crossing.h) to within the field's tolerance. A closed
 * curve that encloses no node of the mesh is not found. Nodes are at most 1/24 of the
 * region's diagonal apart, three quarters of that distance near a level, and a quarter
 * of it along the region's edge.
 *
 * The function need not be smooth: at a step the curve follows the jump.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_CONTOUR_H
#define PP_MODEL_GEOMETRY_CONTOUR_CONTOUR_H

#include "model/base/error.h"
#include "model/geometry/contour/field.h"
#include "model/geometry/curve.h"

/* Adds the curves of one level to `curves` (initialised with zeros), with higher values
 * on their left. A value counts as higher only if it is greater than the level. Open
 * curves end on the region's edge. */
enum pp_status pp_contour_curves(struct pp_field *field, double level,
                                 struct pp_curve_list *curves, struct pp_error *err);

/* Adds the outlines of the area where the function is not higher than the level:
 * closed, outer ones counter-clockwise, holes clockwise. */
enum pp_status pp_contour_below(struct pp_field *field, double level,
                                struct pp_curve_list *outlines, struct pp_error *err);

#endif
