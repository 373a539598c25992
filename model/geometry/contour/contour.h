/* contour.h - true level curves of a function over a plane figure.
 *
 * The function is sampled over a mesh of triangles (field.h), which are halved (longest
 * edge first [RIV84]) near the requested levels; the curve is followed from triangle to
 * triangle (level_crossing.h) to within the field's tolerance. A closed curve without a
 * corner inside is not found: corners are at most 1/24 of the figure's diagonal apart,
 * three quarters of that near a level, and a quarter along the figure's edge.
 *
 * The function need not be smooth: the curve of a step is where it jumps.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_CONTOUR_H
#define PP_MODEL_GEOMETRY_CONTOUR_CONTOUR_H

#include "model/base/error.h"
#include "model/geometry/contour/field.h"
#include "model/geometry/curve.h"

/* Adds the curves of one level to curves (zeroed at first), each with higher values on
 * its left; "higher" is greater than the level, all else is lower. Ends of open curves
 * lie on the figure's edge. */
enum pp_status pp_contour_curves(struct pp_field *field, double level,
                                 struct pp_curve_list *curves, struct pp_error *err);

/* Adds the outlines of the part of the figure where the function is not higher than the
 * level: closed, outer ones counter-clockwise, holes clockwise. */
enum pp_status pp_contour_below(struct pp_field *field, double level,
                                struct pp_curve_list *outlines, struct pp_error *err);

#endif
