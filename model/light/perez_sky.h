/* perez_sky.h - all-weather sky and sun of an hour, from its irradiances.
 *
 * Luminance [PSM93], with zeta the zenith angle of a direction and gamma its angle from
 * the sun:
 *
 *     L = N (1 + a exp(b / cos zeta)) (1 + c exp(d gamma) + e cos^2 gamma)       (1)
 *
 *     a ... e = x1 + x2 Z + D (x3 + x4 Z),  but in clearness bin 1
 *     c = exp((D (c1 + c2 Z))^c3) - c4,  d = -exp(D (d1 + d2 Z)) + d3 + D d4
 *
 *     eps = ((Ed + En)/Ed + 1.041 Z^3)/(1 + 1.041 Z^3)    clearness, selects the bin
 *     D   = Ed m/E0                                       brightness
 *     m   = 1/(cos Z + 0.15 (93.885 - Z)^-1.253)         air mass, Z in degrees [KAS66]
 *
 *     Ed, En  diffuse horizontal and direct normal irradiance, W/m2
 *     E0      1367 W/m2 over the squared distance of the sun in astronomical units
 *     Z       zenith angle of the sun, in radians except in m
 *
 * Other skies have the same form: ISO 15469, and the graded skies (graded_sky.h), with
 * the factor 1 + g cos zeta in (1); g is 0 for Perez's. The intermediate sky of
 * EnergyPlus [EPLUS] has, with the altitudes phi of the direction and h of the sun
 * (radians),
 *
 *     L = N Z1 Z2                                                                (3)
 *     Z1 = (1.35 (sin(3.59 phi - 0.009) + 2.31) sin(2.6 h + 0.316) + phi + 4.799) / 2.326
 *     Z2 = exp(-0.563 gamma ((h - 0.008) (phi + 1.059) + 0.812))
 *
 * N makes the sky's horizontal illuminance equal to Ed times its luminous efficacy
 * [PISMS90], to 1e-6:
 *
 *     diffuse  da + db W + dc cos Z + dd ln D                                    (2)
 *     direct   max(0, na + nb W + nc exp(5.73 Z - 5) + nd D)
 *
 *     W = exp(0.07 Td - 0.075)    precipitable water, cm; Td dew point, degrees Celsius
 *
 * Limits, mostly those of Radiance's gendaylit: eps 1 to 12.01; D 0.01 to 0.6; Z 3
 * to 90 degrees in a ... e and (2); D at least 0.2 in a ... e of bins 2 to 5. b is at
 * most 0, since (1) is unbounded at the horizon otherwise. Negative values of (1) count
 * as 0.
 */
#ifndef PP_MODEL_LIGHT_PEREZ_SKY_H
#define PP_MODEL_LIGHT_PEREZ_SKY_H

#include <stdbool.h>

#include "model/geometry/vec.h"
#include "model/light/sky.h"

/* Weather of an hour. */
struct pp_perez_conditions {
    double direct_w_m2, diffuse_w_m2; /* normal, horizontal; 0 or more */
    struct pp_vec3 sun; /* unit vector to the sun, which may be below the horizon */
    double sun_distance_au;
    double dew_point_c;
};

/* Limits of the model that were exceeded. */
enum pp_perez_limit {
    PP_PEREZ_B_POSITIVE = 1, /* b was positive */
    PP_PEREZ_BRIGHTNESS = 2, /* D outside 0.01 to 0.6 */
    PP_PEREZ_CLEARNESS = 4,  /* eps outside 1 to 12.01 */
    PP_PEREZ_NO_DIFFUSE = 8, /* direct but no diffuse irradiance */
};

struct pp_perez_sky {
    double a, b, c, d, e;
    double gradation;  /* g: 2 for the CIE overcast sky, else 0 */
    bool intermediate; /* the luminance is (3), not (1) */
    struct pp_vec3 sun;
    bool sunless;                 /* the sky has no sun; `sun` has no effect */
    double N;                     /* cd/m2 */
    double diffuse_lx, direct_lx; /* horizontal; normal to the sun */
    double clearness, brightness;
    int bin;         /* 1 to 8 */
    unsigned limits; /* enum pp_perez_limit */
};

/* Solar irradiance outside the atmosphere at the mean distance of the sun, W/m2. */
#define PP_PEREZ_SKY_SOLAR_W_M2 1367.0

/* Diffuse irradiance (W/m2) at which the sky has this brightness D, and direct normal
 * irradiance at which it then has the clearness eps, for the sun at this altitude (rad)
 * and distance. */
void pp_perez_sky_irradiances(double *direct_w_m2, double *diffuse_w_m2,
                              double clearness, double brightness, double altitude_rad,
                              double sun_distance_au);

/* Sky of an hour. Without diffuse irradiance it is black; without any irradiance there
 * is no sun either. */
struct pp_perez_sky pp_perez_sky_of(const struct pp_perez_conditions *conditions);

/* A standard sky with these illuminances, at least one of them above 0. `standard` must
 * not be a photograph. sun: direction of the sun, also for skies that do not depend on
 * it. */
struct pp_perez_sky pp_perez_sky_of_standard(const struct pp_sky *standard,
                                             struct pp_vec3 sun, double direct_lx,
                                             double diffuse_lx);

/* Scales the sky to another diffuse illuminance (lx, 0 or more). */
void pp_perez_sky_set_diffuse(struct pp_perez_sky *sky, double diffuse_lx);

/* Luminance in direction u (unit), cd/m2; 0 below the horizon. */
double pp_perez_sky_luminance(const struct pp_perez_sky *sky, struct pp_vec3 u);

/* The sky without the sun's disc, as an argument of methods and simulations: its
 * luminances are divided by its own horizontal illuminance. */
struct pp_sky pp_perez_sky_relative(const struct pp_perez_sky *sky);

#endif
