/* cache_derivatives.c - gradients and Hessian summed over the edges of a hemisphere's
 * cells. Formula numbers are those of cache_derivatives.h. */
#include "simulate/cache/cache_derivatives.h"

#include <math.h>

/* Squared sine of the angle below which an edge counts as collinear with the place. */
static const double IN_LINE = 1e-16;

/* int_0^1 t^m / Q^n dt, Q = a t^2 + 2 b t + c. */
struct integrals {
    double i1, i2, i3; /* m = 0 */
    double j2, j3;     /* m = 1 */
    double k3;         /* m = 2 */
};

static bool integrate_edge(double a, double b, double c, struct integrals *is)
{
    double d = a * c - b * b;
    if (!(d > IN_LINE * a * c))
        return false;
    double end = a + 2.0 * b + c; /* Q(1) */
    double root = sqrt(d);
    is->i1 = atan2(root, b + c) / root; /* angle between the ends, divided by root */
    is->i2 = ((a + b) / end - b / c + a * is->i1) / (2.0 * d);
    is->i3 = ((a + b) / (end * end) - b / (c * c) + 3.0 * a * is->i2) / (4.0 * d);
    is->j2 = (0.5 * (1.0 / c - 1.0 / end) - b * is->i2) / a;
    is->j3 = (0.25 * (1.0 / (c * c) - 1.0 / (end * end)) - b * is->i3) / a;
    is->k3 = (is->i2 - 2.0 * b * is->j3 - c * is->i3) / a;
    return true;
}

void pp_cache_derivatives_edge(struct pp_vec3 r, struct pp_vec3 r1, double gradient[2],
                               double hessian[3])
{
    struct pp_vec3 e = pp_vec_sub(r1, r);
    struct integrals is;
    gradient[0] = gradient[1] = hessian[0] = hessian[1] = hessian[2] = 0.0;
    if (!integrate_edge(pp_vec_dot(e, e), pp_vec_dot(r, e), pp_vec_dot(r, r), &is))
        return;
    double A = r.x * e.y - r.y * e.x;
    double w[2] = {e.y, -e.x};
    double g[2] = {2.0 * (r.x * is.i2 + e.x * is.j2),
                   2.0 * (r.y * is.i2 + e.y * is.j2)};
    double H[3] = {
        8.0 * (r.x * r.x * is.i3 + 2.0 * r.x * e.x * is.j3 + e.x * e.x * is.k3)
            - 2.0 * is.i2,
        8.0 * (r.x * r.y * is.i3 + (r.x * e.y + e.x * r.y) * is.j3 + e.x * e.y * is.k3),
        8.0 * (r.y * r.y * is.i3 + 2.0 * r.y * e.y * is.j3 + e.y * e.y * is.k3)
            - 2.0 * is.i2};
    for (int i = 0; i < 2; i++)
        gradient[i] = 0.5 * (A * g[i] - w[i] * is.i1);
    hessian[0] = 0.5 * (A * H[0] - 2.0 * w[0] * g[0]);
    hessian[1] = 0.5 * (A * H[1] - w[0] * g[1] - w[1] * g[0]);
    hessian[2] = 0.5 * (A * H[2] - 2.0 * w[1] * g[1]);
}

static const struct pp_cache_hemisphere_cell *nearer(
    const struct pp_cache_hemisphere_cell *p, const struct pp_cache_hemisphere_cell *q)
{
    return p->distance_m <= q->distance_m ? p : q;
}

/* Intersection of direction u with the plane of the surface seen in the cell. If the
 * distance there differs from the cell's distance by more than a factor of 2, the
 * cell's distance is used. */
static struct pp_vec3 on_surface(const struct pp_cache_hemisphere *h,
                                 const struct pp_cache_hemisphere_cell *cell,
                                 struct pp_vec3 u)
{
    double here = pp_vec_dot(cell->facing, cell->to),
           there = pp_vec_dot(cell->facing, u);
    double ratio = there < 0.0 && here < 0.0 ? here / there : 1.0;
    if (!(ratio > 0.5 && ratio < 2.0))
        ratio = 1.0;
    return pp_vec_scale(u, fmax(cell->distance_m, h->nearest_m) * ratio);
}

/* Adds the derivatives of an edge between two cells. */
static void add_cell_edge(struct pp_irradiance_change *change,
                          struct pp_cache_hemisphere_cell *first,
                          struct pp_cache_hemisphere_cell *second,
                          const double gradient[2], const double hessian[3])
{
    struct pp_rgb difference = pp_rgb_sub(first->radiance, second->radiance);
    for (int i = 0; i < 2; i++) {
        first->gradient_per_radiance[i] += gradient[i];
        second->gradient_per_radiance[i] -= gradient[i];
        change->along[0][i] += difference.r * gradient[i];
        change->along[1][i] += difference.g * gradient[i];
        change->along[2][i] += difference.b * gradient[i];
    }
    for (int i = 0; i < 3; i++) {
        change->curvature[i] += pp_rgb_luminance(difference) * hessian[i];
        first->hessian_per_radiance[i] += hessian[i];
        second->hessian_per_radiance[i] -= hessian[i];
    }
}

/* Adds the edge between two cells. The edge runs from direction p to q,
 * counter-clockwise about the first cell. */
static void add_direction_edge(struct pp_irradiance_change *change,
                               const struct pp_cache_hemisphere *h,
                               struct pp_cache_hemisphere_cell *first,
                               struct pp_cache_hemisphere_cell *second,
                               struct pp_vec3 p, struct pp_vec3 q)
{
    const struct pp_cache_hemisphere_cell *near = nearer(first, second);
    if (!isfinite(near->distance_m))
        return;
    double gradient[2], hessian[3];
    pp_cache_derivatives_edge(on_surface(h, near, p), on_surface(h, near, q), gradient,
                              hessian);
    add_cell_edge(change, first, second, gradient, hessian);
}

static struct pp_vec3 corner(const struct pp_cache_hemisphere *h, int i, int j)
{
    return h->corners[j * (h->side + 1) + i];
}

static void add_edges(struct pp_irradiance_change *change,
                      const struct pp_cache_hemisphere *h)
{
    int n = h->side;
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            struct pp_cache_hemisphere_cell *cell = &h->cells[j * n + i];
            struct pp_vec3 far = corner(h, i + 1, j + 1);
            if (i + 1 < n)
                add_direction_edge(change, h, cell, cell + 1, corner(h, i + 1, j), far);
            if (j + 1 < n)
                add_direction_edge(change, h, cell, cell + n, far, corner(h, i, j + 1));
        }
}

/* Corner k of the horizon, counter-clockwise, and the cell that follows it. */
static struct pp_vec3 horizon_corner(const struct pp_cache_hemisphere *h, int k,
                                     int *cell)
{
    int n = h->side, side = k / n, at = k % n;
    switch (side) {
    case 0:
        *cell = at;
        return corner(h, at, 0);
    case 1:
        *cell = at * n + n - 1;
        return corner(h, n, at);
    case 2:
        *cell = (n - 1) * n + n - 1 - at;
        return corner(h, n - at, n);
    default:
        *cell = (n - 1 - at) * n;
        return corner(h, 0, n - at);
    }
}

/* A segment of the horizon contributes half its angle. phi is the azimuth of a corner
 * at (x, y): as the place moves, grad phi = (y, -x)/r^2. */
static void add_horizon(struct pp_irradiance_change *change,
                        const struct pp_cache_hemisphere *h)
{
    int count = 4 * h->side, before;
    horizon_corner(h, count - 1, &before);
    for (int k = 0; k < count; k++) {
        int after;
        struct pp_vec3 u = horizon_corner(h, k, &after);
        struct pp_cache_hemisphere_cell *p = &h->cells[before], *q = &h->cells[after];
        const struct pp_cache_hemisphere_cell *near = nearer(p, q);
        before = after;
        if (p == q || !isfinite(near->distance_m))
            continue;
        struct pp_vec3 r = on_surface(h, near, u);
        double r2 = r.x * r.x + r.y * r.y, r4 = r2 * r2;
        double gradient[2] = {0.5 * r.y / r2, -0.5 * r.x / r2};
        double hessian[3] = {r.x * r.y / r4, 0.5 * (r.y * r.y - r.x * r.x) / r4,
                             -r.x * r.y / r4};
        add_cell_edge(change, p, q, gradient, hessian);
    }
}

static void add_turn(struct pp_irradiance_change *change,
                     const struct pp_cache_hemisphere *h)
{
    int cells = h->side * h->side;
    for (int k = 0; k < cells; k++) {
        const struct pp_cache_hemisphere_cell *cell = &h->cells[k];
        double each = PP_PI / cells / fmax(cell->to.z, 1.0 / h->side);
        double in[2] = {each * cell->to.x, each * cell->to.y};
        for (int i = 0; i < 2; i++) {
            change->turned[0][i] += cell->radiance.r * in[i];
            change->turned[1][i] += cell->radiance.g * in[i];
            change->turned[2][i] += cell->radiance.b * in[i];
        }
    }
}

static void add_noise(struct pp_irradiance_change *change,
                      const struct pp_cache_hemisphere *h)
{
    int cells = h->side * h->side;
    double gradient2 = 0.0, hessian2 = 0.0;
    for (int k = 0; k < cells; k++) {
        const double *p = h->cells[k].gradient_per_radiance,
                     *b = h->cells[k].hessian_per_radiance;
        gradient2 += p[0] * p[0] + p[1] * p[1];
        hessian2 += b[0] * b[0] + 2.0 * b[1] * b[1] + b[2] * b[2];
    }
    change->along_noise = sqrt(0.5 * cells * gradient2) / PP_PI;
    change->curvature_noise = sqrt(cells * hessian2) / PP_PI;
}

void pp_cache_derivatives_hemisphere(struct pp_cache_hemisphere *hemisphere,
                                     struct pp_irradiance_change *change)
{
    *change = (struct pp_irradiance_change){.curvature = {0.0}};
    for (int k = 0; k < hemisphere->side * hemisphere->side; k++) {
        struct pp_cache_hemisphere_cell *cell = &hemisphere->cells[k];
        cell->gradient_per_radiance[0] = cell->gradient_per_radiance[1] = 0.0;
        cell->hessian_per_radiance[0] = cell->hessian_per_radiance[1] =
            cell->hessian_per_radiance[2] = 0.0;
    }
    add_edges(change, hemisphere);
    add_horizon(change, hemisphere);
    add_turn(change, hemisphere);
    add_noise(change, hemisphere);
}
