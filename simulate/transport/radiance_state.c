/* radiance_state.c - follows and counts the rays of a path, and shadow rays through
 * clear surfaces and by plane mirrors. */
#include "simulate/transport/radiance_state.h"

#include <math.h>

#include "simulate/scene/light_scene_parts.h"

/* Greatest number of clear surfaces that a shadow ray passes. */
enum { MOST_PANES = 64 };

struct pp_radiance_options pp_radiance_state_defaults(void)
{
    return (struct pp_radiance_options){.sources = true,
                                        .windows = true,
                                        .stored = true,
                                        .source_size = 0.2,
                                        .source_most = 64,
                                        .bounces = -1,
                                        .least = 0.3};
}

enum pp_meeting pp_radiance_state_meet(struct pp_radiance_state *state,
                                       const struct pp_light_ray *ray,
                                       struct pp_light_hit *hit)
{
    return pp_radiance_state_meet_by(state, ray, NULL, hit);
}

enum pp_meeting pp_radiance_state_meet_by(struct pp_radiance_state *state,
                                          const struct pp_light_ray *ray,
                                          const struct pp_convex_nearest *nearest,
                                          struct pp_light_hit *hit)
{
    state->rays++;
    if (state->log && state->log->count < state->log->capacity)
        state->log->rays[state->log->count++] = *ray;
    enum pp_meeting meeting = pp_light_scene_meet_by(state->scene, ray, nearest, hit);
    state->leaks += meeting == PP_MEETS_LEAK;
    return meeting;
}

bool pp_radiance_state_unoccluded(struct pp_radiance_state *state,
                                  struct pp_light_ray ray, int part, double distance_m,
                                  struct pp_rgb *through)
{
    const struct pp_light_scene *scene = state->scene;
    double gone = 0.0;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_radiance_state_meet(state, &ray, &hit);
        if (meeting == PP_MEETS_ENVIRONMENT)
            return part < 0 && isinf(hit.distance_m);
        if (meeting != PP_MEETS_PART)
            return false;
        gone += hit.distance_m;
        if (hit.part == part && fabs(gone - distance_m) < 1e-4 * distance_m + 1e-5)
            return true;
        if (!pp_light_scene_parts_pass(scene, &hit, &ray, through))
            return false;
    }
    return false;
}

bool pp_radiance_state_reach_mirror(struct pp_radiance_state *state,
                                    struct pp_light_ray *ray, int index, double *left_m,
                                    struct pp_rgb *through)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_mirror *mirror = &scene->mirrors[index];
    double t = (mirror->offset_m - pp_vec_dot(mirror->normal, ray->from))
               / pp_vec_dot(mirror->normal, ray->to);
    if (!(t > 0.0 && t < *left_m))
        return false;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        if (pp_radiance_state_meet(state, ray, &hit) != PP_MEETS_PART)
            return false;
        *left_m -= hit.distance_m;
        if (scene->parts[hit.part].mirror == index)
            return pp_light_scene_parts_reflect(scene, &hit, ray, through);
        if (!pp_light_scene_parts_pass(scene, &hit, ray, through))
            return false;
    }
    return false;
}
