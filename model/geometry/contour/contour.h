/* contour.h - true level curves of a function over a plane figure.
 *
 * The figure is covered with triangles that keep to its edges; the function is
 * evaluated at their corners and triangles are halved (longest edge first, [RIV84])
 * near the levels asked for. Where an edge has its ends on different sides of a level,
 * the place of the level on it is found by a bracketed secant; between two such places
 * the curve is followed across the triangle, points being put in until it strays from
 * its chords by no more than the tolerance. Features smaller than a triangle that no
 * corner falls on are missed: corners are at most 1/24 of the figure's diagonal apart,
 * and three quarters of that near a level, a
 * quarter along the figure's edge.
 *
 * The function is evaluated inside the figure and on its edge, nowhere else, and never
 * twice at a corner. It need not be smooth: of a step, the curve is where it jumps.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_CONTOUR_H
#define PP_MODEL_GEOMETRY_CONTOUR_CONTOUR_H

#include "model/geometry/curve.h"
#include "model/base/error.h"
#include "model/geometry/region.h"

/* *value at (x, y); must be finite. A failure ends the work and is handed on. */
typedef enum pp_status (*pp_field_function)(void *context, double x, double y,
                                            double *value, struct pp_error *err);

/* A function sampled over a figure. */
struct pp_field;

/* Evaluates at the corners of the first triangles. Lengths are in the figure's unit;
 * tolerance > 0. region is copied as far as needed; context is not owned and must live
 * as long as the field. The empty figure is refused. */
enum pp_status pp_field_create(struct pp_field **field, const struct pp_region *region,
                               pp_field_function function, void *context,
                               double tolerance, struct pp_error *err);
void pp_field_destroy(struct pp_field *field); /* NULL is allowed */

/* Lowest and highest value at any corner so far, and where. */
void pp_field_range(const struct pp_field *field, double *lowest, double lowest_xy[2],
                    double *highest, double highest_xy[2]);

/* How often the function was evaluated. */
long pp_field_evaluations(const struct pp_field *field);

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
