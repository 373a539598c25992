/* perez_sky.c - coefficients from the table; normalisation by quadrature in polar
 * coordinates around the sun. */
#include "model/light/perez_sky.h"

#include <math.h>
#include <stddef.h>

#include "model/geometry/gauss.h"
#include "model/geometry/min_max.h"

/* Columns of the table: upper limit of the clearness bin, a1, and luminous
 * efficacies. */
enum { EPS_HIGH = 2, A1 = 3, DIFFUSE = 27, DIRECT = 31, COLUMNS = 39 };

static const double bins[][COLUMNS] = {
#include "tables/perez_1993_all_weather.inc"
};

static const double EPS_MOST = 12.01, D_LEAST = 0.01, D_MOST = 0.6;
static const double Z_LEAST = 3.0 * PP_RAD, Z_MOST = 90.0 * PP_RAD;

/* Clamps the value; records the limit if it is exceeded. */
static double limited(double value, double low, double high, unsigned limit,
                      unsigned *limits)
{
    /* Rounding makes the clearness of a sky without sun slightly less than 1. */
    if (value < low - 1e-9 || value > high)
        *limits |= limit;
    return pp_clamp(value, low, high);
}

static double linear(const double x[4], double Z, double D)
{
    return x[0] + x[1] * Z + D * (x[2] + x[3] * Z);
}

/* Sets a to e of (1). */
static void set_shape(struct pp_perez_sky *sky, const double *row, double Z)
{
    const double *x = row + A1;
    double D = sky->brightness;
    if (sky->bin >= 2 && sky->bin <= 5)
        D = fmax(D, 0.2);
    sky->a = linear(x, Z, D);
    sky->b = linear(x + 4, Z, D);
    if (sky->bin == 1) {
        sky->c = exp(pow(D * (x[8] + x[9] * Z), x[10])) - x[11];
        sky->d = -exp(D * (x[12] + x[13] * Z)) + x[14] + D * x[15];
    } else {
        sky->c = linear(x + 8, Z, D);
        sky->d = linear(x + 12, Z, D);
    }
    sky->e = linear(x + 16, Z, D);
    if (sky->b > 0.0) {
        sky->b = 0.0;
        sky->limits |= PP_PEREZ_B_POSITIVE;
    }
}

/* Z1 Z2 of (3). */
static double intermediate(const struct pp_perez_sky *sky, double z, double gamma)
{
    double phi = asin(fmin(z, 1.0)), sun = asin(pp_clamp(sky->sun.z, 0.0, 1.0));
    double Z1 =
        (1.35 * (sin(3.59 * phi - 0.009) + 2.31) * sin(2.6 * sun + 0.316) + phi + 4.799)
        / 2.326;
    double Z2 = exp(-0.563 * gamma * ((sun - 0.008) * (phi + 1.059) + 0.812));
    return Z1 * Z2;
}

/* (1), or the other formula of the sky, divided by N, for cosines z to the zenith and
 * to_sun to the sun. */
static double relative(const struct pp_perez_sky *sky, double z, double to_sun,
                       double gamma)
{
    if (sky->intermediate)
        return intermediate(sky, z, gamma);
    double gradation = (1.0 + sky->gradation * z) * (1.0 + sky->a * exp(sky->b / z));
    double indicatrix = 1.0 + sky->c * exp(sky->d * gamma) + sky->e * to_sun * to_sun;
    return fmax(gradation * indicatrix, 0.0);
}

/* ---- the integral of (1) times cos zeta over the sky ----
 *
 * In polar coordinates around the sun, gamma and psi: cos zeta = C + S cos psi with C =
 * cos gamma sin h and S = sin gamma cos h; h is the sun's altitude. The circle of
 * radius gamma is entirely, partly or not above the horizon. The exponential of gamma,
 * sharp at the sun, is a smooth integrand in these coordinates.
 */
enum { NODES = 20 };

struct gauss_rule {
    double at[NODES], weight[NODES];
};

static double ring_integral(const struct pp_perez_sky *sky,
                            const struct gauss_rule *rule, double gamma, double h)
{
    double C = cos(gamma) * sin(h), S = sin(gamma) * cos(h), sum = 0.0;
    if (C <= -S)
        return 0.0;
    double most = C >= S ? PP_PI : acos(-C / S);
    for (int i = 0; i < NODES; i++) {
        double z = C + S * cos(0.5 * most * (1.0 + rule->at[i]));
        if (z > 0.0)
            sum += rule->weight[i] * relative(sky, z, cos(gamma), gamma) * z;
    }
    return 2.0 * 0.5 * most * sum * sin(gamma);
}

/* Integral over gamma from low to high; a substitution removes the square roots at the
 * ends. */
static double rings_integral(const struct pp_perez_sky *sky,
                             const struct gauss_rule *rule, double low, double high,
                             double h)
{
    double sum = 0.0;
    for (int i = 0; i < NODES && high > low; i++) {
        double t = 0.5 * PP_PI * (1.0 + rule->at[i]);
        double gamma = low + (high - low) * 0.5 * (1.0 - cos(t));
        double step = (high - low) * 0.5 * sin(t) * 0.5 * PP_PI;
        sum += rule->weight[i] * step * ring_integral(sky, rule, gamma, h);
    }
    return sum;
}

static double horizontal(const struct pp_perez_sky *sky)
{
    double h = asin(pp_clamp(sky->sun.z, -1.0, 1.0)), touch = fabs(h);
    struct gauss_rule rule;
    pp_gauss_legendre(rule.at, rule.weight, NODES);
    return rings_integral(sky, &rule, 0.0, touch, h)
           + rings_integral(sky, &rule, touch, PP_PI - touch, h)
           + rings_integral(sky, &rule, PP_PI - touch, PP_PI, h);
}

/* ---- one hour ---- */

static void set_efficacy(struct pp_perez_sky *sky, const double *row, double Z,
                         const struct pp_perez_conditions *conditions)
{
    double W = exp(0.07 * conditions->dew_point_c - 0.075);
    const double *d = row + DIFFUSE, *n = row + DIRECT;
    double diffuse = d[0] + d[1] * W + d[2] * cos(Z) + d[3] * log(sky->brightness);
    double direct =
        n[0] + n[1] * W + n[2] * exp(5.73 * Z - 5.0) + n[3] * sky->brightness;
    sky->diffuse_lx = conditions->diffuse_w_m2 * fmax(diffuse, 0.0);
    sky->direct_lx = conditions->direct_w_m2 * fmax(direct, 0.0);
}

static double clamped_zenith(double sine)
{
    return pp_clamp(acos(pp_clamp(sine, -1.0, 1.0)), Z_LEAST, Z_MOST);
}

static double air_mass(double Z)
{
    return 1.0 / (cos(Z) + 0.15 * pow(93.885 - Z / PP_RAD, -1.253));
}

void pp_perez_sky_irradiances(double *direct_w_m2, double *diffuse_w_m2,
                              double clearness, double brightness, double altitude_rad,
                              double sun_distance_au)
{
    double Z = clamped_zenith(sin(altitude_rad));
    *diffuse_w_m2 = brightness * PP_PEREZ_SKY_SOLAR_W_M2
                    / (sun_distance_au * sun_distance_au * air_mass(Z));
    *direct_w_m2 = *diffuse_w_m2 * (clearness - 1.0) * (1.0 + 1.041 * Z * Z * Z);
}

struct pp_perez_sky pp_perez_sky_of(const struct pp_perez_conditions *conditions)
{
    struct pp_perez_sky sky = {.sun = conditions->sun, .clearness = 1.0, .bin = 1};
    double Ed = conditions->diffuse_w_m2, En = conditions->direct_w_m2;
    double Z = clamped_zenith(sky.sun.z), mass = air_mass(Z);
    double distance = conditions->sun_distance_au, cube = 1.041 * Z * Z * Z;
    double clearness = Ed > 0.0   ? ((Ed + En) / Ed + cube) / (1.0 + cube)
                       : En > 0.0 ? INFINITY
                                  : 1.0;
    sky.clearness = limited(clearness, 1.0, EPS_MOST, PP_PEREZ_CLEARNESS, &sky.limits);
    sky.brightness = limited(Ed * mass * distance * distance / PP_PEREZ_SKY_SOLAR_W_M2,
                             D_LEAST, D_MOST, PP_PEREZ_BRIGHTNESS, &sky.limits);
    while (sky.clearness >= bins[sky.bin - 1][EPS_HIGH])
        sky.bin++;
    const double *row = bins[sky.bin - 1];
    set_shape(&sky, row, Z);
    set_efficacy(&sky, row, Z, conditions);
    if (!(Ed > 0.0)) {
        sky.limits = En > 0.0 ? PP_PEREZ_NO_DIFFUSE : 0;
        sky.diffuse_lx = 0.0;
        return sky;
    }
    sky.N = sky.diffuse_lx / horizontal(&sky);
    return sky;
}

struct pp_perez_sky pp_perez_sky_of_standard(const struct pp_sky *standard,
                                             struct pp_vec3 sun, double direct_lx,
                                             double diffuse_lx)
{
    struct pp_perez_sky sky = {.sun = sun, .direct_lx = direct_lx};
    if (pp_sky_is_graded(standard)) {
        sky.gradation = standard->gradation;
    } else {
        /* pp_perez_sky_relative has the inverse of this. */
        double K = 1.0 - standard->c * exp(standard->d * PP_PI / 2.0);
        sky.a = standard->a;
        sky.b = standard->b;
        sky.c = standard->c / K;
        sky.d = standard->d;
        sky.e = standard->e / K;
    }
    pp_perez_sky_set_diffuse(&sky, diffuse_lx);
    return sky;
}

void pp_perez_sky_set_diffuse(struct pp_perez_sky *sky, double diffuse_lx)
{
    sky->N = sky->diffuse_lx > 0.0 ? sky->N * diffuse_lx / sky->diffuse_lx
                                   : diffuse_lx / horizontal(sky);
    sky->diffuse_lx = diffuse_lx;
}

double pp_perez_sky_luminance(const struct pp_perez_sky *sky, struct pp_vec3 u)
{
    if (!(u.z > 0.0))
        return 0.0;
    /* atan2 for the angle to the sun: acos loses half its digits near the sun. */
    double to_sun = pp_vec_dot(u, sky->sun);
    double gamma = atan2(pp_vec_length(pp_vec_cross(u, sky->sun)), to_sun);
    return sky->N * relative(sky, u.z, to_sun, gamma);
}

struct pp_sky pp_perez_sky_relative(const struct pp_perez_sky *perez)
{
    if (perez->gradation > 0.0)
        return pp_sky_graded(perez->gradation);
    /* In (1), 1 + c exp(d gamma) equals K + c (exp(d gamma) - exp(d pi/2)), the form of
     * ISO 15469. */
    double K = 1.0 + perez->c * exp(perez->d * PP_PI / 2.0);
    struct pp_sky sky = pp_sky_overcast();
    sky.kind = PP_SKY_ISO;
    sky.sun = perez->sun;
    sky.a = perez->a;
    sky.b = perez->b;
    sky.c = perez->c / K;
    sky.d = perez->d;
    sky.e = perez->e / K;
    sky.per_horizontal =
        K / (perez->N > 0.0 ? perez->diffuse_lx / perez->N : horizontal(perez));
    return sky;
}
