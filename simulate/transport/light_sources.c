/* light_sources.c - light from concentrated emitters, aimed at. See light_path.h. */
#include <math.h>

#include "simulate/sampling/choose.h"
#include "simulate/transport/light_path.h"

enum {
    /* Clear surfaces between a point and what it aims at, at most. */
    MOST_PANES = 64,
    /* At the first surface each of so many emitters is aimed at; of more, one a path.
     */
    MOST_EMITTERS = 64,
    /* The same of each in each mirror. */
    MOST_MIRRORED = 8,
};

bool pp_light_sources_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int emitter)
{
    if (!state->options.sources || path->aimed == PP_DIRECTLY_SAMPLED_NONE)
        return false;
    if (path->aimed == PP_DIRECTLY_SAMPLED_ALL)
        return true;
    struct pp_vec3 from =
        pp_mirrors_path_point(state->scene, path->mirror_path, path->from);
    return pp_emitters_angular_size(&state->scene->emitters[emitter], state->scene,
                                    from)
           < path->width;
}

struct pp_rgb pp_light_sources_brdf(const struct pp_shading_point *shading,
                                    struct pp_vec3 o, double spread)
{
    const struct pp_lobes *lobes = shading->lobes;
    bool through = pp_vec_dot(lobes->n, shading->normal) < 0.0;
    struct pp_rgb diffuse =
        lobes->share[through ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
    struct pp_rgb f = pp_rgb_scale(diffuse, 1.0 / PP_PI);
    if (spread < PP_DIRECTLY_SAMPLED_WIDTHS * pp_scatter_gloss_width(lobes))
        f = pp_rgb_add(f, pp_scatter_gloss_brdf(lobes, o));
    return f;
}

/* Goes on behind what it has met; false where nothing passes. */
static bool pass(const struct pp_light_scene *scene, struct pp_light_ray *ray,
                 const struct pp_light_hit *hit, struct pp_rgb *through)
{
    *through = pp_rgb_times(
        *through, pp_scatter_regular_transmittance(&scene->materials[hit->material],
                                                   -pp_vec_dot(hit->normal, ray->to)));
    ray->from = hit->point;
    ray->off = pp_vec_scale(hit->normal, -1.0);
    ray->space = pp_light_path_part_space(scene, hit->part, !hit->back);
    return !pp_rgb_is_black(*through);
}

bool pp_light_sources_unoccluded(struct pp_radiance_state *state,
                                 struct pp_light_ray ray, int part, double distance_m,
                                 struct pp_rgb *through)
{
    const struct pp_light_scene *scene = state->scene;
    double gone = 0.0;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_light_path_meet(state, &ray, &hit);
        if (meeting == PP_MEETS_ENVIRONMENT)
            return part < 0 && isinf(hit.distance_m);
        if (meeting == PP_MEETS_LEAK)
            return false;
        gone += hit.distance_m;
        if (hit.part == part && fabs(gone - distance_m) < 1e-4 * distance_m + 1e-5)
            return true;
        if (!pass(scene, &ray, &hit, through))
            return false;
    }
    return false;
}

/* Turns back as what it has met mirrors it; false where that does not. */
static bool reflect(const struct pp_light_scene *scene, struct pp_light_ray *ray,
                    const struct pp_light_hit *hit, struct pp_rgb *through)
{
    double cosine = -pp_vec_dot(hit->normal, ray->to);
    if (pp_light_scene_gloss(scene, hit->material))
        return false;
    *through = pp_rgb_times(*through, pp_scatter_specular_reflectance(
                                          &scene->materials[hit->material], cosine));
    ray->from = hit->point;
    ray->off = hit->normal;
    ray->to = pp_vec_along(ray->to, 2.0 * cosine, hit->normal);
    ray->space = hit->space;
    return !pp_rgb_is_black(*through);
}

/* Goes straight, through what is clear, to the mirror, and on as it sends the ray;
 * false if something stands before it. *left_m is how far there is to go. */
static bool reach_mirror(struct pp_radiance_state *state, struct pp_light_ray *ray,
                         int index, double *left_m, struct pp_rgb *through)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_mirror *mirror = &scene->mirrors[index];
    double t = (mirror->offset_m - pp_vec_dot(mirror->normal, ray->from))
               / pp_vec_dot(mirror->normal, ray->to);
    if (!(t > 0.0 && t < *left_m))
        return false;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        if (pp_light_path_meet(state, ray, &hit) != PP_MEETS_PART)
            return false;
        *left_m -= hit.distance_m;
        if (scene->parts[hit.part].mirror == index)
            return reflect(scene, ray, &hit, through);
        if (!pass(scene, ray, &hit, through))
            return false;
    }
    return false;
}

/* How an emitter may be looked for: straight (mirror_path -1), or by mirrors. */
struct way {
    const struct pp_emitter *emitter; /* not owned */
    int mirror_path;
    struct pp_vec3 from,
        n; /* the shading point and its normal, as they are seen by it */
    double spread;
};

static struct way way_of(const struct pp_light_scene *scene,
                         const struct pp_shading_point *shading, int index)
{
    struct way way = {&scene->emitters[index % scene->emitter_count],
                      index / scene->emitter_count - 1, shading->point, shading->normal,
                      0.0};
    way.from = pp_mirrors_path_point(scene, way.mirror_path, way.from);
    way.n = pp_mirrors_path_direction(scene, way.mirror_path, way.n);
    way.spread = pp_emitters_angular_size(way.emitter, scene, way.from);
    return way;
}

/* Light from one direction to an emitter. */
static struct pp_rgb from_emitter(struct pp_radiance_state *state,
                                  const struct pp_shading_point *shading,
                                  const struct way *way,
                                  const struct pp_direction_sample *aimed)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_emitter *emitter = way->emitter;
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    struct pp_vec3 to =
        pp_mirrors_path_unfold(scene, way->mirror_path, aimed->direction);
    double facing = pp_vec_dot(shading->normal, to), left = aimed->distance_m;
    if (!(facing > 0.0))
        return none;
    struct pp_rgb f = pp_light_sources_brdf(shading, to, way->spread);
    if (pp_rgb_is_black(f))
        return none;
    struct pp_light_ray ray = pp_light_path_shadow_ray(shading, to);
    for (int i = 0; way->mirror_path >= 0 && i < PP_MIRROR_PATH_MOST; i++) {
        int mirror = scene->mirror_paths[way->mirror_path].mirrors[i];
        if (mirror >= 0 && !reach_mirror(state, &ray, mirror, &left, &through))
            return none;
    }
    if (!pp_light_sources_unoccluded(state, ray, emitter->part, left, &through))
        return none;
    struct pp_rgb radiance =
        emitter->distant < 0 ? emitter->radiance
                             : pp_light_scene_distant_radiance(scene, emitter->distant,
                                                               aimed->direction);
    return pp_rgb_scale(pp_rgb_times(pp_rgb_times(f, through), radiance),
                        facing * aimed->per_density);
}

static struct pp_rgb light_by_way(struct pp_radiance_state *state,
                                  const struct pp_shading_point *shading, int index,
                                  int vertex)
{
    struct way way = way_of(state->scene, shading, index);
    struct pp_rgb sum = pp_rgb_grey(0.0);
    struct pp_emitter_sampler aim;
    if (!pp_emitters_sampler_init(&aim, state->scene, way.emitter, way.from, way.n))
        return sum;
    uint32_t count =
        shading->many ? pp_emitters_direction_count(
            way.spread, state->options.source_size, state->options.source_most)
                      : 1;
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        struct pp_direction_sample aimed;
        pp_sobol_sequence_draw(&state->sequence, state->index * count + i, vertex, 2,
                               u);
        if (pp_emitters_sample(&aim, u[0], u[1], &aimed))
            sum = pp_rgb_add(sum, from_emitter(state, shading, &way, &aimed));
    }
    return pp_rgb_scale(sum, 1.0 / count);
}

/* Some of the ways to light a surface. */
struct source_ways {
    const struct pp_light_scene *scene;
    const struct pp_shading_point *shading;
    int first; /* of them */
};

/* What may come by that way. Never 0 for one by which there may be light: glass mirrors
 * more at other angles than at right ones. */
static double importance_of(const void *of, int index)
{
    const struct source_ways *ways = of;
    const struct pp_light_scene *scene = ways->scene;
    struct way way = way_of(scene, ways->shading, ways->first + index);
    double share = way.mirror_path < 0
                       ? 1.0
                       : fmax(scene->mirror_paths[way.mirror_path].share, 0.02);
    return share * pp_emitters_importance(way.emitter, scene, way.from, way.n);
}

/* By those ways: by each at the first surface if they are no more than `most`. */
static struct pp_rgb light_by_ways(struct pp_radiance_state *state,
                                   const struct pp_shading_point *shading, int first,
                                   int end, int most, int vertex)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    if (end - first <= 1 || (shading->many && end - first <= most)) {
        for (int i = first; i < end; i++)
            sum = pp_rgb_add(sum, light_by_way(state, shading, i,
                                               i == first ? vertex
                                                          : pp_light_path_branch_vertex(
                                                              vertex, i - first)));
        return sum;
    }
    double u, probability;
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_light_path_branch_vertex(vertex, 0), 1, &u);
    struct source_ways ways = {state->scene, shading, first};
    int chosen = pp_choose(importance_of, &ways, end - first, u, &probability);
    if (chosen < 0)
        return sum;
    return pp_rgb_scale(light_by_way(state, shading, first + chosen, vertex),
                        1.0 / probability);
}

struct pp_rgb pp_light_sources_next_event(struct pp_radiance_state *state,
                                          const struct pp_shading_point *shading)
{
    int count = state->scene->emitter_count;
    if (!state->options.sources || count == 0)
        return pp_rgb_grey(0.0);
    int vertex = shading->vertex * PP_DRAWS + PP_DRAW_SOURCES;
    struct pp_rgb straight =
        light_by_ways(state, shading, 0, count, MOST_EMITTERS, vertex);
    struct pp_rgb mirrored = light_by_ways(
        state, shading, count, count * (1 + state->scene->mirror_path_count),
        MOST_MIRRORED, pp_light_path_branch_vertex(vertex, -1));
    return pp_rgb_add(straight, mirrored);
}
