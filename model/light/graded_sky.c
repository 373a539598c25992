/* graded_sky.c - see graded_sky.h. */
#include "model/light/graded_sky.h"

#include <math.h>

#include "model/geometry/vec.h"

/* p and q of graded_sky.h. */
static double even_part(double b)
{
    return 3.0 / (2.0 * (3.0 + 2.0 * b));
}

static double graded_part(double b)
{
    return 2.0 * b / ((3.0 + 2.0 * b) * PP_PI);
}

double pp_graded_sky_luminance(double b, double sin_altitude)
{
    return (1.0 + b * sin_altitude) / (1.0 + b);
}

double pp_graded_sky_zenith(double b)
{
    return 3.0 * (1.0 + b) / ((3.0 + 2.0 * b) * PP_PI);
}

double pp_graded_sky_horizon(double b)
{
    return 3.0 / (3.0 + 2.0 * b);
}

double pp_graded_sky_on_plane(double b, double beta_rad)
{
    double c = cos(beta_rad);
    return even_part(b) * (1.0 + c)
           + graded_part(b) * (sin(beta_rad) + (PP_PI - beta_rad) * c);
}

double pp_graded_sky_over_skyline(double b, double alpha_rad)
{
    double s = sin(alpha_rad);
    return even_part(b) * (1.0 - s) + graded_part(b) * (1.0 - s * s);
}

double pp_graded_sky_skyline(double b, double share)
{
    /* Solves q s^2 + p s - r = 0 for s = sin alpha in [0, 1], r = p + q - share, in a
     * form that is valid for q = 0. */
    double p = even_part(b), q = graded_part(b), r = fmax(p + q - share, 0.0);
    double s = 2.0 * r / (p + sqrt(p * p + 4.0 * q * r));
    return asin(fmin(s, 1.0));
}

double pp_graded_sky_below_plane(double b, double gamma_rad)
{
    double s = sin(gamma_rad), c = cos(gamma_rad);
    return even_part(b) * (1.0 - c) + graded_part(b) * (gamma_rad - s * c);
}

double pp_graded_sky_below_altitude(double b, double sin_altitude)
{
    double s = sin_altitude;
    return s * s * (3.0 + 2.0 * b * s) / (2.0 * (3.0 + 2.0 * b) * PP_PI);
}

double pp_graded_sky_upright_below_altitude(double b, double altitude_rad)
{
    double s = sin(altitude_rad), c = cos(altitude_rad);
    return even_part(b) * (altitude_rad + s * c) / PP_PI
           + graded_part(b) * (1.0 - c * c * c) / 2.0;
}
