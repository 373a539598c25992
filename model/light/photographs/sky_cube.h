/* sky_cube.h - the sky as a cube of lamps: the upper half of a cube around the scene,
 * whose faces are divided into equal squares.
 *
 * Lamps are numbered from the top face on, then the sides towards +x, -x, +y and -y.
 * Faces are at the distance 1, so that each lamp has the area (2 / edge)^2.
 */
#ifndef PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_CUBE_H
#define PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_CUBE_H

#include "model/geometry/vec.h"

/* Limits of the number of lamps along an edge, which must be even. */
enum { PP_SKY_CUBE_LEAST = 2, PP_SKY_CUBE_MOST = 64 };

/* Number of lamps; edge: of them along an edge of the cube. */
int pp_sky_cube_count(int edge);

/* The lamp in unit direction u, which must be above the horizon. *solid_angle (may be
 * NULL): solid angle per area of the lamp in this direction. */
int pp_sky_cube_lamp(int edge, struct pp_vec3 u, double *solid_angle);

/* Unit direction to the point (a, b) of a lamp, a and b from 0 to 1. */
struct pp_vec3 pp_sky_cube_point(int edge, int lamp, double a, double b);

#endif
