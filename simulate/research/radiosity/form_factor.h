/* form_factor.h - the form factor from a differential area to a polygon of uniform
 * radiosity, in closed form.
 *
 * Stokes' theorem turns the integral of cos cos'/(pi r^2) over the polygon into a sum
 * over its edges, Lambert's formula [LAM1760]. With a and b the directions to the ends
 * of an edge,
 *
 *     F = 1/(2 pi) sum angle(a, b) n . (a x b)/|a x b|                    (1)
 *
 * for the part of the polygon above the point's horizon. Obstructions are handled
 * elsewhere.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_FORM_FACTOR_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_FORM_FACTOR_H

#include "model/geometry/vec.h"

/* Greatest number of corners of a convex polygon. */
enum { PP_FORM_FACTOR_MOST = 64 };

/* Form factor from the point with normal n (unit) to a convex polygon of 3 to
 * PP_FORM_FACTOR_MOST corners, seen from either side: 0 to 1. */
double pp_form_factor(struct pp_vec3 point, struct pp_vec3 n,
                      const struct pp_vec3 *corners, int count);

#endif
