/* sky_projection.h - conversion between directions and positions in a photograph of the
 * sky.
 *
 * t is the angle from the direction of view, 2 T the view angle of the picture, and r
 * the distance from the centre of its circle, over the radius:
 *
 *     equidistant          r = t / T
 *     equisolid            r = sin(t / 2) / sin(T / 2)      equal solid angles
 *     hemispherical        r = sin t / sin T, T <= 90 deg   orthographic
 *     latitude-longitude   x as the bearing, y as the altitude; all directions
 *
 * Directions are in the picture's axes: x to its right, y to its top, z along the view.
 * A latitude-longitude picture is cylindrical about its y, with z at its centre.
 * Positions run from -1 to 1, to the right and to the top of the circle, or of the
 * whole latitude-longitude picture.
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

/* Names, "equidistant", ...; NULL-terminated. */
extern const char *const pp_sky_projection_names[PP_SKY_PROJECTION_COUNT + 1];

/* Largest half view angle (rad): pi, or pi/2 for a hemispherical picture. */
double pp_sky_projection_widest(enum pp_sky_projection projection);

/* Position of unit direction u; its radius may exceed 1. Directions without a position,
 * behind a hemispherical picture, are placed on the rim. */
void pp_sky_projection_place(enum pp_sky_projection projection, double half_angle_rad,
                             struct pp_vec3 u, double place[2]);

/* Direction of a position; false outside the circle or picture. */
bool pp_sky_projection_direction(enum pp_sky_projection projection,
                                 double half_angle_rad, const double place[2],
                                 struct pp_vec3 *u);

#endif
