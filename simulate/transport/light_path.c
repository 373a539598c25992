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

enum pp_meeting pp_light_path_meet(struct pp_radiance_walk *walk,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit)
{
    walk->rays++;
    enum pp_meeting meeting = pp_light_scene_meet(walk->scene, ray, hit);
    walk->leaks += meeting == PP_MEETS_CRACK;
    return meeting;
}

struct pp_rgb pp_light_path_follow(struct pp_radiance_walk *walk,
                                   struct pp_light_path *path,
                                   struct pp_light_hit *first)
{
    struct pp_rgb total = pp_rgb_grey(0.0);
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_light_path_meet(walk, &path->ray, &hit);
    if (first)
        *first = hit;
    while (pp_light_path_arrive(walk, path, meeting, &hit, &total))
        meeting = pp_light_path_meet(walk, &path->ray, &hit);
    return total;
}

/* ---- at a surface ---- */

/* All that is aimed at, on the sides of the surface that send it on to the eye. */
static struct pp_rgb aim_at_all(struct pp_radiance_walk *walk,
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
        struct pp_lit lit = {
            .point = hit->point,
            .normal = side ? pp_scale(lobes->n, -1.0) : lobes->n,
            .space =
                side ? pp_part_space(walk->scene, hit->part, !hit->back) : hit->space,
            .lobes = lobes,
            .vertex = side ? pp_branch_off(path->vertex, 0) : path->vertex,
            .depth = path->depth,
            .many = path->many};
        sum.sources = pp_rgb_add(sum.sources, pp_light_from_sources(walk, &lit));
        if (!path->by_window)
            pp_light_from_windows(walk, &lit, &sum);
    }
    return pp_irradiance_sum(&sum);
}

/* Diffuse inter-reflection from elsewhere; a lobe that has it is done with. */
static struct pp_rgb ask_ambient(const struct pp_radiance_walk *walk,
                                 struct pp_lobes *lobes, const struct pp_light_hit *hit,
                                 const struct pp_light_path *path)
{
    struct pp_rgb sum = pp_rgb_grey(0.0), value;
    struct pp_light_hit there = *hit;
    there.point = pp_add(hit->point, walk->scene->centre);
    for (int side = 0; side < 2; side++) {
        struct pp_rgb *share =
            &lobes->share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
        struct pp_vec3 normal = side ? pp_scale(lobes->n, -1.0) : lobes->n;
        if (pp_rgb_is_black(*share)
            || !walk->ambient->irradiance(walk->ambient->store, &there, normal,
                                          path->depth, &value))
            continue;
        sum = pp_rgb_along(sum, 1.0 / PP_PI, pp_rgb_times(*share, value));
        *share = pp_rgb_grey(0.0);
    }
    return sum;
}

/* What the surface itself gives off along the path; false where the path ends there. */
static bool add_emission(const struct pp_radiance_walk *walk,
                         const struct pp_light_path *path,
                         const struct pp_light_hit *hit, struct pp_rgb *total)
{
    const struct pp_light_part *part = &walk->scene->parts[hit->part];
    const struct pp_material *material = &walk->scene->materials[hit->material];
    if (material->emits == PP_EMITS_NOTHING || (hit->back && !part->back_emits))
        return true;
    if (material->unseen && path->aimed == PP_AIMED_AT_NOTHING)
        return true;
    int emitter = part->emitter[hit->back];
    if (emitter < 0 || !pp_emitter_counted(walk, path, emitter))
        *total = pp_rgb_add(*total, pp_rgb_times(path->weight, material->radiance));
    return !material->unseen;
}

/* What is beyond, distant sources that have not been aimed at among it. */
static void add_beyond(const struct pp_radiance_walk *walk,
                       const struct pp_light_path *path, double near_m,
                       struct pp_rgb *total)
{
    const struct pp_light_scene *scene = walk->scene;
    struct pp_rgb light = pp_light_scene_beyond(scene, &path->ray, near_m, NULL);
    for (int i = 0; i < scene->distant_count; i++)
        if (scene->distants[i].emitter >= 0
            && !pp_emitter_counted(walk, path, scene->distants[i].emitter))
            light = pp_rgb_add(light, pp_distant_radiance(scene, i, path->ray.to));
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
static bool leave_by(const struct pp_radiance_walk *walk, struct pp_light_path *path,
                     const struct pp_lobes *lobes, enum pp_lobe lobe,
                     const struct pp_light_hit *hit, double u, double v)
{
    double factor;
    if (!pp_lobes_sample(lobes, lobe, u, v, &path->ray.to, &factor))
        return false;
    path->weight = pp_rgb_scale(path->weight, factor);
    bool through = lobe == PP_LOBE_THROUGH_DIFFUSE || lobe == PP_LOBE_THROUGH_GLOSS
                   || lobe == PP_LOBE_STRAIGHT;
    path->ray.from = hit->point;
    path->ray.off = through ? pp_scale(lobes->n, -1.0) : lobes->n;
    path->ray.space =
        through ? pp_part_space(walk->scene, hit->part, !hit->back) : hit->space;
    if (lobe != PP_LOBE_STRAIGHT)
        path->aimed_in = path->ray.space;
    if (lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE) {
        path->aimed = PP_AIMED_AT_ALL;
        path->chain = -1;
        path->depth++;
    } else if (lobe == PP_LOBE_GLOSS || lobe == PP_LOBE_THROUGH_GLOSS) {
        path->aimed = PP_AIMED_AT_SMALL;
        path->chain = -1;
        path->from = hit->point;
        path->width = PP_AIMED_WIDTHS * pp_lobes_width(lobes);
    } else if (lobe == PP_LOBE_MIRROR) {
        path->chain = pp_chain_longer(walk->scene, path->chain,
                                      walk->scene->parts[hit->part].mirror);
        if (path->chain < 0)
            path->aimed = PP_AIMED_AT_NOTHING;
    }
    return true;
}

/* Sends the path on from the surface by one of its lobes; false where it ends. */
static bool send_on(struct pp_radiance_walk *walk, struct pp_light_path *path,
                    const struct pp_lobes *lobes, const struct pp_light_hit *hit)
{
    double u[4]; /* direction (2), lobe, going on */
    pp_sequence_draw(&walk->sequence, walk->index, path->vertex * PP_DRAWS, 4, u);
    enum pp_lobe lobe = choose_lobe(lobes, u[2], &path->weight);
    if (lobe == PP_LOBE_COUNT || !leave_by(walk, path, lobes, lobe, hit, u[0], u[1]))
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
static struct pp_rgb follow_lobe(struct pp_radiance_walk *walk,
                                 const struct pp_light_path *path,
                                 const struct pp_lobes *lobes, enum pp_lobe lobe,
                                 const struct pp_light_hit *hit)
{
    struct pp_light_path other = *path;
    double u[2];
    other.vertex = pp_branch_off(path->vertex, PP_DRAWS + (int)lobe);
    other.weight = pp_rgb_times(path->weight, lobes->share[lobe]);
    pp_sequence_draw(&walk->sequence, walk->index, other.vertex++ * PP_DRAWS, 2, u);
    if (!leave_by(walk, &other, lobes, lobe, hit, u[0], u[1]))
        return pp_rgb_grey(0.0);
    return pp_light_path_follow(walk, &other, NULL);
}

/* Gloss and mirror bring much or nothing: where something else is left for the path
 * itself, they are followed beside it, and done with. */
static struct pp_rgb follow_others(struct pp_radiance_walk *walk,
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
        sum = pp_rgb_add(sum, follow_lobe(walk, path, lobes, (enum pp_lobe)i, hit));
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
    back.point = pp_along(hit->point, -0x1p-21 - 0x1p-21 * reach, to);
    return back;
}

bool pp_light_path_arrive(struct pp_radiance_walk *walk, struct pp_light_path *path,
                          enum pp_meeting meeting, const struct pp_light_hit *hit,
                          struct pp_rgb *total)
{
    const struct pp_light_scene *scene = walk->scene;
    if (meeting == PP_MEETS_BEYOND)
        add_beyond(walk, path, hit->distance_m, total);
    if (meeting != PP_MEETS_PART || path->bounces++ > MOST_BOUNCES
        || !add_emission(walk, path, hit, total))
        return false;

    struct pp_lobes lobes;
    pp_lobes_init(&lobes, &scene->materials[hit->material],
                  pp_light_scene_gloss(scene, hit->material), hit->normal,
                  pp_scale(path->ray.to, -1.0));
    int window = scene->parts[hit->part].window;
    if (window >= 0 && !hit->back && pp_window_counted(walk, path, window))
        lobes.share[PP_LOBE_STRAIGHT] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);

    struct pp_light_hit from = drawn_back(hit, path->ray.to);
    struct pp_rgb here = aim_at_all(walk, &lobes, &from, path);
    /* Behind clear glass it is still the first surface that scatters. */
    bool first = path->many && path->bounces <= FIRST_FEW;
    path->many = path->many && !scatters(&lobes);
    int most = walk->options.bounces;
    if (most >= 0 && path->depth >= most)
        lobes.share[PP_LOBE_DIFFUSE] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);
    else if (walk->ambient)
        here = pp_rgb_add(here, ask_ambient(walk, &lobes, hit, path));
    *total = pp_rgb_add(*total, pp_rgb_times(path->weight, here));
    if (first)
        *total = pp_rgb_add(*total, follow_others(walk, path, &lobes, &from));
    bool goes = send_on(walk, path, &lobes, &from);
    path->vertex++;
    return goes;
}
