/* cache_work.c - see cache_work.h. */
#include "simulate/cache_work.h"

#include <math.h>

#include "simulate/cache_derivatives.h"

/* An ellipse is no longer than so many times its width. */
static const double LONGEST = 3.0;

/* Rays lower than this sine of altitude tell how far the surface is clear. */
static const double LOW = 0.4;

void pp_cache_ellipse(const double curvature[3], double error, double most_m,
                      double radii_m[2], double axes[2][2])
{
    double mean = 0.5 * (curvature[0] + curvature[2]);
    double half = 0.5 * (curvature[0] - curvature[2]);
    double root = hypot(half, curvature[1]);
    /* The eigenvalue of greater size, and its direction. */
    double sign = mean < 0.0 ? -1.0 : 1.0;
    double greater = mean + sign * root, smaller = mean - sign * root;
    double x = sign * half + root, y = sign * curvature[1];
    if (!(x * x + y * y > 0.0)) {
        x = 0.0;
        y = 1.0;
    }
    if (!(root > 0.0)) {
        x = 1.0;
        y = 0.0;
    }
    double length = hypot(x, y);
    axes[0][0] = x / length;
    axes[0][1] = y / length;
    axes[1][0] = -axes[0][1];
    axes[1][1] = axes[0][0];
    const double eigenvalues[2] = {fabs(greater), fabs(smaller)};
    for (int i = 0; i < 2; i++) {
        double radius = sqrt(sqrt(4.0 * error / (PP_PI * eigenvalues[i])));
        radii_m[i] = radius < most_m ? radius : most_m; /* also where it is infinite */
    }
    radii_m[1] = fmin(radii_m[1], LONGEST * radii_m[0]);
}

/* How far the surface is clear all round, by what low rays met: the least distance
 * along the surface in each sector. */
static void look_round(const struct pp_hemisphere *h, struct pp_cache_entry *entry)
{
    int cells = h->side * h->side;
    for (int i = 0; i < PP_CACHE_SECTORS; i++)
        entry->horizon_m[i] = INFINITY;
    for (int k = 0; k < cells; k++) {
        const struct pp_hemisphere_cell *cell = &h->cells[k];
        if (cell->to.z > LOW || !isfinite(cell->distance_m))
            continue;
        double *clear = &entry->horizon_m[pp_cache_sector(cell->to.x, cell->to.y)];
        double distance = cell->distance_m * hypot(cell->to.x, cell->to.y);
        *clear = fmin(*clear, distance);
    }
}

/* By its gradient, a record is not to say twice its value or none at all. */
static double limit_by_gradient(double radius, double value, const double along[2],
                                const double axis[2])
{
    double change = fabs(along[0] * axis[0] + along[1] * axis[1]);
    return change * radius > value ? value / change : radius;
}

void pp_cache_work(const struct pp_cache_maker *maker, struct pp_radiance_walk *walk,
                   const struct pp_cache_place *place, struct pp_hemisphere_cell *cells,
                   struct pp_cache_entry *entry)
{
    struct pp_hemisphere h = {
        .side = maker->side, .corners = maker->corners, .cells = cells};
    struct pp_irradiance_change change;
    pp_hemisphere_sample(&h, walk, place, maker->supersamples);
    pp_hemisphere_change(&h, &change);

    struct pp_cache_record *is = &entry->is;
    is->point = place->point;
    is->normal = place->normal;
    is->space = place->space;
    is->value = h.irradiance;
    entry->a = h.a;
    entry->b = h.b;
    for (int c = 0; c < 3; c++) {
        is->along[c] =
            pp_along(pp_scale(h.a, change.along[c][0]), change.along[c][1], h.b);
        is->turned[c] =
            pp_along(pp_scale(h.a, change.turned[c][0]), change.turned[c][1], h.b);
    }
    look_round(&h, entry);

    double value = pp_rgb_luminance(h.irradiance);
    double luminance[2], relative[3] = {0.0, 0.0, 0.0}, axes[2][2];
    for (int i = 0; i < 2; i++)
        luminance[i] = pp_rgb_luminance(
            pp_rgb(change.along[0][i], change.along[1][i], change.along[2][i]));
    for (int i = 0; value > 0.0 && i < 3; i++)
        relative[i] = change.curvature[i] / value;
    pp_cache_ellipse(relative, maker->error, maker->most_m, is->radii_m, axes);
    for (int i = 0; i < 2; i++) {
        is->axes[i] = pp_along(pp_scale(h.a, axes[i][0]), axes[i][1], h.b);
        is->radii_m[i] =
            fmax(limit_by_gradient(is->radii_m[i], value, luminance, axes[i]),
                 maker->least_m);
    }
}
