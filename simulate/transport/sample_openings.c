/* sample_openings.c - directions to the panes, and the weight of light along them at
 * the shading point. */
#include "simulate/transport/sample_openings.h"

#include <math.h>

#include "simulate/sampling/sample_bright.h"
#include "simulate/scene/environment.h"
#include "simulate/transport/light_sources.h"
#include "simulate/transport/path_scatter.h"

/* Up to this number, all openings are sampled. Sampling one at random caused most of a
 * path's noise; sampling all gives a quarter less noise in the example studio. */
enum { FEW_OPENINGS = 4 };

/* Greatest number of directions to each stratum of an opening from a strong gloss.
 * Where its lobe is narrow, its own rays find the opening. */
enum { GLOSS_WINDOWS = 4 };

int pp_sample_openings_vertex(const struct pp_shading_point *shading, int opening)
{
    return pp_path_vertex_branch(pp_path_vertex_branch(shading->vertex, PP_DRAW_PANES),
                                 opening);
}

/* True if the sampler was made for this target, point and normal. */
static bool is_made_for(const struct pp_polygon_sampler *sampler,
                        const struct pp_target *target,
                        const struct pp_shading_point *shading)
{
    return sampler->target == target && pp_vec_same(sampler->from, shading->point)
           && pp_vec_same(sampler->facing, shading->normal);
}

/* The sampler of an opening; NULL if the opening is not visible. */
static const struct pp_polygon_sampler *sampler_of(
    struct pp_radiance_state *state, const struct pp_shading_point *shading,
    int opening)
{
    const struct pp_target *target =
        pp_openings_aim(&state->scene->panes[opening], shading->niches);
    struct pp_polygon_sampler *sampler = &state->samplers[opening % PP_KEPT_SAMPLERS];
    if (is_made_for(sampler, target, shading))
        return sampler;
    if (!pp_sample_polygon_in_sight(target, shading->point, shading->normal))
        return NULL;
    pp_sample_polygon_init(sampler, target, shading->point, shading->normal,
                           &state->environment->brightness);
    return sampler;
}

static bool samples_all(const struct pp_light_scene *scene, bool split)
{
    return split || scene->pane_count <= FEW_OPENINGS;
}

/* Number of directions to each stratum of an opening, for this number of rays of the
 * gloss. */
static uint32_t gloss_windows(uint32_t gloss_rays)
{
    return gloss_rays < GLOSS_WINDOWS ? gloss_rays : GLOSS_WINDOWS;
}

/* Number of directions to an opening; the mean number if one opening is chosen at
 * random. */
static double samples_of(const struct pp_radiance_state *state, bool split,
                         uint32_t gloss_rays, int opening, struct pp_vec3 point)
{
    const struct pp_light_scene *scene = state->scene;
    if (!samples_all(scene, split))
        return 1.0 / scene->pane_count;
    return gloss_windows(gloss_rays)
           * pp_path_vertex_direction_count(
               state, split, pp_openings_angular_size(&scene->panes[opening], point));
}

double pp_sample_openings_weight(struct pp_radiance_state *state,
                                 const struct pp_light_path *path, int opening)
{
    if (!state->options.windows || path->from_window || path->sampled_in == PP_OUTDOORS)
        return 1.0;
    if (path->sampled == PP_DIRECTLY_SAMPLED_ALL && path->mirror_path < 0)
        return 0.0;
    double share = pp_path_vertex_image_weight(state, &path->arrival, opening);
    if (path->sampled != PP_DIRECTLY_SAMPLED_GLOSS || path->mirror_path >= 0)
        return share;
    struct pp_shading_point shading = {.point = path->gloss_point,
                                       .normal = path->gloss_normal};
    const struct pp_polygon_sampler *sampler = sampler_of(state, &shading, opening);
    if (!sampler)
        return share;
    return share
           * pp_path_vertex_mis(path->gloss_pdf,
                                samples_of(state, path->gloss_split, path->gloss_rays,
                                           opening, shading.point)
                                    * pp_sample_polygon_pdf(sampler, path->ray.to));
}

/* Light of emitters outside that a pane scatters to the eye at the start of the
 * sample's ray. diffuse: diffuse transmittance of the pane; lobes: its other lobes;
 * NULL: none. */
static struct pp_rgb sources_behind(struct pp_radiance_state *state,
                                    const struct pp_shading_point *shading,
                                    const struct pp_opening_sample *sample,
                                    struct pp_rgb diffuse, const struct pp_lobes *lobes)
{
    if (state->scene->emitter_count == 0)
        return pp_rgb_grey(0.0);
    int vertex = pp_sample_openings_vertex(shading, sample->opening);
    const struct pp_shading_point there = {.point = sample->ray.from,
                                           .normal = sample->ray.off,
                                           .space = PP_OUTDOORS,
                                           .diffuse = diffuse,
                                           .lobes = lobes,
                                           .whole_gloss = true,
                                           .vertex = pp_path_vertex_branch(vertex, 0),
                                           .depth = shading->depth};
    return pp_light_sources_next_event(state, &there);
}

/* Continues the ray to the outside by one of the lobes of a scattering pane. Returns
 * the weight of light along the new ray. */
static struct pp_rgb leave_scattered(struct pp_radiance_state *state,
                                     const struct pp_shading_point *shading,
                                     const struct pp_light_part *part,
                                     struct pp_opening_sample *sample)
{
    double u[3]; /* direction (2), lobe */
    struct pp_lobes lobes;
    struct pp_rgb factor, weight = pp_rgb_grey(1.0);
    pp_scatter_init(&lobes, &state->scene->materials[part->material[0]], NULL,
                    part->normal, pp_vec_scale(sample->ray.to, -1.0));
    lobes.share[PP_LOBE_DIFFUSE] = pp_rgb_grey(0.0);
    sample->sources = sources_behind(state, shading, sample,
                                     lobes.share[PP_LOBE_THROUGH_DIFFUSE], &lobes);
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_sample_openings_vertex(shading, sample->opening), 3, u);
    enum pp_lobe lobe = pp_path_scatter_choose_lobe(&lobes, u[2], &weight);
    if (lobe == PP_LOBE_COUNT
        || !pp_scatter_sample(&lobes, lobe, u[0], u[1], &sample->ray.to, &factor))
        return pp_rgb_grey(0.0);
    return pp_rgb_times(weight, factor);
}

/* Sets the ray that leaves the opening at the place where the direction meets it, and
 * multiplies the weight by the transmittance. If the pane scatters, a new direction is
 * sampled behind it. */
static void leave(struct pp_radiance_state *state,
                  const struct pp_shading_point *shading,
                  const struct pp_direction_sample *to,
                  struct pp_opening_sample *sample)
{
    const struct pp_light_part *part =
        &state->scene->parts[state->scene->panes[sample->opening].part];
    const struct pp_material *material = &state->scene->materials[part->material[0]];
    struct pp_vec3 out = pp_vec_scale(part->normal, -1.0);
    struct pp_rgb transmittance = material->through_diffuse;
    sample->ray = (struct pp_light_ray){to->point, out, to->direction, PP_OUTDOORS};
    sample->sources = pp_rgb_grey(0.0);
    if (material->kind == PP_MATERIAL_SCATTERING) {
        transmittance = leave_scattered(state, shading, part, sample);
    } else if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        double u[2];
        sample->sources =
            sources_behind(state, shading, sample, material->through_diffuse, NULL);
        pp_sobol_sequence_draw(&state->sequence, state->index,
                               pp_sample_openings_vertex(shading, sample->opening), 2,
                               u);
        transmittance = pp_rgb_scale(transmittance,
                                     pp_sample_bright_lobe(state->environment->bright,
                                                           part->a, part->b, out, u[0],
                                                           u[1], &sample->ray.to));
    } else {
        transmittance =
            pp_scatter_regular_transmittance(material, pp_vec_dot(out, to->direction));
    }
    sample->sources = pp_rgb_times(sample->weight, sample->sources);
    sample->weight = pp_rgb_times(sample->weight, transmittance);
}

static bool has_light(const struct pp_opening_sample *sample)
{
    return !pp_rgb_is_black(sample->weight)
           || (!sample->on_side && !pp_rgb_is_black(sample->sources));
}

void pp_sample_openings_scale(struct pp_opening_sample *sample, struct pp_rgb by)
{
    sample->weight = pp_rgb_times(sample->weight, by);
    sample->sources = pp_rgb_times(sample->sources, by);
}

/* True if a ray meets this pane first. False if another pane is in front, since light
 * through both panes was sampled with the other one. */
static bool meets_pane(struct pp_radiance_state *state,
                       const struct pp_shading_point *shading, struct pp_vec3 to,
                       const struct pp_pane *pane)
{
    struct pp_light_ray ray = pp_path_vertex_shadow_ray(shading, to);
    struct pp_light_hit hit;
    return pp_radiance_state_meet(state, &ray, &hit) == PP_MEETS_PART
           && hit.part == pane->part;
}

/* True if the opening (or the mouth of its niche) is unobstructed from the shading
 * point in all directions. */
static bool is_open(const struct pp_shading_point *shading, const struct pp_pane *pane)
{
    if (shading->niches)
        return pp_convex_room_has_niche(pane) || !(pane->opening->reveal_m > 0.0);
    return pane->seen_by_all && shading->space == PP_INDOORS;
}

/* Extends a direction from the mouth of the opening's niche into the niche. Either
 * moves *to to the pane, or marks the sample as on one of the niche's sides. */
static void go_in(const struct pp_light_scene *scene, struct pp_direction_sample *to,
                  struct pp_opening_sample *sample)
{
    const struct pp_pane *pane = &scene->panes[sample->opening];
    double further_m;
    int part = pp_convex_room_behind_mouth(pane, to->point, to->direction, &further_m);
    to->point = pp_vec_along(to->point, further_m, to->direction);
    sample->on_side = part != pane->part;
    if (sample->on_side)
        sample->side = (struct pp_light_hit){.part = part,
                                             .tag = scene->parts[part].tag,
                                             .point = to->point,
                                             .normal = scene->parts[part].normal,
                                             .distance_m = to->distance_m + further_m,
                                             .material = scene->parts[part].material[0],
                                             .space = PP_INDOORS};
}

/* Samples one direction to an opening, and multiplies its weight by `weight`; false if
 * no light arrives along it. */
static bool sample_opening(struct pp_radiance_state *state,
                           const struct pp_opening_sampling *sampling, double weight,
                           const double u[2], struct pp_opening_sample *sample)
{
    const struct pp_shading_point *shading = sampling->shading;
    const struct pp_polygon_sampler *sampler =
        sampler_of(state, shading, sample->opening);
    if (!sampler)
        return false;
    struct pp_direction_sample to = pp_sample_polygon_draw(sampler, u[0], u[1]);
    double cosine = pp_vec_dot(shading->normal, to.direction);
    if (!(cosine > 0.0))
        return false;
    const struct pp_pane *pane = &state->scene->panes[sample->opening];
    double samples = sampling->count;
    if (shading->lobes)
        samples = samples_of(state, shading->split, shading->gloss_rays,
                             sample->opening, shading->point);
    double share = 1.0;
    if (shading->arrival)
        share = pp_path_vertex_image_weight(state, shading->arrival, sample->opening);
    struct pp_rgb f =
        pp_path_vertex_brdf(shading, to.direction, samples / to.per_density, share);
    if (pp_rgb_is_black(f))
        return false;
    bool open = is_open(shading, pane);
    if ((!open || state->every_ray) && !meets_pane(state, shading, to.direction, pane)
        && !open)
        return false;
    sample->weight = pp_rgb_scale(f, weight * cosine * to.per_density);
    sample->on_side = false;
    if (shading->niches && pp_convex_room_has_niche(pane))
        go_in(state->scene, &to, sample);
    if (!sample->on_side)
        leave(state, shading, &to, sample);
    return has_light(sample);
}

bool pp_sample_openings_aim(struct pp_radiance_state *state,
                            const struct pp_shading_point *shading, int opening,
                            const double u[2], struct pp_opening_sample *sample)
{
    const struct pp_opening_sampling one = {.shading = shading, .count = 1};
    sample->opening = opening;
    return sample_opening(state, &one, 1.0, u, sample);
}

bool pp_sample_openings_along(struct pp_radiance_state *state,
                              const struct pp_shading_point *shading, int opening,
                              struct pp_vec3 to, struct pp_opening_sample *sample)
{
    const struct pp_pane *pane = &state->scene->panes[opening];
    struct pp_light_ray ray = pp_path_vertex_shadow_ray(shading, to);
    struct pp_direction_sample there = {.direction = to};
    struct pp_light_hit hit;
    if (pane->seen_by_all && pane->target.rectangle && !state->every_ray) {
        if (!pp_target_meets_rectangle(&pane->target, shading->point, to, &there.point))
            return false;
    } else {
        if (pp_radiance_state_meet(state, &ray, &hit) != PP_MEETS_PART
            || hit.part != pane->part || hit.back)
            return false;
        there.point = hit.point;
    }
    sample->opening = opening;
    sample->on_side = false;
    sample->weight = pp_rgb_grey(1.0);
    leave(state, shading, &there, sample);
    return has_light(sample);
}

/* Index of the random numbers for directions to the first opening. */
static int first_vertex(const struct pp_shading_point *shading)
{
    return shading->vertex * PP_DRAWS + PP_DRAW_WINDOWS;
}

void pp_sample_openings_begin(struct pp_radiance_state *state,
                              const struct pp_shading_point *shading,
                              struct pp_opening_sampling *sampling)
{
    int count = state->scene->pane_count;
    bool none = !state->options.windows || shading->space == PP_OUTDOORS || count == 0;
    sampling->shading = shading;
    sampling->all =
        shading->directions == 0 && samples_all(state->scene, shading->split);
    sampling->numbers = sampling->all || count == 1 ? 2 : 3;
    sampling->opening = -1;
    sampling->end = none ? 0 : sampling->all ? count : 1;
    sampling->direction = sampling->count = 0;
    sampling->index = state->index;
    /* The random numbers of all directions are drawn together if
     * pp_sobol_sequence_draw_run allows this: the number of directions must be a power
     * of two, at most PP_RUN_MOST. */
    sampling->drawn = !none && shading->directions > 1
                      && shading->directions <= PP_RUN_MOST
                      && (shading->directions & (shading->directions - 1)) == 0;
    if (sampling->drawn)
        pp_sobol_sequence_draw_run(&state->sequence, state->index * shading->directions,
                                   (int)shading->directions, first_vertex(shading),
                                   sampling->numbers, sampling->u);
}

/* Advances to the next opening; false if there is none. */
static bool next_opening(struct pp_radiance_state *state,
                         struct pp_opening_sampling *sampling)
{
    const struct pp_shading_point *shading = sampling->shading;
    if (++sampling->opening >= sampling->end) {
        state->index = sampling->index;
        return false;
    }
    sampling->direction = 0;
    sampling->count = shading->directions > 0 ? shading->directions : 1;
    if (sampling->all)
        sampling->count =
            (shading->lobes ? gloss_windows(shading->gloss_rays) : 1)
            * pp_path_vertex_direction_count(
                state, shading->split,
                pp_openings_angular_size(&state->scene->panes[sampling->opening],
                                         shading->point));
    return true;
}

/* Draws the random numbers of the present direction: two, or three if one opening is
 * chosen at random. */
static void draw_opening_numbers(const struct pp_radiance_state *state,
                                 const struct pp_opening_sampling *sampling,
                                 double u[3])
{
    int vertex = first_vertex(sampling->shading);
    if (sampling->drawn) {
        for (int k = 0; k < sampling->numbers; k++)
            u[k] = sampling->u[k][sampling->direction];
        return;
    }
    if (sampling->all && sampling->opening > 0)
        vertex = pp_path_vertex_branch(vertex, sampling->opening);
    pp_sobol_sequence_draw(&state->sequence, state->index, vertex, sampling->numbers,
                           u);
}

bool pp_sample_openings_next(struct pp_radiance_state *state,
                             struct pp_opening_sampling *sampling,
                             struct pp_opening_sample *sample)
{
    const struct pp_shading_point *shading = sampling->shading;
    for (;;) {
        if (sampling->direction == sampling->count && !next_opening(state, sampling))
            return false;
        double u[3] = {0.0},
               probability = 1.0; /* place in the opening (2), choice of the opening */
        state->index = sampling->index * sampling->count + sampling->direction;
        sample->opening = sampling->opening;
        draw_opening_numbers(state, sampling, u);
        sampling->direction++;
        if (!sampling->all) {
            const struct pp_openings_viewer viewer = {&state->environment->brightness,
                                                      shading->point, shading->normal,
                                                      shading->niches};
            sample->opening = pp_openings_choose(state->scene, &viewer, &state->shares,
                                                 u[2], &probability);
            if (sample->opening < 0)
                continue;
        }
        if (sample_opening(state, sampling, 1.0 / (probability * sampling->count), u,
                           sample))
            return true;
    }
}
