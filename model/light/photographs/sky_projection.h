/* sky_projection.h - place of a direction in a photograph of the sky, and back.
 *
 * With t the angle from the direction of view and r the distance from the middle of the
 * picture's circle, over its radius, of a picture with the view angle 2 T:
 *
 *     equidistant          r = t / T
 *     equisolid            r = sin(t / 2) / sin(T / 2)      equal solid angles
 *     hemispherical        r = sin t / sin T, T <= 90 deg   orthographic
 *     latitude-longitude   x as the bearing, y as the altitude; all directions
 *
 * Directions are in the picture's own axes: x to its right, y to its top, z along the
 * view. A latitude-longitude picture is cylindrical about its y, with z in its middle.
 * Places run from -1 to 1 to the right and to the top of the circle, or of the whole
 * latitude-longitude picture.
 */
#ifndef PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PROJECTION_H
#define PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PROJECTION_H

#include <stdbool.h>

#include "model/geometry/vec.h"

enum pp_sky_projection {
    PP_SKY_EQUIDISTANT,
    PP_SKY_EQUISOLID,
    PP_SKY_HEMISPHERICAL,
    PP_SKY_LATITUDE_LONGITUDE,
    PP_SKY_PROJECTION_COUNT,
};

/* "equidistant", ...; ended by NULL. */
extern const char *const pp_sky_projection_names[PP_SKY_PROJECTION_COUNT + 1];

/* Largest half view angle, radians: pi, or pi/2 of a hemispherical picture. */
double pp_sky_projection_widest(enum pp_sky_projection projection);

/* The place of direction u (unit). Its radius may be above 1; directions that the
 * projection has no place for, behind a hemispherical picture, come to lie on the rim. */
void pp_sky_projection_place(enum pp_sky_projection projection, double half_angle_rad,
                             struct pp_vec3 u, double place[2]);

/* The direction of a place; false outside the circle or the picture. */
bool pp_sky_projection_direction(enum pp_sky_projection projection,
                                 double half_angle_rad, const double place[2],
                                 struct pp_vec3 *u);

#endif
