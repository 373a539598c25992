/* radiance.c - see radiance.h. */
#include "simulate/transport/radiance.h"

#include "simulate/transport/light_path.h"
#include "simulate/sampling/lobe.h"

struct pp_radiance_options pp_radiance_defaults(void)
{
    return (struct pp_radiance_options){.sources = true,
                                        .windows = true,
                                        .stored = true,
                                        .source_size = 0.2,
                                        .source_most = 64,
                                        .bounces = -1,
                                        .least = 0.3};
}

static struct pp_rgb along(struct pp_radiance_walk *walk,
                           const struct pp_light_ray *ray, enum pp_aimed_at aimed,
                           struct pp_light_hit *hit)
{
    struct pp_light_path path = {.ray = *ray,
                                 .weight = pp_rgb_grey(1.0),
                                 .least = walk->options.least,
                                 .aimed = aimed,
                                 .aimed_in = ray->space,
                                 .chain = -1,
                                 .depth = aimed == PP_AIMED_AT_ALL,
                                 .vertex = 1,
                                 .many = aimed == PP_AIMED_AT_NOTHING};
    path.ray.from = pp_sub(ray->from, walk->scene->centre);
    struct pp_rgb radiance = pp_light_path_follow(walk, &path, hit);
    if (hit)
        hit->point = pp_add(hit->point, walk->scene->centre);
    return radiance;
}

struct pp_rgb pp_radiance_along(struct pp_radiance_walk *walk,
                                const struct pp_light_ray *ray,
                                struct pp_light_hit *hit)
{
    return along(walk, ray, PP_AIMED_AT_NOTHING, hit);
}

struct pp_rgb pp_radiance_indirect(struct pp_radiance_walk *walk,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit)
{
    return along(walk, ray, PP_AIMED_AT_ALL, hit);
}

struct pp_irradiance pp_radiance_direct(struct pp_radiance_walk *walk,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        enum pp_space space)
{
    struct pp_irradiance e = {.rest = pp_rgb_grey(0.0)};
    struct pp_lobes lobes = {.n = normal};
    lobes.share[PP_LOBE_DIFFUSE] = pp_rgb_grey(PP_PI);
    struct pp_lit lit = {.point = pp_sub(point, walk->scene->centre),
                         .normal = normal,
                         .space = space,
                         .lobes = &lobes,
                         .many = true};
    e.sources = pp_light_from_sources(walk, &lit);
    pp_light_from_windows(walk, &lit, &e);
    return e;
}

struct pp_irradiance pp_radiance_irradiance(struct pp_radiance_walk *walk,
                                            struct pp_vec3 point, struct pp_vec3 normal,
                                            enum pp_space space)
{
    struct pp_irradiance e = pp_radiance_direct(walk, point, normal, space);
    if (walk->options.bounces == 0)
        return e;
    double u[2];
    struct pp_vec3 a, b;
    pp_sequence_draw(&walk->sequence, walk->index, 0, 2, u);
    pp_frame_about(normal, &a, &b);
    struct pp_light_ray ray = {point, normal, pp_sample_lobe(a, b, normal, u[0], u[1]),
                               space};
    e.rest = pp_rgb_scale(pp_radiance_indirect(walk, &ray, NULL), PP_PI);
    return e;
}
