/* next_event.c - directions to openings and emitters, and the light along them over the
 * density of the direction. */
#include "simulate/path_tracer/next_event.h"

#include <math.h>
#include <stddef.h>

#include "simulate/sampling/sample_discrete.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/emitters.h"
#include "simulate/scene/light_scene_parts.h"

/* theory: next event */
/* The opening that the point aims at, in proportion to a guess of the light that each
 * brings, and a direction to it: uniform over its solid angle, but for the cosine and a
 * guess of the brightness behind it. False where no direction serves. */
static bool aim_at_opening(struct pp_path_trace *path, const struct pp_lit_point *at,
                           int *pane, struct pp_light_ray *ray, double *per_pdf)
{
    const struct pp_light_scene *scene = path->scene;
    const struct pp_openings_viewer viewer = {path->environment->brightness, at->point,
                                              at->normal, false};
    double u[3], probability;
    pp_path_trace_draw(path, 3, u);
    *pane = pp_openings_choose(scene, &viewer, &path->shares, u[2], &probability);
    if (*pane < 0)
        return false;
    struct pp_polygon_sampler sampler;
    pp_sample_polygon_init(&sampler, &scene->panes[*pane].target, at->point, at->normal,
                           viewer.brightness);
    struct pp_direction_sample to = pp_sample_polygon_draw(&sampler, u[0], u[1]);
    *ray = (struct pp_light_ray){at->point, at->normal, to.direction, at->space};
    *per_pdf = to.per_density / probability;
    return true;
}

struct pp_rgb pp_next_event_openings(struct pp_path_trace *path,
                                     const struct pp_lit_point *at,
                                     enum pp_path_first *first)
{
    struct pp_rgb none = pp_rgb_grey(0.0), beta = pp_rgb_grey(1.0);
    struct pp_light_ray ray;
    struct pp_light_hit hit;
    double per_pdf;
    int pane;
    if (!aim_at_opening(path, at, &pane, &ray, &per_pdf))
        return none;
    double cosine = pp_vec_dot(at->normal, ray.to);
    if (!(cosine > 0.0) || pp_path_trace_meet(path, &ray, &hit) != PP_MEETS_PART
        || hit.part != path->scene->panes[pane].part)
        return none;

    /* Out through the pane. A path that goes on outside aims at no opening. */
    struct pp_lobes lobes;
    pp_light_scene_parts_lobes(path->scene, &hit, ray.to, &lobes);
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        if (!pp_scatter_goes_through((enum pp_lobe)i))
            lobes.share[i] = none;
    enum pp_lobe lobe = pp_path_trace_scatter(path, &lobes, &hit, &ray, &beta);
    if (lobe == PP_LOBE_COUNT)
        return none;
    struct pp_rgb L =
        pp_path_trace_radiance(path, ray, (struct pp_path_counted){0}, false, first);
    return pp_rgb_scale(pp_rgb_times(beta, L), cosine * per_pdf);
}
/* theory: end */

/* Clear surfaces that a shadow ray passes, at most. */
enum { MOST_CLEAR = 64 };

/* Does the ray reach the emitter at that distance? Clear surfaces before it take their
 * part of *light. */
static bool reaches(struct pp_path_trace *path, struct pp_light_ray ray,
                    const struct pp_emitter *emitter, double distance_m,
                    struct pp_rgb *light)
{
    double gone_m = 0.0;
    for (int i = 0; i < MOST_CLEAR; i++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_path_trace_meet(path, &ray, &hit);
        if (meeting == PP_MEETS_ENVIRONMENT)
            return emitter->distant >= 0 && isinf(hit.distance_m);
        if (meeting != PP_MEETS_PART)
            return false;
        gone_m += hit.distance_m;
        if (hit.part == emitter->part
            && fabs(gone_m - distance_m) < 1e-4 * distance_m + 1e-5)
            return true;
        if (!pp_light_scene_parts_pass(path->scene, &hit, &ray, light))
            return false;
    }
    return false;
}

/* The emitters that a point chooses among. */
struct emitter_choice {
    const struct pp_light_scene *scene;
    const struct pp_lit_point *at;
};

static double emitter_importance(const void *of, int i)
{
    const struct emitter_choice *choice = of;
    return pp_emitters_importance(&choice->scene->emitters[i], choice->scene,
                                  choice->at->point, choice->at->normal);
}

struct pp_rgb pp_next_event_emitters(struct pp_path_trace *path,
                                     const struct pp_lit_point *at)
{
    const struct pp_light_scene *scene = path->scene;
    struct pp_rgb none = pp_rgb_grey(0.0);
    if (scene->emitter_count == 0)
        return none;
    double u[3], probability;
    pp_path_trace_draw(path, 3, u);
    struct emitter_choice choice = {scene, at};
    int chosen = pp_sample_discrete_of(emitter_importance, &choice,
                                       scene->emitter_count, 0.0, u[2], &probability);
    struct pp_emitter_sampler sampler;
    struct pp_direction_sample to;
    if (chosen < 0
        || !pp_emitters_sampler_init(&sampler, scene, &scene->emitters[chosen],
                                     at->point, at->normal)
        || !pp_emitters_sample(&sampler, u[0], u[1], &to))
        return none;
    const struct pp_emitter *emitter = &scene->emitters[chosen];
    struct pp_rgb L = emitter->radiance;
    if (emitter->distant >= 0)
        L = pp_light_scene_distant_radiance(scene, emitter->distant, to.direction);
    double cosine = pp_vec_dot(at->normal, to.direction);
    struct pp_light_ray ray = {at->point, at->normal, to.direction, at->space};
    if (!(cosine > 0.0) || !reaches(path, ray, emitter, to.distance_m, &L))
        return none;
    return pp_rgb_scale(L, cosine * to.per_density / probability);
}

/* Are openings aimed at from there? */
static bool sees_openings(const struct pp_path_trace *path, enum pp_space space)
{
    return path->scene->pane_count > 0 && space != PP_OUTDOORS;
}

struct pp_rgb pp_next_event_reflected(struct pp_path_trace *path,
                                      const struct pp_lobes *lobes,
                                      const struct pp_light_hit *hit, bool aims)
{
    struct pp_rgb L = pp_rgb_grey(0.0);
    for (int side = 0; side < 2; side++) {
        struct pp_rgb albedo =
            lobes->share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
        if (pp_rgb_is_black(albedo))
            continue;
        struct pp_lit_point at = {
            hit->point, side ? pp_vec_scale(lobes->frame.z, -1.0) : lobes->frame.z,
            hit->space};
        if (hit->part >= 0)
            at.space = pp_light_scene_parts_space(path->scene, hit, side);
        struct pp_rgb E = pp_next_event_emitters(path, &at);
        if (aims && sees_openings(path, at.space))
            E = pp_rgb_add(E, pp_next_event_openings(path, &at, NULL));
        L = pp_rgb_add(L, pp_rgb_scale(pp_rgb_times(albedo, E), 1.0 / PP_PI));
    }
    return L;
}

struct pp_path_counted pp_next_event_counted(enum pp_lobe lobe, enum pp_space space,
                                             bool aims)
{
    bool diffuse = lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE;
    return (struct pp_path_counted){.openings = diffuse && aims && space != PP_OUTDOORS,
                                    .emitters = diffuse};
}

void pp_next_event_leave_out(struct pp_lobes *lobes)
{
    lobes->share[PP_LOBE_STRAIGHT] = lobes->share[PP_LOBE_THROUGH_DIFFUSE] =
        pp_rgb_grey(0.0);
}
