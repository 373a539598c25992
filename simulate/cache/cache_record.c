/* cache_record.c - the ellipse, horizon and limits of a record, from its hemisphere. */
#include "simulate/cache/cache_record.h"

#include <math.h>

#include "simulate/cache/cache_derivatives.h"

/* Largest ratio of the axes of a record's ellipse. Chosen by trial. */
static const double LONGEST = 3.0;

/* Least distance of surfaces in the derivatives, as a multiple of the smallest radius
 * allowed. With nearer surfaces, the gradient would only be noise of the rays. Chosen
 * by trial. */
static const double NEAREST = 4.0;

/* Rays whose sine of altitude is at most this determine the clear distance along the
 * surface. Chosen by trial. */
static const double LOW = 0.4;

void pp_cache_record_ellipse(const double curvature[3], double error, double most_m,
                             double radii_m[2], double axes[2][2])
{
    double mean = 0.5 * (curvature[0] + curvature[2]);
    double half = 0.5 * (curvature[0] - curvature[2]);
    double root = hypot(half, curvature[1]);
    /* The eigenvalue of greater magnitude, and its direction. */
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
        radii_m[i] = radius < most_m ? radius : most_m; /* also if radius is infinite */
    }
    radii_m[1] = fmin(radii_m[1], LONGEST * radii_m[0]);
}

/* Direction of the border between sectors s - 1 and s, along a and b; its length is
 * arbitrary. */
static void sector_border(int s, double u[2])
{
    enum { QUARTER = PP_CACHE_SECTORS / 4 };
    u[1] = (double)(s % QUARTER) / QUARTER;
    u[0] = 1.0 - u[1];
    for (int turn = 0; turn < s / QUARTER % 4; turn++) {
        double along_a = u[0];
        u[0] = -u[1];
        u[1] = along_a;
    }
}

/* Distance along direction u of the surface to the plane that the cell's ray met;
 * INFINITY if the plane is not in front. */
static double plane_distance(const struct pp_cache_hemisphere_cell *cell,
                             const double u[2])
{
    double length = hypot(u[0], u[1]);
    double towards = (cell->facing.x * u[0] + cell->facing.y * u[1]) / length;
    double off = cell->distance_m * pp_vec_dot(cell->facing, cell->to);
    return towards < 0.0 && off < 0.0 ? off / towards : INFINITY;
}

/* Least distance along the surface, within the sector, to the plane that the cell's ray
 * met. */
static double clear_of(const struct pp_cache_hemisphere_cell *cell, int sector)
{
    double ends[2][2], square[2] = {-cell->facing.x, -cell->facing.y};
    sector_border(sector, ends[0]);
    sector_border(sector + 1, ends[1]);
    double clear = fmin(plane_distance(cell, ends[0]), plane_distance(cell, ends[1]));
    if (hypot(square[0], square[1]) > 1e-9
        && pp_cache_entry_sector(square[0], square[1]) == sector)
        clear = fmin(clear, plane_distance(cell, square));
    return clear;
}

/* Finds the clear distance along the surface in each sector from the surfaces that low
 * rays met. A ray counts in its own sector and in both neighbouring sectors, which may
 * contain no ray. */
static void find_horizon(const struct pp_cache_hemisphere *h,
                         struct pp_cache_entry *entry)
{
    int n = h->side;
    for (int i = 0; i < PP_CACHE_SECTORS; i++)
        entry->horizon_m[i] = INFINITY;
    for (int k = 0; k < n * n; k++) {
        const struct pp_cache_hemisphere_cell *cell = &h->cells[k];
        bool rim = k % n == 0 || k % n == n - 1 || k < n || k >= n * (n - 1);
        if ((cell->to.z > LOW && !rim) || !isfinite(cell->distance_m))
            continue;
        int own = pp_cache_entry_sector(cell->to.x, cell->to.y);
        for (int step = -1; step <= 1; step++) {
            int sector = (own + step + PP_CACHE_SECTORS) % PP_CACHE_SECTORS;
            double clear = clear_of(cell, sector);
            if (step == 0)
                clear = fmin(clear, cell->distance_m * hypot(cell->to.x, cell->to.y));
            entry->horizon_m[sector] = fmin(entry->horizon_m[sector], clear);
        }
    }
}

/* The radius, limited so that the gradient changes the value by at most 100 % over this
 * radius. */
static double limit_by_gradient(double radius, double value, const double along[2],
                                const double axis[2])
{
    double change = fabs(along[0] * axis[0] + along[1] * axis[1]);
    return change * radius > value ? value / change : radius;
}

/* Limits the gradient so that the change over the ellipse is at most the value itself.
 * Next to an edge, where the radius is the smallest allowed, the gradient is
 * unbounded. */
static void limit_gradient(struct pp_cache_record *is, double value,
                           const double along[2], const double axes[2][2])
{
    double change[2];
    for (int i = 0; i < 2; i++)
        change[i] = is->radii_m[i] * (along[0] * axes[i][0] + along[1] * axes[i][1]);
    double most = hypot(change[0], change[1]);
    for (int c = 0; most > value && c < 3; c++)
        is->along[c] = pp_vec_scale(is->along[c], value / most);
}

/* Greatest second derivative, less the part that may be noise. */
static double sure_curvature(const double curvature[3], double noise)
{
    double mean = 0.5 * (curvature[0] + curvature[2]);
    double root = hypot(0.5 * (curvature[0] - curvature[2]), curvature[1]);
    double greatest = fabs(mean) + root;
    return greatest > noise ? sqrt(greatest * greatest - noise * noise) : 0.0;
}

/* The vector with these components along the frame's tangential axes. */
static struct pp_vec3 in_surface(const struct pp_frame *frame, const double along[2])
{
    return pp_vec_along(pp_vec_scale(frame->x, along[0]), along[1], frame->y);
}

void pp_cache_record_compute(const struct pp_cache_record_settings *settings,
                             struct pp_radiance_state *state,
                             const struct pp_cache_place *place,
                             struct pp_cache_hemisphere_cell *cells,
                             struct pp_cache_entry *entry)
{
    struct pp_cache_hemisphere h = {.side = settings->side,
                                    .corners = settings->corners,
                                    .cells = cells,
                                    .nearest_m = NEAREST * settings->least_m};
    struct pp_irradiance_change change;
    pp_cache_hemisphere_sample(&h, state, place, settings->supersamples);
    pp_cache_derivatives_hemisphere(&h, &change);

    struct pp_cache_record *is = &entry->is;
    is->point = place->point;
    is->normal = place->normal;
    is->space = place->space;
    is->value = h.irradiance;
    entry->a = h.frame.x;
    entry->b = h.frame.y;
    for (int c = 0; c < 3; c++) {
        is->along[c] = in_surface(&h.frame, change.along[c]);
        is->turned[c] = in_surface(&h.frame, change.turned[c]);
    }
    entry->along_noise = change.along_noise;
    find_horizon(&h, entry);

    double value = pp_rgb_luminance(h.irradiance);
    double luminance[2], relative[3] = {0.0, 0.0, 0.0}, axes[2][2];
    for (int i = 0; i < 2; i++)
        luminance[i] = pp_rgb_luminance(
            pp_rgb(change.along[0][i], change.along[1][i], change.along[2][i]));
    for (int i = 0; value > 0.0 && i < 3; i++)
        relative[i] = change.curvature[i] / value;
    entry->curvature =
        sure_curvature(relative, settings->noise * change.curvature_noise);
    pp_cache_record_ellipse(relative, settings->error, settings->most_m, is->radii_m,
                            axes);
    for (int i = 0; i < 2; i++) {
        double radius_m = limit_by_gradient(is->radii_m[i], value, luminance, axes[i]);
        is->radii_m[i] = fmax(radius_m, settings->least_m);
        is->axes[i] = in_surface(&h.frame, axes[i]);
    }
    limit_gradient(is, value, luminance, axes);
}
