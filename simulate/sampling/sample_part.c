/* sample_part.c - see sample_part.h. */
#include "simulate/sampling/sample_part.h"

#include <math.h>

#include "model/geometry/bounds.h"

/* Share of the directions if the part is small. Chosen by trial in a dark well and in
 * atria with a glazed roof. */
static const double MOST_SHARE = 0.25;

/* Openings that begin behind the plane of the window by more than this (m) are left
 * out. */
static const double BEHIND_M = 0.01;

/* Adds the central projection of an opening to the bounds, within the window. */
static void add_opening(struct pp_bounds2 *bounds, const struct pp_target *target,
                        struct pp_vec3 from, const struct pp_target *beyond)
{
    double height = pp_target_height(target, from);
    struct pp_bounds2 seen = pp_bounds2_empty();
    for (int i = 0; i < 4; i++) {
        struct pp_vec3 corner = pp_target_point(beyond, i & 1 ? beyond->width_m : 0.0,
                                                i & 2 ? beyond->height_m : 0.0);
        double outside = fmax(-pp_target_height(target, corner), 0.0);
        if (pp_target_height(target, corner) > BEHIND_M)
            return;
        struct pp_vec3 at =
            pp_vec_along(pp_vec_sub(from, target->corner), height / (height + outside),
                         pp_vec_sub(corner, from));
        pp_bounds2_add(&seen, pp_vec_dot(at, target->along),
                       pp_vec_dot(at, target->up));
    }
    const double low[2] = {fmax(seen.low[0], 0.0), fmax(seen.low[1], 0.0)};
    const double high[2] = {fmin(seen.high[0], target->width_m),
                            fmin(seen.high[1], target->height_m)};
    if (!(low[0] < high[0] && low[1] < high[1]))
        return;
    pp_bounds2_add(bounds, low[0], low[1]);
    pp_bounds2_add(bounds, high[0], high[1]);
}

struct pp_seen_part pp_sample_part_of(const struct pp_target *target,
                                      struct pp_vec3 from,
                                      const struct pp_brightness *brightness)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int i = 0; i < brightness->beyond_count; i++)
        if (pp_target_height(&brightness->beyond[i], from) > 0.0)
            add_opening(&bounds, target, from, &brightness->beyond[i]);
    struct pp_seen_part part = {.x0 = bounds.low[0],
                                .x1 = bounds.high[0],
                                .y0 = bounds.low[1],
                                .y1 = bounds.high[1]};
    double area = (part.x1 - part.x0) * (part.y1 - part.y0);
    if (part.x1 > part.x0 && area < target->area_m2) {
        double left = 1.0 - area / target->area_m2;
        part.share = MOST_SHARE * left * left;
    }
    return part;
}

struct pp_vec3 pp_sample_part_draw(const struct pp_polygon_sampler *sampler, double u,
                                   double v)
{
    const struct pp_seen_part *part = &sampler->part;
    return pp_target_point(sampler->target, part->x0 + u * (part->x1 - part->x0),
                           part->y0 + v * (part->y1 - part->y0));
}

double pp_sample_part_density(const struct pp_polygon_sampler *sampler,
                              struct pp_vec3 point)
{
    const struct pp_seen_part *part = &sampler->part;
    struct pp_vec3 in = pp_vec_sub(point, sampler->target->corner);
    double x = pp_vec_dot(in, sampler->target->along);
    double y = pp_vec_dot(in, sampler->target->up);
    if (x < part->x0 || x > part->x1 || y < part->y0 || y > part->y1)
        return 0.0;
    return 1.0 / ((part->x1 - part->x0) * (part->y1 - part->y0));
}
