/* pepper_pot_cloud.c - tabulates the light by rings and cells, and maps the lattice
 * through the inverse of both tables. */
#include "methods/pepper_pot/pepper_pot_cloud.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/angle.h"
#include "model/geometry/min_max.h"
#include "model/light/glass_curve.h"

enum { RINGS = 180, CELLS = 240 };
static const double d_psi = 2.0 * PP_PI / CELLS;

/* The receiver's normal and two directions perpendicular to it. Azimuths about the
 * normal begin on the side away from the glass. */
struct frame {
    struct pp_vec3 normal, first, second;
    bool is_mirror; /* the light is the same at equal azimuths to the left and right */
};

static struct frame frame_of(struct pp_vec3 normal, const struct pp_window_axes *axes,
                             const struct pp_sky *sky)
{
    struct pp_vec3 back =
        pp_vec_along(axes->out, -pp_vec_dot(axes->out, normal), normal);
    if (pp_vec_length(back) < 1e-6)
        back = pp_vec_along(axes->along, -pp_vec_dot(axes->along, normal), normal);
    struct pp_vec3 first = pp_vec_unit(pp_vec_scale(back, -1.0));
    struct pp_vec3 second = pp_vec_cross(normal, first);
    bool is_mirror = !pp_sky_has_azimuth(sky) && fabs(second.z) < 1e-12
                     && fabs(pp_vec_dot(second, axes->out)) < 1e-12;
    return (struct frame){normal, first, second, is_mirror};
}

/* The unit vector of an azimuth, perpendicular to the normal. */
static struct pp_vec3 aside_at(const struct frame *frame, double psi)
{
    struct pp_vec3 u = pp_vec_scale(frame->first, cos(psi));
    return pp_vec_along(u, sin(psi), frame->second);
}

static struct pp_vec3 direction(const struct frame *frame, struct pp_angle theta,
                                struct pp_vec3 aside)
{
    struct pp_vec3 u = pp_vec_scale(frame->normal, theta.cosine);
    return pp_vec_along(u, theta.sine, aside);
}

/* Direction of a cell's azimuth, and its component along the normal of the glass. */
struct cell_side {
    struct pp_vec3 aside;
    double out;
};

/* Accumulates the light of a ring's cells: up_to[k] is the light of the first k cells.
 * Rings are equally wide in angle; sine times cosine is integrated over each ring,
 * which is exact for a uniform sky. */
static void fill_ring(double up_to[CELLS + 1], int ring,
                      const struct cell_side sides[CELLS], const struct pp_sky *sky,
                      const struct pp_glass_curve *losses, struct pp_vec3 out,
                      const struct frame *frame)
{
    double d_theta = PP_PI / 2.0 / RINGS;
    double middle = (ring + 0.5) * d_theta;
    double weight = sin(2.0 * middle) * sin(d_theta) / 2.0 * d_psi;
    struct pp_angle theta = pp_angle_of(middle);
    double light[CELLS], ahead = theta.cosine * pp_vec_dot(frame->normal, out);
    int asked = frame->is_mirror ? CELLS / 2 : CELLS;
    for (int k = 0; k < asked; k++) {
        double cosine = ahead + theta.sine * sides[k].out;
        light[k] = 0.0;
        if (!(cosine > 0.0))
            continue;
        struct pp_vec3 u = direction(frame, theta, sides[k].aside);
        if (u.z > 0.0)
            light[k] = pp_sky_luminance(sky, u) * weight
                       * pp_glass_curve_transmittance(losses, pp_min(cosine, 1.0));
    }
    for (int k = asked; k < CELLS; k++)
        light[k] = light[CELLS - 1 - k];
    up_to[0] = 0.0;
    for (int k = 0; k < CELLS; k++)
        up_to[k + 1] = up_to[k] + light[k];
}

/* Position of `value`, 0 to 1, within a step over which a sum grows from `low` to
 * `high`. */
static double step_share(double low, double high, double value)
{
    double step = high - low;
    return step > 0.0 ? fmin((value - low) / step, 1.0) : 0.5;
}

/* Position of `value` in an ascending list of `count` + 1 values, from 0 to count. */
static double ascending_position(const double *ascending, int count, double value)
{
    int low = 0, high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (ascending[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    return low + step_share(ascending[low], ascending[low + 1], value);
}

/* Least cosine of the angle between a dot's direction and the normal of the glass. Dots
 * of cells that the glass plane cuts are placed in front of that plane. */
static const double least_cosine = 1e-3;

static void place_dot(struct pp_pepper_pot_cloud *cloud, double ring,
                      const double up_to[CELLS + 1], const struct frame *frame,
                      const struct pp_window_axes *axes)
{
    static const double golden = 0.61803398874989484820; /* (sqrt 5 - 1)/2 */
    double *dot = cloud->dots[cloud->count];
    double whole, s = modf((cloud->count + 0.5) * golden, &whole);
    double theta = ring / RINGS * PP_PI / 2.0;
    double psi =
        ascending_position(up_to, CELLS, s * up_to[CELLS]) / CELLS * 2.0 * PP_PI;
    struct pp_vec3 u = direction(frame, pp_angle_of(theta), aside_at(frame, psi));
    double out = fmax(pp_vec_dot(u, axes->out), least_cosine);
    dot[0] = pp_vec_dot(u, axes->along) / out;
    dot[1] = pp_vec_dot(u, axes->up) / out;
    cloud->count++;
}

/* Places the dots ring by ring, according to the cumulative light of the rings. */
static enum pp_status place_dots(struct pp_pepper_pot_cloud *cloud,
                                 const struct pp_sky *sky, const struct pp_glass *glass,
                                 const struct pp_window_axes *axes,
                                 const struct frame *frame, double worth,
                                 struct pp_error *err)
{
    double up_to[CELLS + 1];
    struct cell_side sides[CELLS];
    struct pp_glass_curve losses;
    int room = 0;
    pp_glass_curve_init(&losses, glass);
    for (int k = 0; k < CELLS; k++) {
        struct pp_vec3 aside = aside_at(frame, (k + 0.5) * d_psi);
        sides[k] = (struct cell_side){aside, pp_vec_dot(aside, axes->out)};
    }
    for (int i = 0; i < RINGS; i++) {
        fill_ring(up_to, i, sides, sky, &losses, axes->out, frame);
        double before = cloud->whole;
        cloud->whole += up_to[CELLS];
        int count = (int)fmax(ceil(cloud->whole / worth - 0.5), 0.0);
        enum pp_status status =
            pp_array_reserve(&cloud->dots, &room, count, sizeof *cloud->dots, err);
        if (status != PP_OK)
            return status;
        while (cloud->count < count)
            place_dot(
                cloud,
                i + step_share(before, cloud->whole, (cloud->count + 0.5) * worth),
                up_to, frame, axes);
    }
    return PP_OK;
}

enum pp_status pp_pepper_pot_cloud_init(struct pp_pepper_pot_cloud *cloud,
                                        const struct pp_sky *sky,
                                        const struct pp_glass *glass,
                                        const struct pp_window_axes *axes,
                                        struct pp_vec3 normal, double worth,
                                        struct pp_error *err)
{
    *cloud = (struct pp_pepper_pot_cloud){0};
    const struct frame frame = frame_of(normal, axes, sky);
    enum pp_status status = place_dots(cloud, sky, glass, axes, &frame, worth, err);
    if (status != PP_OK)
        pp_pepper_pot_cloud_clear(cloud);
    return status;
}

void pp_pepper_pot_cloud_clear(struct pp_pepper_pot_cloud *cloud)
{
    free(cloud->dots);
    *cloud = (struct pp_pepper_pot_cloud){0};
}

int pp_pepper_pot_cloud_count(const struct pp_pepper_pot_cloud *cloud,
                              const struct pp_region *region)
{
    return pp_region_count_inside(region, cloud->dots, cloud->count);
}
