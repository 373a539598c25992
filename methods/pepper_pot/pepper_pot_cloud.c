/* pepper_pot_cloud.c - light by rings and cells, and the lattice taken back through both. */
#include "methods/pepper_pot/pepper_pot_cloud.h"

#include <math.h>
#include <stdlib.h>

enum { RINGS = 180, CELLS = 240 };

/* Light of the cells up to the end of each, ring by ring; that of the rings up to each. */
struct cells {
    double within[RINGS + 1];
    double up_to[RINGS][CELLS + 1];
};

/* The receiver's normal and two directions square to it; azimuths about it begin on the
 * far side from the glass. */
struct frame {
    struct pp_vec3 normal, first, second;
};

static struct frame frame_of(struct pp_vec3 normal, const struct pp_window_axes *axes)
{
    struct pp_vec3 back =
        pp_vec_along(axes->out, -pp_vec_dot(axes->out, normal), normal);
    if (pp_vec_length(back) < 1e-6)
        back = pp_vec_along(axes->along, -pp_vec_dot(axes->along, normal), normal);
    struct pp_vec3 first = pp_vec_unit(pp_vec_scale(back, -1.0));
    return (struct frame){normal, first, pp_vec_cross(normal, first)};
}

struct angle {
    double sine, cosine;
};

static struct angle angle_of(double rad)
{
    return (struct angle){sin(rad), cos(rad)};
}

static struct pp_vec3 direction(const struct frame *frame, struct angle theta,
                                struct angle psi)
{
    struct pp_vec3 u = pp_vec_scale(frame->normal, theta.cosine);
    u = pp_vec_along(u, theta.sine * psi.cosine, frame->first);
    return pp_vec_along(u, theta.sine * psi.sine, frame->second);
}

/* Rings are as wide in angle; each has its sines times cosines as a whole, which is exact
 * for an even sky. */
static void fill(struct cells *cells, const struct pp_sky *sky,
                 const struct pp_glass *glass, struct pp_vec3 out,
                 const struct frame *frame)
{
    double d_theta = PP_PI / 2.0 / RINGS, d_psi = 2.0 * PP_PI / CELLS;
    struct angle psi[CELLS];
    for (int k = 0; k < CELLS; k++)
        psi[k] = angle_of((k + 0.5) * d_psi);
    cells->within[0] = 0.0;
    for (int i = 0; i < RINGS; i++) {
        double theta = (i + 0.5) * d_theta;
        double weight = sin(2.0 * theta) * sin(d_theta) / 2.0 * d_psi;
        struct angle ring = angle_of(theta);
        cells->up_to[i][0] = 0.0;
        for (int k = 0; k < CELLS; k++) {
            struct pp_vec3 u = direction(frame, ring, psi[k]);
            double cosine = fmin(pp_vec_dot(u, out), 1.0);
            double light = u.z > 0.0 && cosine > 0.0
                               ? pp_sky_luminance(sky, u) * weight
                                     * pp_glass_transmittance(glass, cosine)
                               : 0.0;
            cells->up_to[i][k + 1] = cells->up_to[i][k] + light;
        }
        cells->within[i + 1] = cells->within[i] + cells->up_to[i][CELLS];
    }
}

/* Where an ascending list of `count` + 1 values reaches `value`, from 0 to count. */
static double place_of(const double *ascending, int count, double value)
{
    int low = 0, high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (ascending[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    double step = ascending[low + 1] - ascending[low];
    return low + (step > 0.0 ? fmin((value - ascending[low]) / step, 1.0) : 0.5);
}

/* Dots of cells that the plane of the glass cuts are taken to lie before it. */
static const double least_cosine = 1e-3;

static void place_dots(struct pp_pepper_pot_cloud *cloud, const struct cells *cells,
                       const struct frame *frame, const struct pp_window_axes *axes,
                       double worth)
{
    static const double golden = 0.61803398874989484820; /* (sqrt 5 - 1)/2 */
    for (int i = 0; i < cloud->count; i++) {
        double whole, s = modf((i + 0.5) * golden, &whole);
        double ring = place_of(cells->within, RINGS, (i + 0.5) * worth);
        const double *up_to = cells->up_to[(int)fmin(ring, RINGS - 1)];
        double theta = ring / RINGS * PP_PI / 2.0;
        double psi = place_of(up_to, CELLS, s * up_to[CELLS]) / CELLS * 2.0 * PP_PI;
        struct pp_vec3 u = direction(frame, angle_of(theta), angle_of(psi));
        double out = fmax(pp_vec_dot(u, axes->out), least_cosine);
        cloud->dots[i][0] = pp_vec_dot(u, axes->along) / out;
        cloud->dots[i][1] = pp_vec_dot(u, axes->up) / out;
    }
}

enum pp_status pp_pepper_pot_cloud_init(struct pp_pepper_pot_cloud *cloud,
                                        const struct pp_sky *sky,
                                        const struct pp_glass *glass,
                                        const struct pp_window_axes *axes,
                                        struct pp_vec3 normal, double worth,
                                        struct pp_error *err)
{
    *cloud = (struct pp_pepper_pot_cloud){0};
    struct cells *cells = malloc(sizeof *cells);
    if (!cells)
        return pp_fail_memory(err);
    const struct frame frame = frame_of(normal, axes);
    fill(cells, sky, glass, axes->out, &frame);
    cloud->whole = cells->within[RINGS];
    cloud->count = (int)fmax(ceil(cloud->whole / worth - 0.5), 0.0);
    cloud->dots = malloc(((size_t)cloud->count + 1) * sizeof *cloud->dots);
    if (cloud->dots)
        place_dots(cloud, cells, &frame, axes, worth);
    free(cells);
    if (cloud->dots)
        return PP_OK;
    *cloud = (struct pp_pepper_pot_cloud){0};
    return pp_fail_memory(err);
}

void pp_pepper_pot_cloud_clear(struct pp_pepper_pot_cloud *cloud)
{
    free(cloud->dots);
    *cloud = (struct pp_pepper_pot_cloud){0};
}

int pp_pepper_pot_cloud_count(const struct pp_pepper_pot_cloud *cloud,
                              const struct pp_region *region)
{
    int count = 0;
    for (int i = 0; i < cloud->count; i++)
        count +=
            pp_region_contains(region, cloud->dots[i][0], cloud->dots[i][1]) ? 1 : 0;
    return count;
}
