/* protractor_scale.c - the published protractors, and the scales by closed form or by
 * cubature of their density. */
#include "methods/protractor/protractor_scale.h"

#include <cubature.h>
#include <math.h>
#include <stddef.h>

#include "model/light/graded_sky.h"

enum { MOST_EVALUATIONS = 200000 };
static const double relative_error = 1e-10;

enum pp_status pp_protractor_scale_published(struct pp_protractor *protractor,
                                             int number, struct pp_error *err)
{
    static const double slope_deg[] = {90.0, 0.0, 30.0, 60.0, 90.0};
    if (number < 1 || number > 10)
        return pp_fail(err, PP_BAD_INPUT, "there is no protractor %d; expected 1 to 10",
                       number);
    *protractor = (struct pp_protractor){
        .sky = number % 2 ? pp_sky_uniform() : pp_sky_overcast(),
        .glass = number <= 8 ? pp_glass_clear_single() : pp_glass_none(),
        .slope_rad = slope_deg[(number - 1) / 2] * PP_RAD};
    return PP_OK;
}

static bool is_clear_single(const struct pp_glass *glass)
{
    struct pp_glass clear = pp_glass_clear_single();
    return !glass->diffusing && glass->panes == clear.panes && glass->n == clear.n
           && glass->kl == clear.kl && glass->scale == clear.scale;
}

int pp_protractor_scale_number(const struct pp_protractor *protractor)
{
    if (protractor->receiver != PP_PROTRACTOR_UP)
        return 0;
    int even = protractor->sky.kind == PP_SKY_OVERCAST;
    if (!even && protractor->sky.kind != PP_SKY_UNIFORM)
        return 0;
    if (protractor->glass.panes == 0)
        return 9 + even;
    if (!is_clear_single(&protractor->glass))
        return 0;
    static const double slope_deg[] = {90.0, 0.0, 30.0, 60.0};
    for (int i = 0; i < 4; i++)
        if (fabs(protractor->slope_rad - slope_deg[i] * PP_RAD) < 1e-6)
            return 1 + 2 * i + even;
    return 0;
}

double pp_protractor_scale_range(const struct pp_protractor *protractor)
{
    return protractor->glass.panes == 0 ? PP_PI : PP_PI - protractor->slope_rad;
}

void pp_protractor_scale_densities(double *densities,
                                   const struct pp_protractor *protractor,
                                   const struct pp_glass_curve *losses,
                                   double gamma_rad, const struct pp_angle *thetas,
                                   int count)
{
    struct pp_angle gamma = pp_angle_of(gamma_rad);
    double through = sin(gamma_rad + protractor->slope_rad), up = gamma.sine;
    if (protractor->receiver != PP_PROTRACTOR_UP)
        up = fmax(up, 1e-12); /* at the horizon the luminance is that of the sky */
    for (int i = 0; i < count; i++) {
        double across = thetas[i].cosine, cos_i = across * through;
        densities[i] = 0.0;
        /* At grazing incidence the transmittance is 0, and several panes give 0/0. */
        if (protractor->glass.panes > 0 && !(cos_i > 1e-12))
            continue;
        struct pp_vec3 u = pp_vec(across * gamma.cosine, thetas[i].sine, across * up);
        double facing = protractor->receiver == PP_PROTRACTOR_UP      ? u.z
                        : protractor->receiver == PP_PROTRACTOR_AHEAD ? u.x
                                                                      : u.y;
        densities[i] = pp_sky_luminance(&protractor->sky, u)
                       * (losses ? pp_glass_curve_transmittance(losses, cos_i)
                                 : pp_glass_transmittance(&protractor->glass, cos_i))
                       * facing * across;
    }
}

double pp_protractor_scale_density(const struct pp_protractor *protractor,
                                   double gamma_rad, double theta_rad)
{
    struct pp_angle theta = pp_angle_of(theta_rad);
    double density;
    pp_protractor_scale_densities(&density, protractor, NULL, gamma_rad, &theta, 1);
    return density;
}

static bool closed_form(const struct pp_protractor *protractor)
{
    return protractor->glass.panes == 0 && pp_sky_is_graded(&protractor->sky)
           && protractor->receiver == PP_PROTRACTOR_UP;
}

/* Context of the integrands below, whose variables are theta, or theta and gamma. */
struct strip {
    const struct pp_protractor *protractor;
    double gamma;
};

static int theta_integrand(unsigned dim, const double *x, void *data, unsigned fdim,
                           double *value)
{
    (void)dim, (void)fdim;
    const struct strip *strip = data;
    *value = pp_protractor_scale_density(strip->protractor, strip->gamma, x[0]);
    return 0;
}

static int strip_integrand(unsigned dim, const double *x, void *data, unsigned fdim,
                           double *value)
{
    (void)dim, (void)fdim;
    const struct strip *strip = data;
    *value = pp_protractor_scale_density(strip->protractor, x[1], x[0]);
    return 0;
}

/* The integral over the strip at gamma, between the section and theta >= 0. */
static double one_side(const struct pp_protractor *protractor, double gamma,
                       double theta)
{
    struct strip strip = {protractor, gamma};
    double low = 0.0, value = 0.0, error;
    hcubature(1, theta_integrand, &strip, 1, &low, &theta, MOST_EVALUATIONS, 1e-15,
              relative_error, ERROR_INDIVIDUAL, &value, &error);
    return value;
}

/* The integral over all strips from low to high, on both sides of the section. */
static double strips_between(const struct pp_protractor *protractor, double low_rad,
                             double high_rad)
{
    struct strip strip = {protractor, 0.0};
    double low[2] = {0.0, low_rad}, high[2] = {PP_PI / 2.0, high_rad};
    double value = 0.0, error;
    if (!(high_rad > low_rad))
        return 0.0;
    hcubature(1, strip_integrand, &strip, 2, low, high, MOST_EVALUATIONS, 1e-15,
              relative_error, ERROR_INDIVIDUAL, &value, &error);
    return 2.0 * value;
}

double pp_protractor_scale_primary(const struct pp_protractor *protractor,
                                   double gamma_rad)
{
    double gamma = fmin(gamma_rad, pp_protractor_scale_range(protractor));
    if (!(gamma > 0.0))
        return 0.0;
    if (closed_form(protractor))
        return pp_graded_sky_below_plane(protractor->sky.gradation, gamma);
    return strips_between(protractor, 0.0, gamma);
}

double pp_protractor_scale_primary_slope(const struct pp_protractor *protractor,
                                         double gamma_rad)
{
    return 2.0 * one_side(protractor, gamma_rad, PP_PI / 2.0);
}

double pp_protractor_scale_angle(const struct pp_protractor *protractor, double share,
                                 double low_rad, double high_rad)
{
    double low = low_rad, high = high_rad;
    double gamma = low, sum = pp_protractor_scale_primary(protractor, low);
    for (int i = 0; i < 60 && high - low > 1e-11; i++) {
        /* A Newton step, or bisection where it would leave the bracket. */
        double slope = pp_protractor_scale_primary_slope(protractor, gamma);
        double next = gamma + (share - sum) / slope;
        if (!(next > low && next < high))
            next = (low + high) / 2.0;
        sum += next > gamma ? strips_between(protractor, gamma, next)
                            : -strips_between(protractor, next, gamma);
        double step = fabs(next - gamma);
        gamma = next;
        if (sum < share)
            low = gamma;
        else
            high = gamma;
        if (step < 1e-10)
            break;
    }
    return gamma;
}

double pp_protractor_scale_auxiliary(const struct pp_protractor *protractor,
                                     double gamma_rad, double theta_rad)
{
    double theta = fmin(fabs(theta_rad), PP_PI / 2.0), share;
    if (closed_form(protractor)) {
        /* Integrals of cos^2 theta and b sin gamma cos^3 theta. */
        double s = sin(theta);
        double brighter = protractor->sky.gradation * sin(gamma_rad);
        share =
            (theta / 2.0 + sin(2.0 * theta) / 4.0 + brighter * (s - s * s * s / 3.0))
            / (PP_PI / 4.0 + brighter * 2.0 / 3.0);
    } else {
        /* At the horizon the strip's integral is 0; the share has a limit there. */
        double gamma = fmax(gamma_rad, 1e-9);
        share = one_side(protractor, gamma, theta)
                / one_side(protractor, gamma, PP_PI / 2.0);
    }
    return copysign(share / 2.0, theta_rad);
}

double pp_protractor_scale_theta(double cos_gamma, struct pp_angle azimuth)
{
    return atan2(azimuth.sine * cos_gamma, azimuth.cosine);
}
