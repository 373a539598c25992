/* outside_light.h - outdoor light: sky, ground and, in pictures for a given moment, the
 * sun.
 *
 * Outdoor light is a separate argument of all methods and simulations, not a part of a
 * room's geometry, so that a room can be calculated for another light without
 * rebuilding it.
 *
 * All values are relative to Eh, the horizontal illuminance of the open sky. The ground
 * is an infinite diffuse plane; its exitance is its reflectance if nothing shades it.
 * An unobstructed plane whose normal has the z component n_z has the illuminance
 *
 *     E = Es + rho_ground (1 - n_z)/2
 *
 * Es is from the sky (sky.h), the rest from the ground, which fills the share (1 -
 * n_z)/2 of the plane's view.
 */
#ifndef PP_MODEL_LIGHT_OUTSIDE_LIGHT_H
#define PP_MODEL_LIGHT_OUTSIDE_LIGHT_H

#include "model/base/error.h"
#include "model/light/sky.h"

/* The sun; hand methods and traced daylight factors do not include it. */
struct pp_outside_sun {
    struct pp_vec3 to; /* unit; above the horizon */
    double per_sky;    /* illuminance of a plane normal to the sun, over Eh; 0: no
                        * sun */
};

/* Illuminances of planes from one sky, over Eh: the integral over a sky with a sun takes
 * long, but the openings of a room face only a few directions. */
struct pp_outside_plane {
    struct pp_vec3 normal;
    double sky;
};

struct pp_outside_planes {
    int count, capacity;
    struct pp_outside_plane *list;
};

struct pp_outside_light {
    struct pp_sky sky;
    double ground_reflectance;
    struct pp_outside_sun sun;
    const struct pp_outside_planes *planes; /* calculated for this sky; not owned; NULL:
                                             * none */
};

/* Adds a plane with unit normal n, unless it is in the list. The caller clears the
 * list. */
enum pp_status pp_outside_light_add_plane(struct pp_outside_planes *planes,
                                          const struct pp_sky *sky, struct pp_vec3 n,
                                          struct pp_error *err);
void pp_outside_light_clear_planes(struct pp_outside_planes *planes);

/* pp_sky_on_plane for the light's sky: from its planes, or else calculated. */
double pp_outside_light_sky_on_plane(const struct pp_outside_light *light,
                                     struct pp_vec3 n);

/* Illuminance from the unobstructed sun on a plane with unit normal n. */
double pp_outside_light_sun_on_plane(const struct pp_outside_light *light,
                                     struct pp_vec3 n);

/* Exitance of the ground over Eh. The first function is for ground lit by the sky only,
 * so that the exitance equals the reflectance; the second is for ground lit by sky and
 * sun. */
double pp_outside_light_ground(const struct pp_outside_light *light);
double pp_outside_light_sunlit_ground(const struct pp_outside_light *light);

/* Illuminance from the unobstructed ground on a plane with unit normal n. */
double pp_outside_light_ground_on_plane(const struct pp_outside_light *light,
                                        struct pp_vec3 n);

/* Exitance rho E of a diffuse, unobstructed face with unit normal n under the open sky,
 * as assumed for skylines. */
double pp_outside_light_exitance(const struct pp_outside_light *light,
                                 double reflectance, struct pp_vec3 n);

#endif
