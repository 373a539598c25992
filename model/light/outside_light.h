/* outside_light.h - the light that comes to a building from outside: sky, ground and, in
 * pictures of one moment, the sun.
 *
 * It is not part of a room's geometry but a separate argument of all methods and
 * simulations, so that a room can be calculated under another light at no other cost.
 *
 * All of it is over Eh, the horizontal illuminance of the open sky. The ground is an
 * endless diffuse plane; where nothing shades it its exitance is its reflectance. An
 * unobstructed plane whose normal has the height n_z has the illuminance
 *
 *     E = Es + rho_ground (1 - n_z)/2
 *
 * Es from the sky (sky.h), the rest from the ground, which fills the share (1 - n_z)/2
 * of the plane's view.
 */
#ifndef PP_MODEL_LIGHT_OUTSIDE_LIGHT_H
#define PP_MODEL_LIGHT_OUTSIDE_LIGHT_H

#include "model/light/sky.h"

/* The sun; hand methods and the tracer of daylight factors leave it out. */
struct pp_outside_sun {
    struct pp_vec3 to; /* unit; above the horizon */
    double per_sky;    /* illuminance of a plane that faces it, over Eh; 0: no sun */
};

struct pp_outside_light {
    struct pp_sky sky;
    double ground_reflectance;
    struct pp_outside_sun sun;
};

/* Illuminance by the sun, unobstructed, of a plane with normal n (unit). */
double pp_outside_light_sun_on_plane(const struct pp_outside_light *light,
                                     struct pp_vec3 n);

/* Exitance of the ground under the sky alone, which is its reflectance; and with the
 * sun. */
double pp_outside_light_ground(const struct pp_outside_light *light);
double pp_outside_light_sunlit_ground(const struct pp_outside_light *light);

/* Illuminance by the ground, unobstructed, of a plane with normal n (unit). */
double pp_outside_light_ground_on_plane(const struct pp_outside_light *light,
                                        struct pp_vec3 n);

/* Exitance of a diffuse face with normal n (unit) that stands free under the open sky,
 * as skylines do by convention: rho E. */
double pp_outside_light_exitance(const struct pp_outside_light *light,
                                 double reflectance, struct pp_vec3 n);

#endif
