/* sky.c - see sky.h. */
#include "model/light/sky.h"

#include <cubature.h>
#include <math.h>
#include <stddef.h>

#include "model/light/graded_sky.h"
#include "model/light/photographs/sky_picture.h"

static const double iso_parameters[][6] = {
#include "tables/iso15469.inc"
};

enum { ISO_TYPES = sizeof iso_parameters / sizeof iso_parameters[0] };

struct pp_sky pp_sky_graded(double b)
{
    return (struct pp_sky){.kind = b == PP_GRADED_SKY_UNIFORM ? PP_SKY_UNIFORM
                                                              : PP_SKY_OVERCAST,
                           .gradation = b,
                           .sun = {0.0, 0.0, 1.0},
                           .per_horizontal = pp_graded_sky_zenith(b)};
}

struct pp_sky pp_sky_overcast(void)
{
    return pp_sky_graded(PP_GRADED_SKY_OVERCAST);
}

struct pp_sky pp_sky_uniform(void)
{
    return pp_sky_graded(PP_GRADED_SKY_UNIFORM);
}

bool pp_sky_iso_has_sun(int type)
{
    return type >= 1 && type <= ISO_TYPES && iso_parameters[type - 1][3] != 0.0;
}

struct pp_sky pp_sky_of_picture(const struct pp_sky_picture *picture, double north_rad)
{
    return (struct pp_sky){.kind = PP_SKY_PICTURE,
                           .gradation = PP_GRADED_SKY_OVERCAST,
                           .sun = {0.0, 0.0, 1.0},
                           .per_horizontal = 1.0 / picture->horizontal_lx,
                           .picture = picture,
                           .north = {cos(north_rad), sin(north_rad)}};
}

bool pp_sky_has_azimuth(const struct pp_sky *sky)
{
    if (sky->kind == PP_SKY_PICTURE)
        return true;
    return sky->kind == PP_SKY_ISO && (sky->c != 0.0 || sky->e != 0.0);
}

/* Blends the sky (1 + 2z)/3 with the ground's luminance, as in skybright.cal. */
static double faded_luminance(double fade, double z)
{
    double weight = pow(z + 1.01, 10.0);
    return (weight * pp_graded_sky_luminance(PP_GRADED_SKY_OVERCAST, z) + fade / weight)
           / (weight + 1.0 / weight);
}

/* Relative luminance. Graded skies: divided by the luminance of the zenith. ISO skies:
 * f(chi) phi(Z) (sky.h). Photographs: luminance in cd/m2. */
static double relative_luminance(const struct pp_sky *sky, struct pp_vec3 u)
{
    if (sky->fade > 0.0)
        return faded_luminance(sky->fade, u.z);
    if (pp_sky_is_graded(sky))
        return pp_graded_sky_luminance(sky->gradation, u.z);
    if (sky->kind == PP_SKY_PICTURE)
        return pp_sky_picture_luminance(sky->picture, pp_sky_to_north(sky, u), NULL);
    double gradation = 1.0;
    if (sky->a != 0.0)
        gradation += sky->a * exp(sky->b / u.z);
    if (sky->c == 0.0 && sky->e == 0.0)
        return gradation;
    /* atan2 for the angle to the sun: acos loses half its digits near the sun. */
    double chi =
        atan2(pp_vec_length(pp_vec_cross(u, sky->sun)), pp_vec_dot(u, sky->sun));
    double cos_chi = cos(chi);
    double indicatrix = 1.0 + sky->c * (exp(sky->d * chi) - exp(sky->d * PP_PI / 2.0))
                        + sky->e * cos_chi * cos_chi;
    return gradation * indicatrix;
}

double pp_sky_luminance(const struct pp_sky *sky, struct pp_vec3 u)
{
    if (!(u.z > 0.0))
        return 0.0;
    return fmax(relative_luminance(sky, u) * sky->per_horizontal, 0.0);
}

/* Arguments of the integrand in pp_sky_on_plane. */
struct plane_integral {
    const struct pp_sky *sky;
    struct pp_vec3 normal;
};

/* Integrand over azimuth x[0] and x[1], the position (0 to 1) in the range of altitudes
 * that the plane sees at that azimuth. */
static int plane_integrand(unsigned dim, const double *x, void *data, unsigned fdim,
                           double *value)
{
    (void)dim, (void)fdim;
    const struct plane_integral *integral = data;
    struct pp_vec3 n = integral->normal;
    double toward = n.x * sin(x[0]) + n.y * cos(x[0]);

    /* n.u = toward cos(altitude) + n.z sin(altitude) is positive from low to high. */
    double low = 0.0, high = PP_PI / 2.0;
    if (toward < 0.0)
        low = n.z > 0.0 ? atan2(-toward, n.z) : high;
    else if (n.z < 0.0)
        high = atan2(toward, -n.z);

    double altitude = low + (high - low) * x[1];
    double c = cos(altitude);
    struct pp_vec3 u = pp_vec(c * sin(x[0]), c * cos(x[0]), sin(altitude));
    double facing = pp_vec_dot(n, u);
    *value = 0.0;
    if (high > low && facing > 0.0)
        *value = pp_sky_luminance(integral->sky, u) * facing * c * (high - low);
    return 0;
}

static double quadrature_on_plane(const struct pp_sky *sky, struct pp_vec3 n)
{
    /* The integrand has a kink where the plane's own horizon meets the true one, and a
     * cusp at the sun; the range is divided there. */
    double side = atan2(n.x, n.y) + PP_PI / 2.0;
    double sun = atan2(sky->sun.x, sky->sun.y);
    double cut[5] = {0.0, side, side + PP_PI, sun, sun + PP_PI};
    for (int i = 1; i < 5; i++)
        cut[i] -= 2.0 * PP_PI * floor(cut[i] / (2.0 * PP_PI));
    for (int i = 1; i < 5; i++)
        for (int k = i; k > 0 && cut[k] < cut[k - 1]; k--) {
            double swap = cut[k];
            cut[k] = cut[k - 1];
            cut[k - 1] = swap;
        }

    struct plane_integral integral = {sky, n};
    double sum = 0.0;
    for (int i = 0; i < 5; i++) {
        double low[2] = {cut[i], 0.0};
        double high[2] = {i < 4 ? cut[i + 1] : 2.0 * PP_PI, 1.0};
        double value = 0.0, error = 0.0;
        if (high[0] > low[0])
            hcubature(1, plane_integrand, &integral, 2, low, high, 400000, 1e-12, 1e-10,
                      ERROR_INDIVIDUAL, &value, &error);
        sum += value;
    }
    return sum;
}

struct pp_sky pp_sky_of_parameters(const double parameters[5], struct pp_vec3 sun)
{
    struct pp_sky sky = {.kind = PP_SKY_ISO,
                         .gradation = PP_GRADED_SKY_OVERCAST,
                         .sun = sun,
                         .a = parameters[0],
                         .b = parameters[1],
                         .c = parameters[2],
                         .d = parameters[3],
                         .e = parameters[4],
                         .per_horizontal = 1.0};
    sky.per_horizontal = 1.0 / quadrature_on_plane(&sky, pp_vec(0.0, 0.0, 1.0));
    return sky;
}

enum pp_status pp_sky_iso(struct pp_sky *sky, int type, struct pp_vec3 sun,
                          struct pp_error *err)
{
    if (type < 1 || type > ISO_TYPES)
        return pp_fail(err, PP_BAD_INPUT,
                       "sky type iso-%d is not one of iso-1 to iso-%d", type,
                       ISO_TYPES);
    if (pp_sky_iso_has_sun(type) && !(sun.z >= 0.0))
        return pp_fail(err, PP_BAD_INPUT, "sky iso-%d has its sun below the horizon",
                       type);
    const double *row = iso_parameters[type - 1];
    *sky = pp_sky_of_parameters(row + 1,
                                pp_sky_iso_has_sun(type) ? sun : pp_vec(0.0, 0.0, 1.0));
    sky->iso = type;
    return PP_OK;
}

struct pp_sky pp_sky_faded(double ground_reflectance)
{
    struct pp_sky sky = pp_sky_overcast();
    /* rho Eh / (pi Lz); even a black ground darkens the horizon. */
    sky.fade = fmax(ground_reflectance / (PP_PI * sky.per_horizontal), 1e-12);
    sky.per_horizontal = 1.0; /* neutral value during the quadrature */
    sky.per_horizontal = 1.0 / quadrature_on_plane(&sky, pp_vec(0.0, 0.0, 1.0));
    return sky;
}

double pp_sky_on_plane(const struct pp_sky *sky, struct pp_vec3 n)
{
    if (sky->kind == PP_SKY_PICTURE)
        return sky->per_horizontal
               * pp_sky_picture_on_plane(sky->picture, pp_sky_to_north(sky, n));
    if (sky->kind == PP_SKY_ISO || sky->fade > 0.0)
        return quadrature_on_plane(sky, n);
    return pp_graded_sky_on_plane(sky->gradation, atan2(hypot(n.x, n.y), n.z));
}

double pp_sky_grain(const struct pp_sky *sky)
{
    return sky->kind == PP_SKY_PICTURE ? sky->picture->step_rad : 0.0;
}

const char *pp_sky_name(const struct pp_sky *sky)
{
    static const char *const iso_names[] = {
        "iso-1", "iso-2",  "iso-3",  "iso-4",  "iso-5",  "iso-6",  "iso-7", "iso-8",
        "iso-9", "iso-10", "iso-11", "iso-12", "iso-13", "iso-14", "iso-15"};
    switch (sky->kind) {
    case PP_SKY_OVERCAST:
        return "overcast";
    case PP_SKY_UNIFORM:
        return "uniform";
    case PP_SKY_PICTURE:
        return "picture";
    case PP_SKY_ISO:
        break;
    }
    return sky->iso > 0 ? iso_names[sky->iso - 1] : "perez";
}
