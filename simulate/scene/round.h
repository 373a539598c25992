/* round.h - exact intersections of rays with spheres, cones, cylinders and rings.
 *
 * These are the round shapes of model/light/scene_description.h, which rays may meet
 * from either side. The calculation is in double precision; rays.c calls it from the
 * ray kernels.
 */
#ifndef PP_SIMULATE_SCENE_ROUND_H
#define PP_SIMULATE_SCENE_ROUND_H

#include <stdbool.h>

#include "model/geometry/bounds.h"
#include "model/geometry/vec.h"
#include "model/light/scene_description.h"

/* The first distance t, least < t < most, at which the ray from p along u meets the
 * shape; false if there is none. u may have any length; t is in units of it. */
bool pp_round_meet(const struct pp_shape *shape, struct pp_vec3 p, struct pp_vec3 u,
                   double least, double most, double *t);

/* Unit normal of the front at a point of the shape. */
struct pp_vec3 pp_round_normal(const struct pp_shape *shape, struct pp_vec3 point);

/* Tight bounding box of the shape. */
struct pp_bounds3 pp_round_bounds(const struct pp_shape *shape);

double pp_round_area(const struct pp_shape *shape);

/* A point of the shape, uniform by area for two numbers in (0, 1). */
struct pp_vec3 pp_round_point(const struct pp_shape *shape, double u, double v);

/* The point of a circle about an axis (unit) for a number in (0, 1). */
struct pp_vec3 pp_round_circle_point(struct pp_vec3 centre, struct pp_vec3 axis,
                                     double radius, double v);

/* Moves the shape by -centre. */
void pp_round_shift(struct pp_shape *shape, struct pp_vec3 centre);

#endif
