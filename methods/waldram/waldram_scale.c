/* waldram_scale.c - tabulates X and Y, and integrates areas by Green's theorem. */
#include "methods/waldram/waldram_scale.h"

#include <cubature.h>
#include <math.h>
#include <stddef.h>

#include "methods/interpolate.h"
#include "model/light/graded_sky.h"

enum { MOST_EVALUATIONS = 50000 };

/* dX/dphi: 1 without glass, tau(cos phi)/tau(1) with it; cos phi for a vertical
 * receiver. */
static double x_density(const void *context, double azimuth)
{
    const struct pp_waldram *waldram = context;
    if (waldram->upright)
        return cos(azimuth);
    if (!waldram->glazed)
        return 1.0;
    return pp_glass_transmittance(&waldram->glass, cos(azimuth))
           / waldram->glass.normal;
}

/* dY/dgamma. */
static double y_density(const void *context, double altitude)
{
    const struct pp_waldram *waldram = context;
    double s = sin(altitude), c = cos(altitude);
    double luminance = pp_sky_luminance(&waldram->sky, pp_vec(c, 0.0, s));
    if (waldram->upright)
        return luminance * c * c;
    return luminance * s * c * pp_glass_transmittance(&waldram->glass, c);
}

static double read_scale(const double *scale, double angle)
{
    return pp_interpolate_cubic(scale, PP_WALDRAM_PANELS + 1, 0.0, PP_PI / 2.0, angle);
}

/* Tabulates the scales of a diagram whose receiver and glass are set. */
static enum pp_status tabulate(struct pp_waldram *waldram, const struct pp_sky *sky,
                               struct pp_error *err)
{
    if (pp_sky_has_azimuth(sky))
        return pp_fail(
            err, PP_BAD_INPUT,
            "no Waldram diagram for %s; expected a sky whose luminance does not depend "
            "on azimuth",
            pp_sky_name(sky));
    waldram->sky = *sky;
    pp_interpolate_tabulate_integral(waldram->x, PP_WALDRAM_PANELS + 1, 0.0,
                                     PP_PI / 2.0, x_density, waldram);
    pp_interpolate_tabulate_integral(waldram->y, PP_WALDRAM_PANELS + 1, 0.0,
                                     PP_PI / 2.0, y_density, waldram);
    return PP_OK;
}

enum pp_status pp_waldram_scale_init(struct pp_waldram *waldram,
                                     const struct pp_sky *sky, bool glazed,
                                     struct pp_error *err)
{
    waldram->upright = false;
    waldram->glazed = glazed;
    waldram->glass = glazed ? pp_glass_clear_single() : pp_glass_none();
    return tabulate(waldram, sky, err);
}

enum pp_status pp_waldram_scale_init_upright(struct pp_waldram *waldram,
                                             const struct pp_sky *sky,
                                             struct pp_vec3 facing,
                                             struct pp_error *err)
{
    waldram->upright = true;
    waldram->facing = facing;
    waldram->glazed = false;
    waldram->glass = pp_glass_none();
    return tabulate(waldram, sky, err);
}

struct pp_vec3 pp_waldram_scale_direction(const struct pp_waldram *waldram,
                                          const struct pp_window_axes *axes,
                                          const double xy[2])
{
    const struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct pp_vec3 right =
        waldram->upright ? pp_vec_cross(waldram->facing, zenith) : axes->along;
    struct pp_vec3 ahead =
        waldram->upright ? waldram->facing : pp_vec_cross(zenith, axes->along);
    struct pp_vec3 u =
        pp_vec_along(pp_vec_along(axes->out, xy[0], axes->along), xy[1], axes->up);
    return pp_vec(pp_vec_dot(u, right), pp_vec_dot(u, ahead), u.z);
}

double pp_waldram_scale_x(const struct pp_waldram *waldram, double azimuth_rad)
{
    double azimuth = fabs(azimuth_rad);
    if (waldram->upright)
        return sin(azimuth_rad);
    if (!waldram->glazed)
        return azimuth_rad;
    return copysign(read_scale(waldram->x, azimuth), azimuth_rad);
}

/* True if Y has a closed form. */
static bool is_closed(const struct pp_waldram *waldram)
{
    return !waldram->glazed && pp_sky_is_graded(&waldram->sky);
}

double pp_waldram_scale_y(const struct pp_waldram *waldram, double altitude_rad)
{
    if (!(altitude_rad > 0.0))
        return 0.0;
    if (is_closed(waldram) && waldram->upright)
        return pp_graded_sky_upright_below_altitude(waldram->sky.gradation,
                                                    altitude_rad);
    if (is_closed(waldram))
        return pp_graded_sky_below_altitude(waldram->sky.gradation, sin(altitude_rad));
    return read_scale(waldram->y, altitude_rad);
}

double pp_waldram_scale_y_toward(const struct pp_waldram *waldram, struct pp_vec3 u)
{
    double level = sqrt(u.x * u.x + u.y * u.y);
    if (u.z > 0.0 && is_closed(waldram) && !waldram->upright)
        return pp_graded_sky_below_altitude(waldram->sky.gradation,
                                            u.z / sqrt(level * level + u.z * u.z));
    return pp_waldram_scale_y(waldram, atan2(u.z, level));
}

double pp_waldram_scale_total_area(const struct pp_waldram *waldram)
{
    return 2.0 * pp_waldram_scale_x(waldram, PP_PI / 2.0)
           * pp_waldram_scale_y(waldram, PP_PI / 2.0);
}

/* A straight edge of the window's drawing: directions p + t d, with t from 0 to 1. The
 * azimuth is measured from the horizontal part of the window's outward direction. */
struct window_edge {
    const struct pp_waldram *waldram;
    struct pp_vec3 p, d; /* in axes: x to the right, y ahead, z up */
    double top;          /* Y at the zenith */
};

/* The integrand (Y(zenith) - Y) dX/dt: by Green's theorem the sum around a region is
 * its area. Y is measured down from the zenith, so that a region that contains the
 * zenith, whose outline covers all azimuths once, needs no special case. */
static int edge_integrand(unsigned dim, const double *t, void *data, unsigned fdim,
                          double *value)
{
    (void)dim, (void)fdim;
    const struct window_edge *edge = data;
    struct pp_vec3 u = pp_vec_along(edge->p, t[0], edge->d);
    double level2 = u.x * u.x + u.y * u.y;
    *value = 0.0;
    if (level2 > 0.0) {
        double azimuth = atan2(u.x, u.y);
        double turn = (u.y * edge->d.x - u.x * edge->d.y) / level2;
        double y = pp_waldram_scale_y_toward(edge->waldram, u);
        if (!edge->waldram->glazed || fabs(azimuth) < PP_PI / 2.0)
            *value = (edge->top - y) * x_density(edge->waldram, azimuth) * turn;
    }
    return 0;
}

static double edge_sum(const struct window_edge *edge, double from, double to)
{
    double sum = 0.0, error;
    if (to > from)
        hcubature(1, edge_integrand, (void *)edge, 1, &from, &to, MOST_EVALUATIONS,
                  1e-15, 1e-11, ERROR_INDIVIDUAL, &sum, &error);
    return sum;
}

double pp_waldram_scale_area(const struct pp_waldram *waldram,
                             const struct pp_window_axes *axes,
                             const struct pp_region *region)
{
    double area = 0.0;
    for (int r = 0; r < region->count; r++) {
        const struct pp_ring *ring = &region->rings[r];
        struct pp_vec3 last = {0.0, 0.0, 0.0};
        for (int i = 0; i <= ring->count; i++) {
            struct pp_vec3 here =
                pp_waldram_scale_direction(waldram, axes, ring->xy[i % ring->count]);
            if (i > 0) {
                struct window_edge edge = {waldram, last, pp_vec_sub(here, last),
                                           pp_waldram_scale_y(waldram, PP_PI / 2.0)};
                /* Y has a kink where the edge meets the horizon. */
                double cut = last.z * here.z < 0.0 ? last.z / (last.z - here.z) : 0.0;
                area += edge_sum(&edge, 0.0, cut) + edge_sum(&edge, cut, 1.0);
            }
            last = here;
        }
    }
    return area;
}
