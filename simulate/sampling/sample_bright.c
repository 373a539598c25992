/* sample_bright.c - see sample_bright.h. */
#include "simulate/sampling/sample_bright.h"

#include <math.h>

#include "simulate/sampling/lobe.h"
#include "simulate/sampling/triangle.h"

static double share_of_count(const struct pp_sky_bright *bright, int count)
{
    return fmin(1.0, 2.0 * bright->share) * (1.0 + 7.0 * count / PP_SKY_BRIGHT_SOME)
           / 16.0;
}

/* Finds the point where a ray from `from` meets the front of the target. */
static bool meets_target(const struct pp_target *target, struct pp_vec3 from,
                         struct pp_vec3 to, struct pp_direction_sample *sample)
{
    double toward = -pp_vec_dot(to, target->normal);
    if (!(toward > 0.0))
        return false;
    sample->direction = to;
    sample->distance_m = pp_target_height(target, from) / toward;
    sample->point = pp_vec_along(from, sample->distance_m, to);
    if (target->rectangle)
        return pp_target_rectangle_has(target, sample->point);
    for (int i = 0; i < target->triangle_count; i++)
        if (pp_triangle_has(target->triangles[i], sample->point))
            return true;
    return false;
}

double pp_sample_bright_share_of_target(const struct pp_sky_bright *bright,
                                        const struct pp_target *target,
                                        struct pp_vec3 from, struct pp_vec3 n)
{
    struct pp_direction_sample sample;
    int count = 0;
    for (int i = 0; i < PP_SKY_BRIGHT_SOME; i++)
        count += pp_vec_dot(n, bright->some[i]) > 0.0
                 && meets_target(target, from, bright->some[i], &sample);
    return share_of_count(bright, count);
}

bool pp_sample_bright_draw_to_target(const struct pp_sky_bright *bright,
                                     const struct pp_target *target,
                                     struct pp_vec3 from, double u, double v,
                                     struct pp_direction_sample *sample)
{
    return meets_target(target, from, pp_sky_bright_draw(bright, u, v), sample);
}

double pp_sample_bright_lobe(const struct pp_sky_bright *bright, struct pp_vec3 a,
                             struct pp_vec3 b, struct pp_vec3 n, double u, double v,
                             struct pp_vec3 *to)
{
    if (!bright) {
        *to = pp_lobe_sample_in_frame(a, b, n, u, v);
        return 1.0;
    }
    int count = 0;
    for (int i = 0; i < PP_SKY_BRIGHT_SOME; i++)
        count += pp_vec_dot(n, bright->some[i]) > 0.0;
    double share = share_of_count(bright, count);
    *to = u < share ? pp_sky_bright_draw(bright, u / share, v)
                    : pp_lobe_sample_in_frame(a, b, n, (u - share) / (1.0 - share), v);
    double own = pp_vec_dot(n, *to) / PP_PI;
    if (!(own > 0.0))
        return 0.0;
    return own / ((1.0 - share) * own + share * pp_sky_bright_pdf(bright, *to));
}
