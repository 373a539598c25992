/* he_torrance.c - see he_torrance.h. */
#include "model/light/rough/he_torrance.h"

#include <math.h>

static const double SQRT_PI = 1.77245385090551602730;
static const double LEAST_COSINE = 1e-6;

/* Terms of the series are added until one is below this fraction of the sum. */
static const double LAST_TERM = 1e-16;

/* ---- Fresnel ---- */

double pp_he_torrance_fresnel(double n, double k, double cosine)
{
    /* p + iq is the root of (n + ik)^2 - sin^2. */
    double c = fmin(cosine, 1.0), square = n * n - k * k;
    double a = square - (1.0 - c * c), b = hypot(a, 2.0 * n * k);
    double p = sqrt(fmax(b + a, 0.0) / 2.0), q = sqrt(fmax(b - a, 0.0) / 2.0);
    double rs = ((c - p) * (c - p) + q * q) / ((c + p) * (c + p) + q * q);
    double x = square * c, y = 2.0 * n * k * c;
    double rp = ((x - p) * (x - p) + (y - q) * (y - q))
                / ((x + p) * (x + p) + (y + q) * (y + q));
    return (rs + rp) / 2.0;
}

/* ---- the series of D ---- */

/* Term m + 1 divided by term m; decreases with m. */
static double series_ratio(double g, double e, double m)
{
    return g * m / ((m + 1.0) * (m + 1.0)) * exp(e / (m * (m + 1.0)));
}

static double log_term(double g, double e, double m)
{
    int sign;
    return m * log(g) - g - lgamma_r(m + 1.0, &sign) - log(m) - e / m;
}

/* Index of the largest term. */
static double largest_term(double g, double e)
{
    double low = 1.0, high = 1.0;
    while (series_ratio(g, e, high) > 1.0)
        high *= 2.0;
    while (high - low > 1.0) {
        double middle = floor((low + high) / 2.0);
        if (series_ratio(g, e, middle) > 1.0)
            low = middle;
        else
            high = middle;
    }
    return series_ratio(g, e, low) > 1.0 ? high : low;
}

/* Sum of the series divided by its largest term, by adding every term. */
static double sum_of_neighbours(double g, double e, double peak)
{
    double sum = 1.0, term = 1.0;
    for (double m = peak; term > LAST_TERM * sum; m++)
        sum += term *= series_ratio(g, e, m);
    term = 1.0;
    for (double m = peak - 1.0; m >= 1.0 && term > LAST_TERM * sum; m--)
        sum += term /= series_ratio(g, e, m);
    return sum;
}

/* Sum of the series divided by its largest term, by adding every stride-th term. The
 * terms are nearly Gaussian in m. With several of the added terms in one standard
 * deviation, the result is the same to 1e-13. */
static double sum_of_strides(double g, double e, double peak, double stride)
{
    double top = log_term(g, e, peak), sum = 1.0, term = 1.0;
    for (double m = peak + stride; term > LAST_TERM * sum; m += stride)
        sum += term = exp(log_term(g, e, m) - top);
    term = 1.0;
    for (double m = peak - stride; m >= 1.0 && term > LAST_TERM * sum; m -= stride)
        sum += term = exp(log_term(g, e, m) - top);
    return stride * sum;
}

double pp_he_torrance_series(double g, double e)
{
    static const double WIDE = 15.0, PER_DEVIATION = 2.5;
    if (!(g > 0.0))
        return 0.0;
    double m = largest_term(g, e), top = log_term(g, e, m);
    if (!(top > -700.0))
        return 0.0;
    double deviation = 1.0 / sqrt(1.0 / m + 2.0 * e / (m * m * m));
    return exp(top)
           * (deviation < WIDE
                  ? sum_of_neighbours(g, e, m)
                  : sum_of_strides(g, e, m, floor(deviation / PER_DEVIATION)));
}

/* ---- directions ---- */

struct pp_he_torrance_direction pp_he_torrance_towards(struct pp_vec3 to, double s0,
                                                       double correlation)
{
    struct pp_he_torrance_direction direction = {to, fmax(to.z, LEAST_COSINE), 1.0,
                                                 0.0};
    double c = fmin(direction.cosine, 1.0), sine = sqrt(1.0 - c * c);
    if (!(sine > 0.0) || !(s0 > 0.0))
        return direction;
    double u = correlation * c / (2.0 * s0 * sine), below = erfc(u);
    double l = (exp(-u * u) / (SQRT_PI * u) - below) / 2.0;
    direction.shadow = (1.0 - below / 2.0) / (1.0 + l);
    direction.k = sine / c * below;
    return direction;
}

double pp_he_torrance_roughness(const struct pp_he_torrance_direction *i,
                                const struct pp_he_torrance_direction *r, double s0)
{
    /* y = x^2 solves y exp(y) = z: Newton's steps from above, where the left side is
     * convex. */
    double c = (i->k + r->k) / sqrt(8.0 * PP_PI), z = c * c, y = log1p(z);
    for (int step = 0; step < 60; step++) {
        double next = y - (y - z * exp(-y)) / (1.0 + y);
        if (!(next < y * (1.0 - 1e-15)))
            break;
        y = next;
    }
    return s0 / sqrt(1.0 + y);
}

/* ---- reflectance ---- */

static double squared(double x)
{
    return x * x;
}

double pp_he_torrance_spike_share(const struct pp_he_torrance *surface,
                                  const struct pp_he_torrance_direction *i)
{
    double s = pp_he_torrance_roughness(i, i, surface->roughness);
    double g = squared(4.0 * PP_PI * s * i->cosine / surface->wavelength);
    return exp(-g) * i->shadow * i->shadow;
}

double pp_he_torrance_spike(const struct pp_he_torrance *surface,
                            const struct pp_he_torrance_direction *i)
{
    return pp_he_torrance_fresnel(surface->n, surface->k, i->cosine)
           * pp_he_torrance_spike_share(surface, i);
}

double pp_he_torrance_lobe(const struct pp_he_torrance *surface, double s,
                           const struct pp_he_torrance_direction *i,
                           const struct pp_he_torrance_direction *r, double *half)
{
    double l = surface->wavelength, t = surface->correlation;
    double vz = i->cosine + r->cosine;
    double along2 = squared(i->to.x + r->to.x) + squared(i->to.y + r->to.y);
    double v2 = along2 + vz * vz;
    double g = squared(2.0 * PP_PI * s * vz / l);
    double d = squared(PP_PI * t / (2.0 * l))
               * pp_he_torrance_series(g, squared(PP_PI * t / l) * along2);
    *half = fmin(sqrt(v2) / 2.0, 1.0);
    return squared(v2 / vz) * i->shadow * r->shadow * d
           / (PP_PI * i->cosine * r->cosine);
}

double pp_he_torrance_diffuse(const struct pp_he_torrance *surface,
                              const struct pp_he_torrance_direction *i,
                              const struct pp_he_torrance_direction *r)
{
    double half, s = pp_he_torrance_roughness(i, r, surface->roughness);
    double lobe = pp_he_torrance_lobe(surface, s, i, r, &half);
    return pp_he_torrance_fresnel(surface->n, surface->k, half) * lobe;
}
