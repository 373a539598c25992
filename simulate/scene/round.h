/* round.h - spheres, cones, cylinders and rings: where a ray meets them, exactly.
 *
 * They are the round shapes of model/light/scene_description.h, met from either side. Pure
 * geometry in double precision; rays.c hands it to the ray kernels.
 */
#ifndef PP_SIMULATE_SCENE_ROUND_H
#define PP_SIMULATE_SCENE_ROUND_H

#include <stdbool.h>

#include "model/light/scene_description.h"
#include "model/geometry/vec.h"

/* The first distance t with least < t < most at which the ray from p along u (any
 * length, t in units of it) meets the shape; false if it does not. */
bool pp_round_meet(const struct pp_shape *shape, struct pp_vec3 p, struct pp_vec3 u,
                   double least, double most, double *t);

/* The unit normal of its front at a point of the shape. */
struct pp_vec3 pp_round_normal(const struct pp_shape *shape, struct pp_vec3 point);

/* The box that it fits into, tight but for a cone's ends. */
void pp_round_box(const struct pp_shape *shape, struct pp_vec3 *low,
                  struct pp_vec3 *high);

double pp_round_area(const struct pp_shape *shape);

/* A point of it, uniform by area for two numbers in (0, 1). */
struct pp_vec3 pp_round_point(const struct pp_shape *shape, double u, double v);

/* Moves it by -centre. */
void pp_round_shift(struct pp_shape *shape, struct pp_vec3 centre);

#endif
