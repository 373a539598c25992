/* graded_sky.h - skies whose luminance rises evenly with the sine of the altitude:
 *
 *     L(gamma) = Lz (1 + b sin gamma) / (1 + b)                             (1)
 *
 * The gradation b is 2 for the CIE overcast sky [MS42], whose zenith is three times as
 * bright as its horizon, and 0 for the uniform sky. Over the hemisphere, with (1) times
 * sin gamma,
 *
 *     Eh = pi Lz (1 + 2b/3) / (1 + b)                                       (2)
 *
 * which is 7 pi Lz / 9 for the overcast sky and pi Lz for the uniform one. Everything
 * below is over Eh, and is (1) integrated in closed form with, by (1) and (2),
 *
 *     p = 3 / (2 (3 + 2b))       half of pi L(0)/Eh: 3/14 overcast, 1/2 uniform
 *     q = 2b / ((3 + 2b) pi)     4/(7 pi) overcast, 0 uniform
 *
 * Angles in radians.
 */
#ifndef PP_MODEL_LIGHT_GRADED_SKY_H
#define PP_MODEL_LIGHT_GRADED_SKY_H

/* b of the two skies. Numerals, since texts for other programs contain them. */
#define PP_GRADED_SKY_OVERCAST 2
#define PP_GRADED_SKY_UNIFORM 0

/* Luminance over that of the zenith, by (1). */
double pp_graded_sky_luminance(double b, double sin_altitude);

/* Luminance of the zenith, 1/sr: 9/(7 pi) overcast, 1/pi uniform. */
double pp_graded_sky_zenith(double b);

/* pi times the luminance of the horizon: 3/7 overcast, 1 uniform. */
double pp_graded_sky_horizon(double b);

/* Illuminance of a plane whose normal is beta from the zenith, 0 to pi:
 * p (1 + cos beta) + q (sin beta + (pi - beta) cos beta). */
double pp_graded_sky_on_plane(double b, double beta_rad);

/* Illuminance of a vertical plane from above an infinitely long skyline parallel to it,
 * with the section angle alpha, 0 to pi/2: p (1 - sin alpha) + q cos^2 alpha. */
double pp_graded_sky_over_skyline(double b, double alpha_rad);

/* Skyline angle alpha for an illuminance; 0 if it exceeds that of the open sky, pi/2 if
 * it is negative. */
double pp_graded_sky_skyline(double b, double share);

/* Horizontal illuminance from the sky below a plane that rises at the angle gamma from
 * a horizontal line through the point, 0 to pi: p (1 - cos gamma) + q (gamma - sin
 * gamma cos gamma). */
double pp_graded_sky_below_plane(double b, double gamma_rad);

/* Horizontal illuminance from the sky below the altitude gamma, per radian of azimuth,
 * 0 to pi/2: p sin^2 gamma / pi + q sin^3 gamma / 2. */
double pp_graded_sky_below_altitude(double b, double sin_altitude);

/* Illuminance of a vertical plane from the sky below the altitude gamma, per unit of
 * the sine of the azimuth from the plane's normal, 0 to pi/2: p (gamma + sin gamma cos
 * gamma) / pi + q (1 - cos^3 gamma) / 2. */
double pp_graded_sky_upright_below_altitude(double b, double altitude_rad);

#endif
