/* light_path.c - see light_path.h. */
#include "simulate/transport/light_path.h"

#include <math.h>

enum {
    /* A path ends here where nothing ever absorbs. */
    MOST_BOUNCES = 1 << 14,
    /* At so many surfaces, up to the first that scatters, a path goes all ways. */
    FIRST_FEW = 3,
};

/* What a gloss, a mirror or a pane leads to may be a window or a lamp, far brighter
 * than all that they light: Russian roulette begins at this share of the weight that it
 * does for diffuse light. */
static const double LEAST_GLOSS = 0.1;

enum pp_meeting pp_light_path_meet(struct pp_radiance_state *state,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit)
{
    state->rays++;
    enum pp_meeting meeting = pp_light_scene_meet(state->scene, ray, hit);
    state->leaks += meeting == PP_MEETS_LEAK;
    return meeting;
}

struct pp_rgb pp_light_path_follow(struct pp_radiance_state *state,
                                   struct pp_light_path *path,
                                   struct pp_light_hit *first)
{
    struct pp_rgb total = pp_rgb_grey(0.0);
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_light_path_meet(state, &path->ray, &hit);
    if (first)
        *first = hit;
    while (pp_light_path_arrive(state, path, meeting, &hit, &total))
        meeting = pp_light_path_meet(state, &path->ray, &hit);
    return total;
}

/* ---- at a surface ---- */

/* All that is aimed at, on the sides of the surface that send it on to the eye. */
static struct pp_rgb aim_at_all(struct pp_radiance_state *state,
                                const struct pp_lobes *lobes,
                                const struct pp_light_hit *hit,
                                const struct pp_light_path *path)
{
    struct pp_irradiance sum = {.rest = pp_rgb_grey(0.0)};
    for (int side = 0; side < 2; side++) {
        const struct pp_rgb *share = lobes->share;
        if (pp_rgb_is_black(share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE])
            && pp_rgb_is_black(share[side ? PP_LOBE_THROUGH_GLOSS : PP_LOBE_GLOSS]))
            continue;
        struct pp_shading_point shading = {
            .point = hit->point,
            .normal = side ? pp_vec_scale(lobes->n, -1.0) : lobes->n,
            .space = side
                         ? pp_light_path_part_space(state->scene, hit->part, !hit->back)
                         : hit->space,
            .lobes = lobes,
            .vertex =
                side ? pp_light_path_branch_vertex(path->vertex, 0) : path->vertex,
            .depth = path->depth,
            .many = path->many};
        sum.sources =
            pp_rgb_add(sum.sources, pp_light_sources_next_event(state, &shading));
        if (!path->by_window)
            pp_light_windows_next_event(state, &shading, &sum);
    }
    return pp_light_path_irradiance_sum(&sum);
}

/* Diffuse inter-reflection from elsewhere; a lobe that has it is done with. */
static struct pp_rgb ambient_reflected(const struct pp_radiance_state *state,
                                       struct pp_lobes *lobes,
                                       const struct pp_light_hit *hit,
                                       const struct pp_light_path *path)
{
    struct pp_rgb sum = pp_rgb_grey(0.0), value;
    struct pp_light_hit there = *hit;
    there.point = pp_vec_add(hit->point, state->scene->centre);
    for (int side = 0; side < 2; side++) {
        struct pp_rgb *share =
            &lobes->share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
        struct pp_vec3 normal = side ? pp_vec_scale(lobes->n, -1.0) : lobes->n;
        if (pp_rgb_is_black(*share)
            || !state->ambient->irradiance(state->ambient->store, &there, normal,
                                           path->depth, &value))
            continue;
        sum = pp_rgb_along(sum, 1.0 / PP_PI, pp_rgb_times(*share, value));
        *share = pp_rgb_grey(0.0);
    }
    return sum;
}

/* What the surface itself gives off along the path; false where the path ends there. */
static bool add_emission(const struct pp_radiance_state *state,
                         const struct pp_light_path *path,
                         const struct pp_light_hit *hit, struct pp_rgb *total)
{
    const struct pp_light_part *part = &state->scene->parts[hit->part];
    const struct pp_material *material = &state->scene->materials[hit->material];
    if (material->emits == PP_EMITS_NOTHING || (hit->back && !part->back_emits))
        return true;
    if (material->unseen && path->aimed == PP_DIRECTLY_SAMPLED_NONE)
        return true;
    int emitter = part->emitter[hit->back];
    if (emitter < 0 || !pp_light_sources_directly_sampled(state, path, emitter))
        *total = pp_rgb_add(*total, pp_rgb_times(path->weight, material->radiance));
    return !material->unseen;
}

/* What is beyond, distant sources that have not been aimed at among it. */
static void add_environment(const struct pp_radiance_state *state,
                            const struct pp_light_path *path, double near_m,
                            struct pp_rgb *total)
{
    const struct pp_light_scene *scene = state->scene;
    struct pp_rgb light = pp_light_scene_environment(scene, &path->ray, near_m, NULL);
    for (int i = 0; i < scene->distant_count; i++)
        if (scene->distants[i].emitter >= 0
            && !pp_light_sources_directly_sampled(state, path,
                                                  scene->distants[i].emitter))
            light = pp_rgb_add(light,
                               pp_light_scene_distant_radiance(scene, i, path->ray.to));
    *total = pp_rgb_add(*total, pp_rgb_times(path->weight, light));
}

/* One of the lobes in proportion to what each sends on; PP_LOBE_COUNT: none does. The
 * weight makes up for the others. */
static enum pp_lobe choose_lobe(const struct pp_lobes *lobes, double u,
                                struct pp_rgb *weight)
{
    double chance[PP_LOBE_COUNT], total = 0.0;
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        total += chance[i] = pp_rgb_most(lobes->share[i]);
    if (!(total > 0.0))
        return PP_LOBE_COUNT;
    double left = u * total;
    int chosen = PP_LOBE_COUNT;
    for (int i = 0; i < PP_LOBE_COUNT; i++) {
        if (!(chance[i] > 0.0))
            continue;
        chosen = i;
        if (left < chance[i])
            break;
        left -= chance[i];
    }
    *weight = pp_rgb_scale(pp_rgb_times(*weight, lobes->share[chosen]),
                           total / chance[chosen]);
    return chosen;
}

/* Turns the path to where one of the lobes sends it, by two numbers in (0, 1), with
 * that lobe's weight already; false where it ends. */
static bool leave_by(const struct pp_radiance_state *state, struct pp_light_path *path,
                     const struct pp_lobes *lobes, enum pp_lobe lobe,
                     const struct pp_light_hit *hit, double u, double v)
{
    double factor;
    if (!pp_scatter_sample(lobes, lobe, u, v, &path->ray.to, &factor))
        return false;
    path->weight = pp_rgb_scale(path->weight, factor);
    bool through = lobe == PP_LOBE_THROUGH_DIFFUSE || lobe == PP_LOBE_THROUGH_GLOSS
                   || lobe == PP_LOBE_STRAIGHT;
    path->ray.from = hit->point;
    path->ray.off = through ? pp_vec_scale(lobes->n, -1.0) : lobes->n;
    path->ray.space =
        through ? pp_light_path_part_space(state->scene, hit->part, !hit->back)
                : hit->space;
    if (lobe != PP_LOBE_STRAIGHT)
        path->aimed_in = path->ray.space;
    if (lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE) {
        path->aimed = PP_DIRECTLY_SAMPLED_ALL;
        path->mirror_path = -1;
        path->depth++;
    } else if (lobe == PP_LOBE_GLOSS || lobe == PP_LOBE_THROUGH_GLOSS) {
        path->aimed = PP_DIRECTLY_SAMPLED_SMALL;
        path->mirror_path = -1;
        path->from = hit->point;
        path->width = PP_DIRECTLY_SAMPLED_WIDTHS * pp_scatter_gloss_width(lobes);
    } else if (lobe == PP_LOBE_MIRROR) {
        path->mirror_path = pp_mirrors_path_extend(
            state->scene, path->mirror_path, state->scene->parts[hit->part].mirror);
        if (path->mirror_path < 0)
            path->aimed = PP_DIRECTLY_SAMPLED_NONE;
    }
    return true;
}

/* Sends the path on from the surface by one of its lobes; false where it ends. */
static bool send_on(struct pp_radiance_state *state, struct pp_light_path *path,
                    const struct pp_lobes *lobes, const struct pp_light_hit *hit)
{
    double u[4]; /* direction (2), lobe, going on */
    pp_sobol_sequence_draw(&state->sequence, state->index, path->vertex * PP_DRAWS, 4,
                           u);
    enum pp_lobe lobe = choose_lobe(lobes, u[2], &path->weight);
    if (lobe == PP_LOBE_COUNT || !leave_by(state, path, lobes, lobe, hit, u[0], u[1]))
        return false;
    bool diffuse = lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE;
    double least = diffuse ? path->least : LEAST_GLOSS * path->least;
    double chance = pp_rgb_most(path->weight) / least;
    if (chance >= 1.0)
        return true;
    path->weight = pp_rgb_scale(path->weight, 1.0 / chance);
    return u[3] < chance;
}

/* What one of the lobes brings, as a path of its own. */
static struct pp_rgb follow_lobe(struct pp_radiance_state *state,
                                 const struct pp_light_path *path,
                                 const struct pp_lobes *lobes, enum pp_lobe lobe,
                                 const struct pp_light_hit *hit)
{
    struct pp_light_path other = *path;
    double u[2];
    other.vertex = pp_light_path_branch_vertex(path->vertex, PP_DRAWS + (int)lobe);
    other.weight = pp_rgb_times(path->weight, lobes->share[lobe]);
    pp_sobol_sequence_draw(&state->sequence, state->index, other.vertex++ * PP_DRAWS, 2,
                           u);
    if (!leave_by(state, &other, lobes, lobe, hit, u[0], u[1]))
        return pp_rgb_grey(0.0);
    return pp_light_path_follow(state, &other, NULL);
}

/* Gloss and mirror bring much or nothing: where something else is left for the path
 * itself, they are followed beside it, and done with. */
static struct pp_rgb follow_others(struct pp_radiance_state *state,
                                   const struct pp_light_path *path,
                                   struct pp_lobes *lobes,
                                   const struct pp_light_hit *hit)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    int left = 0;
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        left += !pp_rgb_is_black(lobes->share[i]);
    for (int i = PP_LOBE_GLOSS; i <= PP_LOBE_MIRROR && left > 1; i++) {
        if (pp_rgb_is_black(lobes->share[i]))
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

/* The point that was met, back along the ray by half of what lifts rays off their
 * surface (light_scene.c): in a corner, to the bit, it would lie in the other surface
 * too, and a ray that starts there might be on its wrong side. */
static struct pp_light_hit drawn_back(const struct pp_light_hit *hit, struct pp_vec3 to)
{
    struct pp_light_hit back = *hit;
    double reach = fabs(hit->point.x) + fabs(hit->point.y) + fabs(hit->point.z);
    back.point = pp_vec_along(hit->point, -0x1p-21 - 0x1p-21 * reach, to);
    return back;
}

bool pp_light_path_arrive(struct pp_radiance_state *state, struct pp_light_path *path,
                          enum pp_meeting meeting, const struct pp_light_hit *hit,
                          struct pp_rgb *total)
{
    const struct pp_light_scene *scene = state->scene;
    if (meeting == PP_MEETS_ENVIRONMENT)
        add_environment(state, path, hit->distance_m, total);
    if (meeting != PP_MEETS_PART || path->bounces++ > MOST_BOUNCES
        || !add_emission(state, path, hit, total))
        return false;

    struct pp_lobes lobes;
    pp_scatter_init(&lobes, &scene->materials[hit->material],
                    pp_light_scene_gloss(scene, hit->material), hit->normal,
                    pp_vec_scale(path->ray.to, -1.0));
    int window = scene->parts[hit->part].window;
    if (window >= 0 && !hit->back
        && pp_light_windows_directly_sampled(state, path, window))
        lobes.share[PP_LOBE_STRAIGHT] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);

    struct pp_light_hit from = drawn_back(hit, path->ray.to);
    struct pp_rgb here = aim_at_all(state, &lobes, &from, path);
    /* Behind clear glass it is still the first surface that scatters. */
    bool first = path->many && path->bounces <= FIRST_FEW;
    path->many = path->many && !scatters(&lobes);
    int most = state->options.bounces;
    if (most >= 0 && path->depth >= most)
        lobes.share[PP_LOBE_DIFFUSE] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);
    else if (state->ambient)
        here = pp_rgb_add(here, ambient_reflected(state, &lobes, hit, path));
    *total = pp_rgb_add(*total, pp_rgb_times(path->weight, here));
    if (first)
        *total = pp_rgb_add(*total, follow_others(state, path, &lobes, &from));
    bool goes = send_on(state, path, &lobes, &from);
    path->vertex++;
    return goes;
}
