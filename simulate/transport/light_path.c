/* light_path.c - emission and direct light at each surface, and the next ray. */
#include "simulate/transport/light_path.h"

#include <math.h>

#include "simulate/sampling/lobe.h"
#include "simulate/scene/environment.h"
#include "simulate/transport/light_images.h"
#include "simulate/transport/light_sources.h"
#include "simulate/transport/opening_store.h"
#include "simulate/transport/path_scatter.h"
#include "simulate/transport/sample_openings.h"

enum {
    MOST_BOUNCES = 1 << 14, /* for scenes without absorption */
    /* most bounces up to the first scattering surface, for a path that splits there */
    FIRST_FEW = 3,
    /* Directions from the ground if it scatters first, times source_most. */
    GROUND_DIRECTIONS = 4,
    /* Directions of a strong gloss that is the first surface that scatters. At 16 paths
     * per pixel a polished floor has a noise of 3.8 % (4 directions: 9.3 %). */
    GLOSS_DIRECTIONS = 32,
    BUMP_DIRECTIONS = 8, /* for the wide lobe of bumps: 1.8 % (1: 6.1 %, 32: 1.7 %) */
};

/* A gloss is strong if it reflects more than this. */
static const double STRONG_GLOSS = 0.1;

/* Rays of gloss, mirrors and panes may reach a window or a lamp, which is far brighter
 * than lit surfaces. For these rays, Russian roulette begins at this fraction of the
 * throughput for diffuse light. */
static const double LEAST_GLOSS = 0.1;
/* The same fraction for the ground, most of whose rays reach the sky. */
static const double LEAST_GROUND = 0.1;

struct pp_rgb pp_light_path_follow(struct pp_radiance_state *state,
                                   struct pp_light_path *path,
                                   struct pp_light_hit *first)
{
    struct pp_rgb total = pp_rgb_grey(0.0);
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_radiance_state_meet(state, &path->ray, &hit);
    if (first)
        *first = hit;
    while (pp_light_path_arrive(state, path, meeting, &hit, &total))
        meeting = pp_radiance_state_meet(state, &path->ray, &hit);
    return total;
}

/* ---- light at a surface ---- */

/* Radiance that arrives at a window from outside, against the direction of the ray. If
 * the ray meets no surface, it is the radiance of the environment. Otherwise it is read
 * from the store or, if not stored, found by a path. */
static struct pp_rgb light_outside(struct pp_radiance_state *state,
                                   const struct pp_shading_point *shading,
                                   const struct pp_opening_sample *sample,
                                   enum pp_first_met *first_met)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_light_ray *ray = &sample->ray;
    const struct pp_pane *pane = &scene->panes[sample->opening];
    const struct pp_opening_store *store = state->options.stored ? state->store : NULL;
    struct pp_rgb radiance = pp_rgb_grey(0.0);
    struct pp_light_hit hit;
    bool is_sky;
    *first_met = PP_MET_OUTSIDE;
    if (pp_rgb_is_black(sample->weight))
        return radiance;
    enum pp_meeting meeting = !pane->unobstructed || state->every_ray
                                  ? pp_radiance_state_meet(state, ray, &hit)
                                  : pp_light_scene_meet_outside(scene, ray, &hit);
    if (meeting == PP_MEETS_ENVIRONMENT) {
        radiance =
            pp_light_scene_environment(scene, state->environment, ray->to, &is_sky);
        *first_met = is_sky ? PP_MET_SKY : PP_MET_OUTSIDE;
        return radiance;
    }
    if (meeting == PP_MEETS_LEAK
        || (store && pp_opening_table_takes(scene, meeting, &hit)
            && pp_opening_table_radiance(&store->tables[sample->opening], &pane->target,
                                         ray->from, ray->to, hit.distance_m,
                                         &radiance)))
        return radiance;
    struct pp_light_path path = pp_light_path_outside(
        state, ray, pp_sample_openings_vertex(shading, sample->opening),
        shading->depth);
    if (pp_light_path_arrive(state, &path, meeting, &hit, &radiance))
        radiance = pp_rgb_add(radiance, pp_light_path_follow(state, &path, NULL));
    *first_met = path.first_met;
    return radiance;
}

/* Weighted light through an opening, with light of emitters that its pane scatters. */
static struct pp_rgb light_through(struct pp_radiance_state *state,
                                   const struct pp_shading_point *shading,
                                   const struct pp_opening_sample *sample,
                                   enum pp_first_met *first_met)
{
    struct pp_rgb light = light_outside(state, shading, sample, first_met);
    return pp_rgb_add(sample->sources, pp_rgb_times(sample->weight, light));
}

/* Adds light from one opening by its image in a reflector. */
static void add_images(struct pp_radiance_state *state,
                       const struct pp_shading_point *shading,
                       struct pp_irradiance *sum)
{
    struct pp_image_view view;
    struct pp_opening_sample sample;
    enum pp_first_met first_met;
    if (!pp_light_images_view(state, shading, &view)
        || !pp_light_images_sample(state, &view, &sample))
        return;
    struct pp_rgb light = light_through(state, &view.there, &sample, &first_met);
    sum->rest = pp_rgb_add(sum->rest, light);
}

void pp_light_path_glass(struct pp_radiance_state *state,
                         const struct pp_shading_point *shading,
                         struct pp_glass_view *view, struct pp_irradiance *sum)
{
    struct pp_shading_point there;
    struct pp_opening_sample sample;
    enum pp_first_met first_met;
    if (!pp_light_images_in_glass(state, shading, view, &there, &sample))
        return;
    struct pp_rgb light = light_through(state, &there, &sample, &first_met);
    sum->rest = pp_rgb_add(sum->rest, light);
}

/* Adds the light of a niche's side, which is diffuse. */
static void add_side(const struct pp_niche_light *niches,
                     const struct pp_opening_sample *sample, struct pp_rgb *sum)
{
    struct pp_rgb worth = pp_rgb_scale(sample->weight, 1.0 / PP_PI);
    double exitance = niches->exitance(niches->of, &sample->side, worth.g);
    *sum = pp_rgb_along(*sum, exitance, worth);
}

void pp_light_path_windows(struct pp_radiance_state *state,
                           const struct pp_shading_point *shading,
                           struct pp_irradiance *sum)
{
    struct pp_opening_sampling sampling;
    struct pp_opening_sample sample;
    pp_sample_openings_begin(state, shading, &sampling);
    while (pp_sample_openings_next(state, &sampling, &sample)) {
        enum pp_first_met first_met;
        if (sample.on_side) {
            add_side(shading->niches, &sample, &sum->rest);
            continue;
        }
        struct pp_rgb light = light_through(state, shading, &sample, &first_met);
        struct pp_rgb *part = first_met == PP_MET_SKY      ? &sum->sky
                              : first_met == PP_MET_INSIDE ? &sum->rest
                                                           : &sum->outside;
        *part = pp_rgb_add(*part, light);
    }
    add_images(state, shading, sum);
}

/* Next-event estimation at one side of a surface. */
static struct pp_rgb direct_light(struct pp_radiance_state *state,
                                  const struct pp_shading_point *shading,
                                  const struct pp_light_path *path)
{
    struct pp_irradiance sum = {.rest = pp_rgb_grey(0.0)};
    sum.sources = pp_light_sources_next_event(state, shading);
    if (!path->from_window)
        pp_light_path_windows(state, shading, &sum);
    return pp_irradiance_sum(&sum);
}

/* Next-event estimation at each side of a surface from which light is scattered to the
 * eye. */
static struct pp_rgb direct_light_of_lobes(struct pp_radiance_state *state,
                                           const struct pp_lobes *lobes,
                                           const struct pp_light_hit *hit,
                                           const struct pp_light_path *path)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    for (int side = 0; side < 2; side++) {
        const struct pp_rgb *share = lobes->share;
        struct pp_shading_point shading = {
            .point = hit->point,
            .normal = side ? pp_vec_scale(lobes->frame.z, -1.0) : lobes->frame.z,
            .space = pp_light_scene_parts_space(state->scene, hit, side),
            .diffuse = share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE],
            .lobes = lobes,
            .vertex = side ? pp_path_vertex_branch(path->vertex, 0) : path->vertex,
            .depth = path->depth,
            .split = path->split,
            .gloss_rays = path->here_gloss_rays,
            .arrival = side ? NULL : &path->here_arrival};
        if (!pp_rgb_is_black(shading.diffuse)
            || !pp_rgb_is_black(share[side ? PP_LOBE_THROUGH_GLOSS : PP_LOBE_GLOSS]))
            sum = pp_rgb_add(sum, direct_light(state, &shading, path));
    }
    return sum;
}

/* Diffuse inter-reflection of one side of a surface (times *share), if a cache contains
 * it; 0 at the limit of bounces. In both cases *share is set to black, so that no path
 * follows this light. */
static struct pp_rgb ambient_reflected(const struct pp_radiance_state *state,
                                       const struct pp_light_hit *hit,
                                       struct pp_vec3 normal, int depth,
                                       struct pp_rgb *share)
{
    struct pp_rgb value = pp_rgb_grey(0.0);
    bool last = state->options.bounces >= 0 && depth >= state->options.bounces;
    if (pp_rgb_is_black(*share) || (!last && !state->ambient))
        return value;
    struct pp_light_hit there = *hit;
    there.point = pp_vec_add(hit->point, state->scene->centre);
    if (!last
        && !state->ambient->irradiance(state->ambient->store, &there, normal, depth,
                                       &value))
        return value;
    value = pp_rgb_scale(pp_rgb_times(*share, value), 1.0 / PP_PI);
    *share = pp_rgb_grey(0.0);
    return value;
}

/* Adds the surface's own emission, weighted if it was also sampled directly; false if
 * the path ends at this surface. */
static bool add_emission(const struct pp_radiance_state *state,
                         const struct pp_light_path *path,
                         const struct pp_light_hit *hit, struct pp_rgb *total)
{
    const struct pp_light_part *part = &state->scene->parts[hit->part];
    const struct pp_material *material = &state->scene->materials[hit->material];
    if (material->emits == PP_EMITS_NOTHING || (hit->back && !part->back_emits))
        return true;
    if (material->unseen && path->sampled == PP_DIRECTLY_SAMPLED_NONE)
        return true;
    int emitter = part->emitter[hit->back];
    double weight = emitter < 0 ? 1.0 : pp_light_sources_weight(state, path, emitter);
    *total = pp_rgb_along(*total, weight,
                          pp_rgb_times(path->throughput, material->radiance));
    return !material->unseen;
}

/* Adds the light of the environment and of distant sources, weighted if it was also
 * sampled directly. */
static void add_environment(const struct pp_radiance_state *state,
                            struct pp_light_path *path, struct pp_rgb *total)
{
    const struct pp_light_scene *scene = state->scene;
    bool is_sky;
    struct pp_rgb light =
        pp_light_scene_environment(scene, state->environment, path->ray.to, &is_sky);
    if (path->first_met == PP_MET_NOTHING)
        path->first_met = is_sky ? PP_MET_SKY : PP_MET_OUTSIDE;
    for (int i = 0; i < scene->distant_count; i++) {
        struct pp_rgb of = pp_rgb_grey(0.0);
        if (scene->distants[i].emitter >= 0)
            of = pp_light_scene_distant_radiance(scene, i, path->ray.to);
        if (!pp_rgb_is_black(of))
            light = pp_rgb_along(
                light, pp_light_sources_weight(state, path, scene->distants[i].emitter),
                of);
    }
    *total = pp_rgb_add(*total, pp_rgb_times(path->throughput, light));
}

/* ---- on from a surface ---- */

/* Continues the path by one of the lobes, drawn at random. False if the path ends, by
 * Russian roulette or because nothing is scattered. */
static bool path_goes_on(struct pp_radiance_state *state, struct pp_light_path *path,
                         const struct pp_lobes *lobes, const struct pp_light_hit *hit)
{
    double u[4]; /* direction (2), lobe, Russian roulette */
    pp_sobol_sequence_draw(&state->sequence, state->index, path->vertex * PP_DRAWS, 4,
                           u);
    enum pp_lobe lobe = pp_path_scatter_choose_lobe(lobes, u[2], &path->throughput);
    if (lobe == PP_LOBE_COUNT
        || !pp_path_scatter_by_lobe(state, path, lobes, lobe, hit, u[0], u[1]))
        return false;
    bool diffuse = lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE;
    return pp_path_scatter_survives(
        path, diffuse ? path->least : LEAST_GLOSS * path->least, u[3]);
}

/* Light of one of the lobes, by separate paths. */
static struct pp_rgb follow_lobe(struct pp_radiance_state *state,
                                 const struct pp_light_path *path,
                                 const struct pp_lobes *lobes, enum pp_lobe lobe,
                                 const struct pp_light_hit *hit)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    uint32_t index = state->index;
    uint32_t count = lobe == PP_LOBE_GLOSS ? path->here_gloss_rays : 1;
    for (uint32_t i = 0; i < count; i++) {
        struct pp_light_path branch = *path;
        double u[2];
        branch.vertex = pp_path_vertex_branch(path->vertex, PP_DRAWS + (int)lobe);
        branch.throughput = pp_rgb_scale(
            pp_rgb_times(path->throughput, lobes->share[lobe]), 1.0 / count);
        branch.least /= count;
        state->index = index * count + i;
        pp_sobol_sequence_draw(&state->sequence, state->index,
                               branch.vertex++ * PP_DRAWS, 2, u);
        if (pp_path_scatter_by_lobe(state, &branch, lobes, lobe, hit, u[0], u[1]))
            sum = pp_rgb_add(sum, pp_light_path_follow(state, &branch, NULL));
    }
    state->index = index;
    return sum;
}

/* Light by gloss and mirror is large or zero. Separate paths therefore follow these
 * lobes, which are then set to black. If a mirror or a transmitted gloss is the only
 * lobe left, the path itself follows it. */
static struct pp_rgb follow_gloss_and_mirror(struct pp_radiance_state *state,
                                             const struct pp_light_path *path,
                                             struct pp_lobes *lobes,
                                             const struct pp_light_hit *hit)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    int left = 0;
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        left += !pp_rgb_is_black(lobes->share[i]);
    for (int i = PP_LOBE_GLOSS; i <= PP_LOBE_MIRROR; i++) {
        if (pp_rgb_is_black(lobes->share[i]) || (left == 1 && i != PP_LOBE_GLOSS))
            continue;
        sum = pp_rgb_add(sum, follow_lobe(state, path, lobes, (enum pp_lobe)i, hit));
        lobes->share[i] = pp_rgb_grey(0.0);
        left--;
    }
    return sum;
}

static bool scatters(const struct pp_lobes *lobes)
{
    for (int i = PP_LOBE_DIFFUSE; i <= PP_LOBE_THROUGH_GLOSS; i++)
        if (!pp_rgb_is_black(lobes->share[i]))
            return true;
    return false;
}

/* Lobes of the material towards the eye. Lobes through an opening are weighted if the
 * opening's light was also sampled directly. */
static void lobes_of(struct pp_radiance_state *state, const struct pp_light_path *path,
                     const struct pp_light_hit *hit, struct pp_lobes *lobes)
{
    const struct pp_light_scene *scene = state->scene;
    pp_light_scene_parts_lobes(scene, hit, path->ray.to, lobes);
    int window = scene->parts[hit->part].window;
    if (window < 0 || hit->back)
        return;
    double weight = pp_sample_openings_weight(state, path, window);
    lobes->share[PP_LOBE_STRAIGHT] =
        pp_rgb_scale(lobes->share[PP_LOBE_STRAIGHT], weight);
    lobes->share[PP_LOBE_THROUGH_DIFFUSE] =
        pp_rgb_scale(lobes->share[PP_LOBE_THROUGH_DIFFUSE], weight);
    lobes->share[PP_LOBE_THROUGH_GLOSS] =
        pp_rgb_scale(lobes->share[PP_LOBE_THROUGH_GLOSS], weight);
}

/* Scatters at an opaque, diffuse surface: the most frequent case, with one lobe. */
static bool scatter_matt(struct pp_radiance_state *state, struct pp_light_path *path,
                         const struct pp_light_hit *hit, struct pp_rgb *total)
{
    const struct pp_light_part *part = &state->scene->parts[hit->part];
    struct pp_rgb albedo = pp_light_scene_parts_diffuse(state->scene, hit);
    struct pp_shading_point shading = {.point =
                                           pp_rays_draw_back(hit->point, path->ray.to),
                                       .normal = hit->normal,
                                       .space = hit->space,
                                       .diffuse = albedo,
                                       .vertex = path->vertex,
                                       .depth = path->depth,
                                       .split = path->split};
    pp_path_scatter_note_met(path, hit->space);
    if (pp_rgb_is_black(albedo))
        return false;
    struct pp_rgb here = direct_light(state, &shading, path);
    here = pp_rgb_add(here,
                      ambient_reflected(state, hit, hit->normal, path->depth, &albedo));
    *total = pp_rgb_add(*total, pp_rgb_times(path->throughput, here));
    path->throughput = pp_rgb_times(path->throughput, albedo);
    if (pp_rgb_is_black(albedo))
        return false;
    struct pp_frame frame = {part->a, part->b, hit->normal};
    if (part->round >= 0)
        pp_lobe_frame(hit->normal, &frame.x, &frame.y);
    path->depth++;
    path->split = false;
    return pp_path_scatter_diffuse(state, path, shading.point, &frame, hit->space,
                                   path->least);
}

/* Scatters at the ground, a diffuse surface outdoors. No cache is read for the ground.
 * It does not count among the limited number of diffuse reflections unless requested,
 * since most of its light comes from the sky. If the path splits into many directions,
 * all but one are separate paths. */
static bool scatter_ground(struct pp_radiance_state *state, struct pp_light_path *path,
                           const struct pp_light_hit *hit, struct pp_rgb *total)
{
    static const struct pp_frame level = {
        {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    uint32_t index = state->index;
    uint32_t count =
        path->split ? GROUND_DIRECTIONS * (uint32_t)state->options.source_most : 1;
    double share = pp_outside_light_ground(&state->environment->light) / count;
    pp_path_scatter_note_met(path, hit->space);
    if (state->options.ground_counts && path->depth++ >= state->options.bounces)
        return false;
    const struct pp_shading_point shading = {
        .point = hit->point,
        .normal = level.z,
        .space = hit->space,
        .diffuse = pp_rgb_grey(pp_outside_light_ground(&state->environment->light)),
        .vertex = path->vertex,
        .depth = path->depth,
        .split = path->split};
    struct pp_rgb sources = pp_light_sources_next_event(state, &shading);
    *total = pp_rgb_add(*total, pp_rgb_times(path->throughput, sources));
    path->throughput = pp_rgb_scale(path->throughput, share);
    path->split = false;
    if (pp_rgb_is_black(path->throughput))
        return false;
    for (uint32_t i = 1; i < count; i++) {
        struct pp_light_path branch = *path;
        state->index = index * count + i;
        pp_path_scatter_diffuse(state, &branch, hit->point, &level, hit->space, 0.0);
        branch.vertex = pp_path_vertex_branch(path->vertex, PP_DRAWS);
        *total = pp_rgb_add(*total, pp_light_path_follow(state, &branch, NULL));
    }
    state->index = index * count;
    bool survives =
        pp_path_scatter_diffuse(state, path, hit->point, &level, hit->space,
                                count > 1 ? 0.0 : LEAST_GROUND * path->least);
    state->index = index;
    return survives;
}

/* Arrival of a ray at a reflector whose light was also sampled directly; -1: none. */
static struct pp_arrival arrival_of(const struct pp_radiance_state *state,
                                    const struct pp_light_path *path,
                                    const struct pp_light_hit *hit)
{
    int reflector = state->scene->parts[hit->part].reflector[hit->back];
    if (!path->from_diffuse || reflector < 0)
        return (struct pp_arrival){.reflector = -1};
    return (struct pp_arrival){reflector, path->ray.from, path->ray.off, path->ray.to,
                               pp_vec_dot(path->ray.off, path->ray.to) / PP_PI};
}

/* Scatters at any other surface. */
static bool scatter(struct pp_radiance_state *state, struct pp_light_path *path,
                    const struct pp_light_hit *hit, struct pp_rgb *total)
{
    struct pp_lobes lobes;
    lobes_of(state, path, hit, &lobes);
    path->here_arrival = arrival_of(state, path, hit);
    struct pp_light_hit from = *hit;
    from.point = pp_rays_draw_back(hit->point, path->ray.to);
    /* A surface behind clear glass still counts as the first that scatters light. */
    bool first = path->split && path->bounces <= FIRST_FEW;
    path->here_gloss_rays = 1;
    if (first && pp_rgb_most(lobes.share[PP_LOBE_GLOSS]) > STRONG_GLOSS)
        path->here_gloss_rays = lobes.has_bumps ? BUMP_DIRECTIONS : GLOSS_DIRECTIONS;
    struct pp_rgb here = direct_light_of_lobes(state, &lobes, &from, path);
    path->here_split = path->split;
    path->split = path->split && !scatters(&lobes);
    for (int side = 0; side < 2; side++)
        here = pp_rgb_add(
            here, ambient_reflected(
                      state, hit, side ? pp_vec_scale(hit->normal, -1.0) : hit->normal,
                      path->depth,
                      &lobes.share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE]));
    *total = pp_rgb_add(*total, pp_rgb_times(path->throughput, here));
    if (first)
        *total =
            pp_rgb_add(*total, follow_gloss_and_mirror(state, path, &lobes, &from));
    return path_goes_on(state, path, &lobes, &from);
}

bool pp_light_path_arrive(struct pp_radiance_state *state, struct pp_light_path *path,
                          enum pp_meeting meeting, const struct pp_light_hit *hit,
                          struct pp_rgb *total)
{
    if (meeting == PP_MEETS_ENVIRONMENT)
        add_environment(state, path, total);
    bool ground = meeting == PP_MEETS_GROUND;
    if ((meeting != PP_MEETS_PART && !ground) || path->bounces++ > MOST_BOUNCES
        || (!ground && !add_emission(state, path, hit, total)))
        return false;
    bool goes = ground ? scatter_ground(state, path, hit, total)
                : state->scene->parts[hit->part].matt[hit->back]
                    ? scatter_matt(state, path, hit, total)
                    : scatter(state, path, hit, total);
    path->vertex++;
    return goes;
}
