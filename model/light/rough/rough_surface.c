/* rough_surface.c - integrates the model of he_torrance.h over all exit directions, and
 * finds the factors that bound its albedo. */
#include "model/light/rough/rough_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/gauss.h"
#include "model/light/rough/he_torrance.h"

enum {
    ANGLES = PP_ROUGH_ANGLES,
    RADII = PP_ROUGH_RADII,
    IN_RADIUS = 2,  /* Gauss points in each interval of radius */
    IN_AZIMUTH = 12 /* Gauss points over half the azimuths */
};

/* Largest albedo: 1 less the error of this quadrature and of interpolation between
 * angles, up to 0.0015 in surfaces from s0 = 0.02 to 3 and T = 0.3 to 20. */
static const double MOST_ALBEDO = 1.0 - 2e-3;

static struct pp_he_torrance optics_at(const struct pp_rough_optics *optics,
                                       int channel)
{
    return (struct pp_he_torrance){optics->n[channel], optics->k[channel],
                                   optics->wavelength[channel], optics->roughness,
                                   optics->correlation};
}

static struct pp_he_torrance_direction rough_direction(
    const struct pp_rough_optics *optics, struct pp_vec3 to)
{
    return pp_he_torrance_towards(to, optics->roughness, optics->correlation);
}

/* ---- tables by angle ---- */

int pp_rough_surface_cell(double cosine, double *next)
{
    double x = sqrt(fmin(fmax(cosine, 0.0), 1.0)) * (ANGLES - 1);
    int cell = (int)x < ANGLES - 2 ? (int)x : ANGLES - 2;
    *next = x - cell;
    return cell;
}

static double cosine_of_angle(int angle)
{
    double x = (double)angle / (ANGLES - 1);
    return x * x;
}

static double read_table(const double *table, double cosine)
{
    double next;
    int cell = pp_rough_surface_cell(cosine, &next);
    return table[cell] + next * (table[cell + 1] - table[cell]);
}

double pp_rough_surface_reach(double sine, double radius)
{
    double most = radius * radius + sine * sine - 1.0, over = 2.0 * radius * sine;
    return most <= -over ? PP_PI : most < over ? acos(most / over) : 0.0;
}

/* ---- integration ---- */

/* Light from each angle of incidence to the neighbourhood of each angle of exit, with F
 * = 1 and with the surface's own F. */
struct rough_kernel {
    double white[3][ANGLES][ANGLES], own[3][ANGLES][ANGLES];
};

/* Returns the direction r for which the sum i_xy + r_xy has the length `radius` and is
 * at `azimuth` from i_xy, which has the length `sine` along x. */
static struct pp_vec3 exit_of(double sine, double radius, double azimuth)
{
    double x = radius * cos(azimuth) - sine, y = radius * sin(azimuth);
    return pp_vec(x, y, sqrt(fmax(1.0 - x * x - y * y, 0.0)));
}

/* Adds the light of one exit direction, for an area of r_xy; returns its mean over the
 * channels. */
static double add_exit(const struct pp_rough_surface *surface,
                       struct rough_kernel *kernel, int angle,
                       const struct pp_he_torrance_direction *i, struct pp_vec3 exit,
                       double area)
{
    const struct pp_rough_optics *optics = &surface->optics;
    struct pp_he_torrance_direction r = rough_direction(optics, exit);
    double s = pp_he_torrance_roughness(i, &r, optics->roughness), next, sum = 0.0;
    int cell = pp_rough_surface_cell(exit.z, &next);
    for (int c = 0; c < surface->channels; c++) {
        struct pp_he_torrance model = optics_at(optics, c);
        double half, white = area * pp_he_torrance_lobe(&model, s, i, &r, &half);
        double own = white * pp_he_torrance_fresnel(model.n, model.k, half);
        kernel->white[c][angle][cell] += (1.0 - next) * white;
        kernel->white[c][angle][cell + 1] += next * white;
        kernel->own[c][angle][cell] += (1.0 - next) * own;
        kernel->own[c][angle][cell + 1] += next * own;
        sum += own / surface->channels;
    }
    return sum;
}

/* Integrates over the exit directions of one angle of incidence, in polar coordinates
 * of i_xy + r_xy: int dd cos do = int dd d(r_xy). */
static void integrate_angle(struct pp_rough_surface *surface,
                            struct rough_kernel *kernel, int angle)
{
    double cosine = cosine_of_angle(angle), sine = sqrt(1.0 - cosine * cosine);
    struct pp_he_torrance_direction i =
        rough_direction(&surface->optics, pp_vec(sine, 0.0, cosine));
    double rho[IN_RADIUS], in_rho[IN_RADIUS], phi[IN_AZIMUTH], in_phi[IN_AZIMUTH];
    pp_gauss_legendre(rho, in_rho, IN_RADIUS);
    pp_gauss_legendre(phi, in_phi, IN_AZIMUTH);
    double *share = surface->share[angle];
    for (int k = 0; k < RADII; k++) {
        double low = surface->radius[k] * (1.0 + sine);
        double wide = surface->radius[k + 1] * (1.0 + sine) - low, sum = 0.0;
        for (int p = 0; p < IN_RADIUS; p++) {
            double radius = low + wide * (1.0 + rho[p]) / 2.0;
            double reach = pp_rough_surface_reach(sine, radius);
            for (int q = 0; q < IN_AZIMUTH; q++) {
                /* Both halves of the azimuths count: a factor of 2 is included. */
                double area = radius * wide * in_rho[p] / 2.0 * reach * in_phi[q];
                sum +=
                    add_exit(surface, kernel, angle, &i,
                             exit_of(sine, radius, reach * (1.0 + phi[q]) / 2.0), area);
            }
        }
        share[k + 1] = share[k] + sum;
    }
    for (int k = 1; k <= RADII && share[RADII] > 0.0; k++)
        share[k] /= share[RADII];
}

/* Radii in nearly equal steps up to half the width l / (pi T) of the narrowest lobe,
 * that of m = 1; then in nearly constant proportion. */
static void place_radii(struct pp_rough_surface *surface)
{
    const struct pp_rough_optics *optics = &surface->optics;
    double least =
        fmin(optics->wavelength[0], fmin(optics->wavelength[1], optics->wavelength[2]));
    double scale = fmin(least / (PP_PI * optics->correlation), 1.0) / 2.0;
    double most = asinh(1.0 / scale);
    for (int k = 0; k <= RADII; k++)
        surface->radius[k] = scale * sinh(most * k / RADII);
    surface->radius[RADII] = 1.0;
}

/* ---- the bound ---- */

static double spike_share(const struct pp_rough_optics *optics, int channel,
                          double cosine, bool white)
{
    struct pp_he_torrance model = optics_at(optics, channel);
    double sine = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    struct pp_he_torrance_direction i =
        rough_direction(optics, pp_vec(sine, 0.0, cosine));
    return white ? pp_he_torrance_spike_share(&model, &i)
                 : pp_he_torrance_spike(&model, &i);
}

/* int dd' cos for an angle of incidence i: c(i) sum_j kernel(i, j) c(j). */
static double lobe_of(const double (*kernel)[ANGLES], const double *keep, int angle)
{
    double sum = 0.0;
    for (int j = 0; j < ANGLES; j++)
        sum += kernel[angle][j] * keep[j];
    return keep[angle] * sum;
}

/* Lowers the factors until no albedo exceeds the bound; returns the largest initial
 * albedo. */
static double bound_albedo(double *keep, const double (*kernel)[ANGLES],
                           const double *spike, double bound)
{
    enum { ROUNDS = 100 };
    double first = 0.0;
    for (int round = 0; round < ROUNDS; round++) {
        double next[ANGLES], most = 0.0;
        for (int i = 0; i < ANGLES; i++) {
            double albedo = keep[i] * keep[i] * spike[i] + lobe_of(kernel, keep, i);
            most = fmax(most, albedo);
            next[i] = keep[i] * (albedo > bound ? sqrt(bound / albedo) : 1.0);
        }
        if (round == 0)
            first = most;
        if (!(most > bound * (1.0 + 1e-9)))
            break;
        memcpy(keep, next, sizeof next);
    }
    return first;
}

/* Integral of a table over diffuse illumination, 2 cos d(cos), by Simpson's rule in the
 * root of the cosine. */
static double diffuse_mean(const double *table)
{
    double sum = 0.0;
    for (int i = 0; i < ANGLES; i++) {
        double x = (double)i / (ANGLES - 1);
        double weight = i == 0 || i == ANGLES - 1 ? 1.0 : i % 2 ? 4.0 : 2.0;
        sum += weight * 4.0 * x * x * x * table[i];
    }
    return sum / (3.0 * (ANGLES - 1));
}

/* Factors, albedos and reflectance of one channel. */
static void settle_channel(struct pp_rough_surface *surface,
                           const struct rough_kernel *kernel, int channel)
{
    const struct pp_rough_optics *optics = &surface->optics;
    const double a[3] = {optics->diffuse.r, optics->diffuse.g, optics->diffuse.b};
    double *keep = surface->keep[channel], one[ANGLES];
    double spike[2][ANGLES], all[2][ANGLES];
    for (int i = 0; i < ANGLES; i++) {
        keep[i] = one[i] = 1.0;
        for (int white = 0; white < 2; white++)
            spike[white][i] = spike_share(optics, channel, cosine_of_angle(i), white);
    }
    double most = bound_albedo(keep, kernel->white[channel], spike[1], MOST_ALBEDO);
    surface->most = fmax(surface->most, most);
    bound_albedo(keep, kernel->own[channel], spike[0],
                 fmax(MOST_ALBEDO - a[channel], 0.0));
    for (int i = 0; i < ANGLES; i++) {
        double kept = keep[i] * keep[i];
        surface->lobe[channel][i] = lobe_of(kernel->own[channel], keep, i);
        all[0][i] = kept * spike[0][i] + surface->lobe[channel][i];
        all[1][i] = fmin(spike[1][i] + lobe_of(kernel->white[channel], one, i), 1.0);
    }
    surface->reflectance[channel] = diffuse_mean(all[0]);
    if (channel == surface->channels / 2)
        surface->lost = 1.0 - diffuse_mean(all[1]);
}

static bool channels_are_equal(const struct pp_rough_optics *o)
{
    for (int c = 1; c < 3; c++)
        if (o->n[c] != o->n[0] || o->k[c] != o->k[0]
            || o->wavelength[c] != o->wavelength[0])
            return false;
    return o->diffuse.r == o->diffuse.g && o->diffuse.r == o->diffuse.b;
}

enum pp_status pp_rough_surface_init(struct pp_rough_surface *surface,
                                     const struct pp_rough_optics *optics,
                                     struct pp_error *err)
{
    struct rough_kernel *kernel = calloc(1, sizeof *kernel);
    if (!kernel)
        return pp_fail_memory(err);
    *surface = (struct pp_rough_surface){
        .optics = *optics, .channels = channels_are_equal(optics) ? 1 : 3};
    place_radii(surface);
    for (int i = 0; i < ANGLES; i++)
        integrate_angle(surface, kernel, i);
    for (int c = 0; c < surface->channels; c++)
        settle_channel(surface, kernel, c);
    for (int c = surface->channels; c < 3; c++) {
        memcpy(surface->keep[c], surface->keep[0], sizeof surface->keep[0]);
        memcpy(surface->lobe[c], surface->lobe[0], sizeof surface->lobe[0]);
        surface->reflectance[c] = surface->reflectance[0];
    }
    free(kernel);
    return PP_OK;
}

bool pp_rough_surface_same(const struct pp_rough_surface *a,
                           const struct pp_rough_surface *b)
{
    return memcmp(&a->optics, &b->optics, sizeof a->optics) == 0;
}

/* ---- values ---- */

static struct pp_rgb by_channel(const struct pp_rough_surface *surface,
                                const double value[3])
{
    return surface->channels == 1 ? pp_rgb_grey(value[0])
                                  : pp_rgb(value[0], value[1], value[2]);
}

struct pp_rgb pp_rough_surface_spike(const struct pp_rough_surface *surface,
                                     double cosine)
{
    double value[3];
    for (int c = 0; c < surface->channels; c++) {
        double keep = read_table(surface->keep[c], cosine);
        value[c] = keep * keep * spike_share(&surface->optics, c, cosine, false);
    }
    return by_channel(surface, value);
}

struct pp_rgb pp_rough_surface_lobe(const struct pp_rough_surface *surface,
                                    double cosine)
{
    double value[3];
    for (int c = 0; c < surface->channels; c++)
        value[c] = read_table(surface->lobe[c], cosine);
    return by_channel(surface, value);
}

struct pp_rgb pp_rough_surface_value(const struct pp_rough_surface *surface,
                                     struct pp_vec3 i, struct pp_vec3 r)
{
    const struct pp_rough_optics *optics = &surface->optics;
    if (!(i.z > 0.0 && r.z > 0.0))
        return pp_rgb_grey(0.0);
    struct pp_he_torrance_direction in = rough_direction(optics, i),
                                    out = rough_direction(optics, r);
    double value[3], half, s = pp_he_torrance_roughness(&in, &out, optics->roughness);
    for (int c = 0; c < surface->channels; c++) {
        struct pp_he_torrance model = optics_at(optics, c);
        double lobe = pp_he_torrance_lobe(&model, s, &in, &out, &half);
        value[c] = lobe * pp_he_torrance_fresnel(model.n, model.k, half)
                   * read_table(surface->keep[c], i.z)
                   * read_table(surface->keep[c], r.z);
    }
    return by_channel(surface, value);
}

struct pp_rgb pp_rough_surface_reflectance(const struct pp_rough_surface *surface)
{
    return pp_rgb_add(by_channel(surface, surface->reflectance),
                      surface->optics.diffuse);
}
