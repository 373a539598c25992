/* radiance.c - starts paths at an eye or at a sensor. */
#include "simulate/transport/radiance.h"

#include "simulate/sampling/lobe.h"
#include "simulate/transport/light_path.h"
#include "simulate/transport/light_sources.h"

static struct pp_rgb along(struct pp_radiance_state *state,
                           const struct pp_light_ray *ray,
                           enum pp_directly_sampled sampled, struct pp_light_hit *hit)
{
    struct pp_light_path path = {.ray = *ray,
                                 .throughput = pp_rgb_grey(1.0),
                                 .least = state->options.least,
                                 .sampled = sampled,
                                 .sampled_in = ray->space,
                                 .from_diffuse = sampled == PP_DIRECTLY_SAMPLED_ALL,
                                 .mirror_path = -1,
                                 .arrival = {.reflector = -1},
                                 .depth = sampled == PP_DIRECTLY_SAMPLED_ALL,
                                 .vertex = 1,
                                 .split = sampled == PP_DIRECTLY_SAMPLED_NONE};
    path.ray.from = pp_vec_sub(ray->from, state->scene->centre);
    struct pp_rgb radiance = pp_light_path_follow(state, &path, hit);
    if (hit)
        hit->point = pp_vec_add(hit->point, state->scene->centre);
    return radiance;
}

struct pp_rgb pp_radiance_along(struct pp_radiance_state *state,
                                const struct pp_light_ray *ray,
                                struct pp_light_hit *hit)
{
    return along(state, ray, PP_DIRECTLY_SAMPLED_NONE, hit);
}

struct pp_rgb pp_radiance_indirect(struct pp_radiance_state *state,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit)
{
    return along(state, ray, PP_DIRECTLY_SAMPLED_ALL, hit);
}

struct pp_irradiance pp_radiance_direct(struct pp_radiance_state *state,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        enum pp_space space)
{
    struct pp_irradiance e = {.rest = pp_rgb_grey(0.0)};
    struct pp_shading_point shading = {.point = pp_vec_sub(point, state->scene->centre),
                                       .normal = normal,
                                       .space = space,
                                       .diffuse = pp_rgb_grey(PP_PI),
                                       .split = true};
    e.sources = pp_light_sources_next_event(state, &shading);
    pp_light_path_windows(state, &shading, &e);
    return e;
}

struct pp_irradiance pp_radiance_irradiance(struct pp_radiance_state *state,
                                            struct pp_vec3 point, struct pp_vec3 normal,
                                            enum pp_space space)
{
    struct pp_irradiance e = pp_radiance_direct(state, point, normal, space);
    if (state->options.bounces == 0)
        return e;
    double u[2];
    struct pp_vec3 a, b;
    pp_sobol_sequence_draw(&state->sequence, state->index, 0, 2, u);
    pp_lobe_frame(normal, &a, &b);
    struct pp_light_ray ray = {
        point, normal, pp_lobe_sample_in_frame(a, b, normal, u[0], u[1]), space};
    e.rest = pp_rgb_along(e.rest, PP_PI, pp_radiance_indirect(state, &ray, NULL));
    return e;
}
