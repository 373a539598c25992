/* sky.h - luminance of the sky, for methods and simulation: graded skies (overcast,
 * uniform: graded_sky.h), ISO 15469 skies, and photographs (sky_picture.h).
 *
 * A sky is normalised by its own unobstructed horizontal illuminance Eh, so that the
 * illuminance of a receiver is a daylight factor without further division:
 *
 *     graded     L = Lz (1 + b sin altitude)/(1 + b)                    [MS42]
 *                overcast b = 2, uniform b = 0
 *     ISO 15469  L = Lz f(chi) phi(Z) / (f(Zs) phi(0)),                 [ISO15469]
 *                f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi
 *                phi(Z) = 1 + a exp(b / cos Z),  phi(pi/2) = 1
 *                with Eh by adaptive quadrature to 1e-10
 *
 * The sun's disc is not included.
 */
#ifndef PP_MODEL_LIGHT_SKY_H
#define PP_MODEL_LIGHT_SKY_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

enum pp_sky_kind { PP_SKY_OVERCAST, PP_SKY_UNIFORM, PP_SKY_ISO, PP_SKY_PICTURE };

struct pp_sky_picture;

struct pp_sky {
    enum pp_sky_kind kind;
    int iso; /* PP_SKY_ISO: 1 to 15, or 0 for a Perez sky in this form; else 0 */
    double gradation;      /* b of graded_sky.h. Skies that are not graded have the
                           * value of the overcast sky, used to convert
                           * obstructions to angles and for estimates */
    struct pp_vec3 sun;    /* unit, towards the sun; the zenith if there is none */
    double a, b, c, d, e;  /* ISO 15469, else 0 */
    double per_horizontal; /* L / Eh (1/sr) for a relative luminance of 1 */
    double fade; /* Lg / Lz of a faded sky, used only for luminances in simulations;
                  * 0: not faded */
    const struct pp_sky_picture *picture; /* PP_SKY_PICTURE only; not owned */
    double north[2]; /* picture: cosine and sine of the bearing of +y */
};

struct pp_sky pp_sky_overcast(void);
struct pp_sky pp_sky_uniform(void);

/* Overcast sky of Radiance's gensky over a ground of that reflectance (0 to 1): Lg is
 * the reflectance times Eh over pi. */
struct pp_sky pp_sky_faded(double ground_reflectance);

/* Graded sky with any b; its kind is uniform for b = 0, else overcast. Only tests use
 * other values of b than those of the overcast and the uniform sky. */
struct pp_sky pp_sky_graded(double b);

/* Sky by the formula of ISO 15469 with parameters a to e and the sun in unit direction
 * sun, scaled by its horizontal illuminance. */
struct pp_sky pp_sky_of_parameters(const double parameters[5], struct pp_vec3 sun);

/* ISO 15469 sky of type 1 to 15 with the sun in unit direction sun, not below the
 * horizon; types without a sun ignore it. PP_BAD_INPUT for another type, or a sun below
 * the horizon. */
enum pp_status pp_sky_iso(struct pp_sky *sky, int type, struct pp_vec3 sun,
                          struct pp_error *err);

/* True if the luminance of ISO type `type` depends on the position of the sun. */
bool pp_sky_iso_has_sun(int type);

/* Sky of a photograph, in axes whose +y has the bearing north_rad. The picture must
 * outlive the sky. */
struct pp_sky pp_sky_of_picture(const struct pp_sky_picture *picture, double north_rad);

/* True if the luminance depends only on the sine of the altitude, linearly. */
static inline bool pp_sky_is_graded(const struct pp_sky *sky)
{
    return sky->kind == PP_SKY_OVERCAST || sky->kind == PP_SKY_UNIFORM;
}

/* Converts direction u from the sky's axes to x east and y north. */
static inline struct pp_vec3 pp_sky_to_north(const struct pp_sky *sky, struct pp_vec3 u)
{
    return pp_vec(u.x * sky->north[0] + u.y * sky->north[1],
                  u.y * sky->north[0] - u.x * sky->north[1], u.z);
}

/* The inverse of pp_sky_to_north. */
static inline struct pp_vec3 pp_sky_from_north(const struct pp_sky *sky,
                                               struct pp_vec3 u)
{
    return pp_vec(u.x * sky->north[0] - u.y * sky->north[1],
                  u.y * sky->north[0] + u.x * sky->north[1], u.z);
}

/* True if the luminance depends on azimuth. */
bool pp_sky_has_azimuth(const struct pp_sky *sky);

/* Luminance in unit direction u over the horizontal illuminance, 1/sr; 0 below the
 * horizon. */
double pp_sky_luminance(const struct pp_sky *sky, struct pp_vec3 u);

/* Angle (rad) of a photograph's pixels; 0 for other skies, which are smooth. */
double pp_sky_grain(const struct pp_sky *sky);

/* Illuminance from the unobstructed sky, as a fraction of Eh, of a plane with unit
 * normal n of any tilt. Closed form for graded skies, else to 1e-9; to 1e-4 for a
 * photograph. */
double pp_sky_on_plane(const struct pp_sky *sky, struct pp_vec3 n);

/* "overcast", "uniform", "iso-1" ... "iso-15", "picture"; "perez" (perez_sky.h). */
const char *pp_sky_name(const struct pp_sky *sky);

#endif
