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
 * which is 7 pi Lz / 9 for the overcast sky and pi Lz for the uniform one. All values
 * below are relative to Eh. The illuminances are integrals of (1) in closed form, with
 *
 *     p = 3 / (2 (3 + 2b))       half of pi L(0)/Eh: 3/14 overcast, 1/2 uniform
 *     q = 2b / ((3 + 2b) pi)     4/(7 pi) overcast, 0 uniform
 *
 * Angles in radians.
 */
#ifndef PP_MODEL_LIGHT_GRADED_SKY_H
#define PP_MODEL_LIGHT_GRADED_SKY_H

/* b of the two skies. Macros, since texts for other programs contain the numbers. */
#define PP_GRADED_SKY_OVERCAST 2
#define PP_GRADED_SKY_UNIFORM 0

/* Luminance divided by the luminance of the zenith, by (1). */
double pp_graded_sky_luminance(double b, double sin_altitude);

/* Luminance of the zenith, 1/sr: 9/(7 pi) overcast, 1/pi uniform. */
double pp_graded_sky_zenith(double b);

/* pi times the luminance of the horizon: 3/7 overcast, 1 uniform. */
double pp_graded_sky_horizon(double b);

/* Illuminance of a plane whose normal is at the angle beta (0 to pi) from the zenith:
 * p (1 + cos beta) + q (sin beta + (pi - beta) cos beta). */
double pp_graded_sky_on_plane(double b, double beta_rad);

/* Illuminance of a vertical plane from the sky above an infinitely long skyline that is
 * parallel to the plane: p (1 - sin alpha) + q cos^2 alpha. alpha: altitude of the
 * skyline in section, 0 to pi/2. */
double pp_graded_sky_over_skyline(double b, double alpha_rad);

/* Inverse of pp_graded_sky_over_skyline: alpha for the illuminance `share`; 0 if
 * `share` exceeds the illuminance from the open sky, pi/2 if `share` is negative. */
double pp_graded_sky_skyline(double b, double share);

/* Horizontal illuminance from the sky below a plane that rises at the angle gamma (0 to
 * pi) from a horizontal line through the point: p (1 - cos gamma) + q (gamma - sin
 * gamma cos gamma). */
double pp_graded_sky_below_plane(double b, double gamma_rad);

/* Horizontal illuminance from the sky below the altitude gamma (0 to pi/2), per radian
 * of azimuth: p sin^2 gamma / pi + q sin^3 gamma / 2. */
double pp_graded_sky_below_altitude(double b, double sin_altitude);

/* Illuminance of a vertical plane from the sky below the altitude gamma (0 to pi/2),
 * per unit of the sine of the azimuth from the plane's normal: p (gamma + sin gamma cos
 * gamma) / pi + q (1 - cos^3 gamma) / 2. */
double pp_graded_sky_upright_below_altitude(double b, double altitude_rad);

#endif
