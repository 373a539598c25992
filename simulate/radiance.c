/* radiance.c - see radiance.h. All points are measured from the scene's centre. */
#include "simulate/radiance.h"

#include <math.h>

#include "simulate/hash.h"
#include "simulate/light_parts.h"
#include "simulate/lobe.h"
#include "simulate/scatter.h"
#include "simulate/window_store.h"

enum {
    /* A path ends here where nothing ever absorbs. */
    MOST_BOUNCES = 1 << 14,
    /* Clear surfaces between a point and what it aims at, at most. */
    MOST_PANES = 64,
    /* Draws of a vertex: its own, for sources, for windows, for diffusing panes. */
    DRAW_SOURCES = 1,
    DRAW_WINDOWS = 2,
    DRAW_PANES = 3,
    DRAWS = 4,
    /* At the first surface each of so many emitters is aimed at; of more, one a path.
     */
    MOST_EMITTERS = 64,
    /* Among its first surfaces a path looks both through glass and at what it mirrors.
     */
    BOTH_WAYS = 3,
};

/* A gloss aims at what looks smaller than so many of its roughnesses: then no aimed
 * sample is worth more than one that finds it, (3 a)^2 / (4 pi a^2) of it at most. */
static const double AIMED_WIDTHS = 3.0;

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

/* What has been aimed at from where a ray was sent off: if it comes to it all the same,
 * it counts nothing. */
enum aimed {
    AIMED_AT_NOTHING, /* from the eye, or a mirror */
    AIMED_AT_SMALL,   /* from a gloss: at what looks small to it */
    AIMED_AT_ALL,     /* from a diffuse surface */
};

/* The end of a path so far. */
struct path {
    struct pp_light_ray ray;
    struct pp_rgb weight;
    double least; /* Russian roulette below this weight */
    enum aimed aimed;
    struct pp_vec3 from; /* of AIMED_AT_SMALL: where, and how large is small */
    double width;
    int depth;   /* diffuse reflections behind it */
    int vertex;  /* of the random numbers */
    int bounces; /* surfaces met */
    bool many;   /* aim in many directions at the next surface: it is the first */
};

/* Vertex numbers for a path that branches off a vertex: anywhere else. */
static int branch(int vertex, int kind)
{
    uint32_t mixed = pp_mix32((uint32_t)vertex * DRAWS + (uint32_t)kind + 1);
    return (int)(mixed >> 4) + 64;
}

static enum pp_meeting meet(struct pp_radiance_walk *walk,
                            const struct pp_light_ray *ray, struct pp_light_hit *hit)
{
    walk->rays++;
    enum pp_meeting meeting = pp_light_scene_meet(walk->scene, ray, hit);
    walk->leaks += meeting == PP_MEETS_CRACK;
    return meeting;
}

static enum pp_space space_of(const struct pp_light_scene *scene, int part, bool back)
{
    return (enum pp_space)scene->parts[part].space[back];
}

/* ---- what has been aimed at ---- */

static bool emitter_counted(const struct pp_radiance_walk *walk,
                            const struct path *path, int emitter)
{
    if (!walk->options.sources || path->aimed == AIMED_AT_NOTHING)
        return false;
    if (path->aimed == AIMED_AT_ALL)
        return true;
    return pp_emitter_spread(&walk->scene->emitters[emitter], walk->scene, path->from)
           < path->width;
}

static double window_spread(const struct pp_light_scene *scene, int window,
                            struct pp_vec3 from)
{
    const struct pp_target *target = &scene->room->panes[window].target;
    struct pp_vec3 to = pp_sub(target->middle, from);
    return sqrt(target->area_m2 / pp_dot(to, to));
}

static bool window_counted(const struct pp_radiance_walk *walk, const struct path *path,
                           int window)
{
    if (!walk->options.windows || path->aimed == AIMED_AT_NOTHING)
        return false;
    if (path->aimed == AIMED_AT_ALL)
        return true;
    return window_spread(walk->scene, window, path->from) < path->width;
}

/* ---- aiming ---- */

/* A surface that is lit, on one of its sides. */
struct lit {
    struct pp_vec3 point, normal; /* of that side */
    enum pp_space space;
    const struct pp_lobes *lobes;
    int vertex, depth;
    bool many;
};

/* What goes to the eye of light from direction o: f, with the gloss where what is aimed
 * at looks small to it. */
static struct pp_rgb sent_on(const struct lit *lit, struct pp_vec3 o, double spread)
{
    const struct pp_lobes *lobes = lit->lobes;
    bool through = pp_dot(lobes->n, lit->normal) < 0.0;
    struct pp_rgb diffuse =
        lobes->share[through ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
    struct pp_rgb f = pp_rgb_scale(diffuse, 1.0 / PP_PI);
    if (spread < AIMED_WIDTHS * pp_lobes_width(lobes))
        f = pp_rgb_add(f, pp_lobes_gloss(lobes, o));
    return f;
}

/* Goes straight, through what is clear, to a part at a distance (-1: to what is
 * beyond); false if something stands before it. */
static bool reach(struct pp_radiance_walk *walk, struct pp_light_ray ray, int part,
                  double distance_m, struct pp_rgb *through)
{
    const struct pp_light_scene *scene = walk->scene;
    double gone = 0.0;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = meet(walk, &ray, &hit);
        if (meeting == PP_MEETS_BEYOND)
            return part < 0 && isinf(hit.distance_m);
        if (meeting == PP_MEETS_CRACK)
            return false;
        gone += hit.distance_m;
        if (hit.part == part && fabs(gone - distance_m) < 1e-4 * distance_m + 1e-5)
            return true;
        *through =
            pp_rgb_times(*through, pp_straight_through(&scene->materials[hit.material],
                                                       -pp_dot(hit.normal, ray.to)));
        if (pp_rgb_is_black(*through))
            return false;
        ray.from = hit.point;
        ray.off = pp_scale(hit.normal, -1.0);
        ray.space = space_of(scene, hit.part, !hit.back);
    }
    return false;
}

static struct pp_light_ray ray_from(const struct lit *lit, struct pp_vec3 to)
{
    return (struct pp_light_ray){lit->point, lit->normal, to, lit->space};
}

/* Light from one direction to an emitter. */
static struct pp_rgb from_emitter(struct pp_radiance_walk *walk, const struct lit *lit,
                                  const struct pp_emitter *emitter, double spread,
                                  const struct pp_aimed *aimed)
{
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    double facing = pp_dot(lit->normal, aimed->direction);
    if (!(facing > 0.0))
        return none;
    struct pp_rgb f = sent_on(lit, aimed->direction, spread);
    if (pp_rgb_is_black(f)
        || !reach(walk, ray_from(lit, aimed->direction), emitter->part,
                  aimed->distance_m, &through))
        return none;
    struct pp_rgb radiance =
        emitter->distant < 0
            ? emitter->radiance
            : pp_distant_radiance(walk->scene, emitter->distant, aimed->direction);
    return pp_rgb_scale(pp_rgb_times(pp_rgb_times(f, through), radiance),
                        facing * aimed->per_density);
}

static struct pp_rgb light_of_emitter(struct pp_radiance_walk *walk,
                                      const struct lit *lit, int index, int vertex)
{
    const struct pp_emitter *emitter = &walk->scene->emitters[index];
    struct pp_rgb sum = pp_rgb_grey(0.0);
    struct pp_emitter_aim aim;
    if (!pp_emitter_aim_init(&aim, walk->scene, emitter, lit->point, lit->normal))
        return sum;
    double spread = pp_emitter_spread(emitter, walk->scene, lit->point);
    uint32_t count = lit->many ? pp_directions_to(spread, walk->options.source_size,
                                                  walk->options.source_most)
                               : 1;
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        struct pp_aimed aimed;
        pp_sequence_draw(&walk->sequence, walk->index * count + i, vertex, 2, u);
        if (pp_emitter_aim_sample(&aim, u[0], u[1], &aimed))
            sum = pp_rgb_add(sum, from_emitter(walk, lit, emitter, spread, &aimed));
    }
    return pp_rgb_scale(sum, 1.0 / count);
}

/* The emitter that u falls to, in proportion to what each may count; -1: none. */
static int choose_emitter(const struct pp_light_scene *scene, const struct lit *lit,
                          double u, double *probability)
{
    double total = 0.0;
    for (int i = 0; i < scene->emitter_count; i++)
        total +=
            pp_emitter_importance(&scene->emitters[i], scene, lit->point, lit->normal);
    double left = u * total;
    int chosen = -1;
    for (int i = 0; i < scene->emitter_count; i++) {
        double importance =
            pp_emitter_importance(&scene->emitters[i], scene, lit->point, lit->normal);
        if (!(importance > 0.0))
            continue;
        chosen = i;
        *probability = importance / total;
        if (left < importance)
            break;
        left -= importance;
    }
    return chosen;
}

static struct pp_rgb from_sources(struct pp_radiance_walk *walk, const struct lit *lit)
{
    const struct pp_light_scene *scene = walk->scene;
    struct pp_rgb sum = pp_rgb_grey(0.0);
    if (!walk->options.sources || scene->emitter_count == 0)
        return sum;
    int vertex = lit->vertex * DRAWS + DRAW_SOURCES;
    if (scene->emitter_count == 1
        || (lit->many && scene->emitter_count <= MOST_EMITTERS)) {
        for (int i = 0; i < scene->emitter_count; i++)
            sum =
                pp_rgb_add(sum, light_of_emitter(walk, lit, i,
                                                 i == 0 ? vertex : branch(vertex, i)));
        return sum;
    }
    double u, probability;
    pp_sequence_draw(&walk->sequence, walk->index, branch(vertex, 0), 1, &u);
    int chosen = choose_emitter(scene, lit, u, &probability);
    if (chosen < 0)
        return sum;
    return pp_rgb_scale(light_of_emitter(walk, lit, chosen, vertex), 1.0 / probability);
}

/* ---- windows ---- */

static bool arrive(struct pp_radiance_walk *walk, struct path *path,
                   enum pp_meeting meeting, const struct pp_light_hit *hit,
                   struct pp_rgb *total);

/* Follows a path to its end; what it meets first goes to *first (may be NULL). */
static struct pp_rgb follow(struct pp_radiance_walk *walk, struct path *path,
                            struct pp_light_hit *first)
{
    struct pp_rgb total = pp_rgb_grey(0.0);
    struct pp_light_hit hit;
    enum pp_meeting meeting = meet(walk, &path->ray, &hit);
    if (first)
        *first = hit;
    while (arrive(walk, path, meeting, &hit, &total))
        meeting = meet(walk, &path->ray, &hit);
    return total;
}

static struct path path_outside(const struct pp_radiance_walk *walk,
                                const struct pp_light_ray *ray, int vertex, int depth)
{
    return (struct path){.ray = *ray,
                         .weight = pp_rgb_grey(1.0),
                         .least = walk->options.least,
                         .aimed = AIMED_AT_ALL,
                         .depth = depth,
                         .vertex = vertex};
}

bool pp_radiance_of_outside(struct pp_radiance_walk *walk,
                            const struct pp_light_ray *ray, struct pp_rgb *radiance,
                            double *distance_m)
{
    struct pp_light_hit hit;
    struct path path = path_outside(walk, ray, 1, 0);
    *radiance = pp_rgb_grey(0.0);
    enum pp_meeting meeting = meet(walk, ray, &hit);
    *distance_m = hit.distance_m;
    if (meeting != PP_MEETS_PART)
        return false;
    if (arrive(walk, &path, meeting, &hit, radiance))
        *radiance = pp_rgb_add(*radiance, follow(walk, &path, NULL));
    return true;
}

/* The light that comes along the ray from outside to the window. */
static struct pp_rgb light_outside(struct pp_radiance_walk *walk,
                                   const struct pp_light_ray *ray, int window,
                                   int vertex, int depth, bool *is_sky)
{
    const struct pp_light_scene *scene = walk->scene;
    *is_sky = false;
    if (scene->room->panes[window].nothing_beyond && scene->emitter_count == 0) {
        double exitance, near = pp_outside_near(&scene->room->outside, ray->from,
                                                ray->to, &exitance);
        return pp_light_scene_beyond(scene, ray, near, is_sky);
    }
    struct pp_light_hit hit;
    enum pp_meeting meeting = meet(walk, ray, &hit);
    if (meeting == PP_MEETS_BEYOND)
        return pp_light_scene_beyond(scene, ray, hit.distance_m, is_sky);
    struct pp_rgb radiance = pp_rgb_grey(0.0);
    if (meeting == PP_MEETS_CRACK)
        return radiance;
    if (walk->options.stored && walk->store
        && pp_window_store_radiance(walk->store, scene, window, ray->from, ray->to,
                                    &radiance))
        return radiance;
    struct path path = path_outside(walk, ray, vertex, depth);
    if (arrive(walk, &path, meeting, &hit, &radiance))
        radiance = pp_rgb_add(radiance, follow(walk, &path, NULL));
    return radiance;
}

static struct pp_rgb sum_of(const struct pp_irradiance *e)
{
    return pp_rgb_add(pp_rgb_add(e->sources, e->rest), pp_rgb_add(e->sky, e->outside));
}

struct pp_irradiance pp_radiance_on_pane(struct pp_radiance_walk *walk, int window,
                                         struct pp_vec3 point)
{
    const struct pp_light_scene *scene = walk->scene;
    const struct pp_facet *facet =
        &scene->room->facets[scene->room->panes[window].facet];
    struct pp_irradiance e = {.rest = pp_rgb_grey(0.0)};
    struct pp_lobes lobes = {.n = pp_scale(facet->normal, -1.0)};
    lobes.share[PP_LOBE_DIFFUSE] = pp_rgb_grey(PP_PI);
    struct lit lit = {.point = point,
                      .normal = lobes.n,
                      .space = PP_OUTDOORS,
                      .lobes = &lobes,
                      .vertex = branch(0, DRAW_PANES)};
    e.outside = from_sources(walk, &lit);
    double u[2];
    bool is_sky;
    pp_sequence_draw(&walk->sequence, walk->index, 0, 2, u);
    struct pp_vec3 to = pp_sample_lobe(facet->a, facet->b, lobes.n, u[0], u[1]);
    struct pp_light_ray ray = {point, lobes.n, to, PP_OUTDOORS};
    struct pp_rgb light =
        pp_rgb_scale(light_outside(walk, &ray, window, 1, 0, &is_sky), PP_PI);
    if (is_sky)
        e.sky = light;
    else
        e.outside = pp_rgb_add(e.outside, light);
    return e;
}

/* What a diffusing pane gives off to the room, of what falls on it at the point. */
static struct pp_rgb light_of_pane(struct pp_radiance_walk *walk, int window,
                                   struct pp_vec3 point, int vertex, int depth,
                                   struct pp_rgb transmittance, struct pp_rgb *sky)
{
    struct pp_irradiance e;
    struct pp_rgb share = pp_rgb_scale(transmittance, 1.0 / PP_PI);
    if (!walk->options.stored || !walk->store
        || !pp_window_store_irradiance(walk->store, walk->scene, window, point, &e)) {
        const struct pp_facet *facet =
            &walk->scene->room->facets[walk->scene->room->panes[window].facet];
        struct pp_vec3 out = pp_scale(facet->normal, -1.0);
        double u[2];
        bool is_sky;
        pp_sequence_draw(&walk->sequence, walk->index, vertex, 2, u);
        struct pp_vec3 to = pp_sample_lobe(facet->a, facet->b, out, u[0], u[1]);
        struct pp_light_ray ray = {point, out, to, PP_OUTDOORS};
        struct pp_rgb light = pp_rgb_scale(
            light_outside(walk, &ray, window, branch(vertex, 1), depth, &is_sky),
            PP_PI);
        *sky = pp_rgb_times(share, is_sky ? light : pp_rgb_grey(0.0));
        return pp_rgb_times(share, is_sky ? pp_rgb_grey(0.0) : light);
    }
    *sky = pp_rgb_times(share, e.sky);
    e.sky = pp_rgb_grey(0.0);
    return pp_rgb_times(share, sum_of(&e));
}

/* Light from one direction to a window; what of it is sky goes to *sky. */
static struct pp_rgb from_window(struct pp_radiance_walk *walk, const struct lit *lit,
                                 int window, double spread,
                                 const struct pp_aimed *aimed, struct pp_rgb *sky)
{
    const struct pp_light_scene *scene = walk->scene;
    const struct pp_pane *pane = &scene->room->panes[window];
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    *sky = none;
    double facing = pp_dot(lit->normal, aimed->direction);
    if (!(facing > 0.0))
        return none;
    struct pp_rgb f = sent_on(lit, aimed->direction, spread);
    bool open = pane->seen_by_all && lit->space == PP_INDOORS;
    if (pp_rgb_is_black(f)
        || (!open
            && !reach(walk, ray_from(lit, aimed->direction), pane->facet,
                      aimed->distance_m, &through)))
        return none;
    f = pp_rgb_scale(pp_rgb_times(f, through), facing * aimed->per_density);

    const struct pp_light_part *part = &scene->parts[pane->facet];
    const struct pp_material *material = &scene->materials[part->material[0]];
    int beyond = branch(branch(lit->vertex, DRAW_PANES), window);
    if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        struct pp_rgb rest = light_of_pane(walk, window, aimed->point, beyond,
                                           lit->depth, material->through_diffuse, sky);
        *sky = pp_rgb_times(*sky, f);
        return pp_rgb_times(rest, f);
    }
    f = pp_rgb_times(
        f, pp_straight_through(material, -pp_dot(part->normal, aimed->direction)));
    struct pp_light_ray ray = {aimed->point, pp_scale(part->normal, -1.0),
                               aimed->direction, PP_OUTDOORS};
    bool is_sky;
    struct pp_rgb light =
        pp_rgb_times(f, light_outside(walk, &ray, window, beyond, lit->depth, &is_sky));
    if (is_sky)
        *sky = light;
    return is_sky ? none : light;
}

static void light_of_window(struct pp_radiance_walk *walk, const struct lit *lit,
                            int window, int vertex, double weight,
                            struct pp_irradiance *sum)
{
    const struct pp_light_scene *scene = walk->scene;
    const struct pp_target *target = &scene->room->panes[window].target;
    if (!pp_target_in_sight(target, lit->point, lit->normal))
        return;
    struct pp_aim aim;
    pp_aim_init(&aim, target, lit->point, lit->normal, scene->room->brightness);
    double spread = window_spread(scene, window, lit->point);
    uint32_t index = walk->index;
    uint32_t count = lit->many ? pp_directions_to(spread, walk->options.source_size,
                                                  walk->options.source_most)
                               : 1;
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        struct pp_rgb sky;
        walk->index = index * count + i;
        pp_sequence_draw(&walk->sequence, walk->index, vertex, 2, u);
        struct pp_aimed aimed = pp_aim_sample(&aim, u[0], u[1]);
        struct pp_rgb light = from_window(walk, lit, window, spread, &aimed, &sky);
        sum->outside = pp_rgb_along(sum->outside, weight / count, light);
        sum->sky = pp_rgb_along(sum->sky, weight / count, sky);
    }
    walk->index = index;
}

static int choose_window(const struct pp_light_scene *scene, const struct lit *lit,
                         double u, double *probability)
{
    const struct pp_scene *room = scene->room;
    double total = 0.0;
    for (int i = 0; i < room->pane_count; i++)
        total += pp_target_importance(&room->panes[i].target, lit->point, lit->normal,
                                      room->brightness);
    double left = u * total;
    int chosen = -1;
    for (int i = 0; i < room->pane_count; i++) {
        double importance = pp_target_importance(&room->panes[i].target, lit->point,
                                                 lit->normal, room->brightness);
        if (!(importance > 0.0))
            continue;
        chosen = i;
        *probability = importance / total;
        if (left < importance)
            break;
        left -= importance;
    }
    return chosen;
}

static void from_windows(struct pp_radiance_walk *walk, const struct lit *lit,
                         struct pp_irradiance *sum)
{
    const struct pp_light_scene *scene = walk->scene;
    if (!walk->options.windows || !scene->room || scene->room->pane_count == 0
        || lit->space == PP_OUTDOORS)
        return;
    int vertex = lit->vertex * DRAWS + DRAW_WINDOWS;
    if (scene->room->pane_count == 1 || lit->many) {
        for (int i = 0; i < scene->room->pane_count; i++)
            light_of_window(walk, lit, i, i == 0 ? vertex : branch(vertex, i), 1.0,
                            sum);
        return;
    }
    double u, probability;
    pp_sequence_draw(&walk->sequence, walk->index, branch(vertex, 0), 1, &u);
    int chosen = choose_window(scene, lit, u, &probability);
    if (chosen >= 0)
        light_of_window(walk, lit, chosen, vertex, 1.0 / probability, sum);
}

/* ---- at a surface ---- */

/* All that is aimed at, on the sides of the surface that send it on to the eye. */
static struct pp_rgb aim_at_all(struct pp_radiance_walk *walk,
                                const struct pp_lobes *lobes,
                                const struct pp_light_hit *hit, const struct path *path)
{
    struct pp_irradiance sum = {.rest = pp_rgb_grey(0.0)};
    for (int side = 0; side < 2; side++) {
        const struct pp_rgb *share = lobes->share;
        if (pp_rgb_is_black(share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE])
            && pp_rgb_is_black(share[side ? PP_LOBE_THROUGH_GLOSS : PP_LOBE_GLOSS]))
            continue;
        struct lit lit = {.point = hit->point,
                          .normal = side ? pp_scale(lobes->n, -1.0) : lobes->n,
                          .space = side ? space_of(walk->scene, hit->part, !hit->back)
                                        : hit->space,
                          .lobes = lobes,
                          .vertex = side ? branch(path->vertex, 0) : path->vertex,
                          .depth = path->depth,
                          .many = path->many};
        sum.sources = pp_rgb_add(sum.sources, from_sources(walk, &lit));
        from_windows(walk, &lit, &sum);
    }
    return sum_of(&sum);
}

/* Diffuse inter-reflection from elsewhere; a lobe that has it is done with. */
static struct pp_rgb ask_ambient(const struct pp_radiance_walk *walk,
                                 struct pp_lobes *lobes, const struct pp_light_hit *hit,
                                 const struct path *path)
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
static bool add_emission(const struct pp_radiance_walk *walk, const struct path *path,
                         const struct pp_light_hit *hit, struct pp_rgb *total)
{
    const struct pp_light_part *part = &walk->scene->parts[hit->part];
    const struct pp_material *material = &walk->scene->materials[hit->material];
    if (material->emits == PP_EMITS_NOTHING || (hit->back && !part->back_emits))
        return true;
    if (material->unseen && path->aimed == AIMED_AT_NOTHING)
        return true;
    bool counted = false;
    if (material->emits == PP_EMITS_CONCENTRATED && part->emitter >= 0) {
        int emitter = part->emitter;
        emitter += hit->back && !walk->scene->emitters[emitter].back;
        counted = emitter_counted(walk, path, emitter);
    }
    if (!counted)
        *total = pp_rgb_add(*total, pp_rgb_times(path->weight, material->radiance));
    return !material->unseen;
}

/* What is beyond, distant sources that have not been aimed at among it. */
static void add_beyond(const struct pp_radiance_walk *walk, const struct path *path,
                       double near_m, struct pp_rgb *total)
{
    const struct pp_light_scene *scene = walk->scene;
    struct pp_rgb light = pp_light_scene_beyond(scene, &path->ray, near_m, NULL);
    for (int i = 0; i < scene->distant_count; i++)
        if (scene->distants[i].emitter >= 0
            && !emitter_counted(walk, path, scene->distants[i].emitter))
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

/* Sends the path on from the surface by one of its lobes; false where it ends. */
static bool send_on(struct pp_radiance_walk *walk, struct path *path,
                    const struct pp_lobes *lobes, const struct pp_light_hit *hit)
{
    double u[4]; /* direction (2), lobe, going on */
    pp_sequence_draw(&walk->sequence, walk->index, path->vertex * DRAWS, 4, u);
    enum pp_lobe lobe = choose_lobe(lobes, u[2], &path->weight);
    double factor;
    if (lobe == PP_LOBE_COUNT
        || !pp_lobes_sample(lobes, lobe, u[0], u[1], &path->ray.to, &factor))
        return false;
    path->weight = pp_rgb_scale(path->weight, factor);
    bool through = lobe == PP_LOBE_THROUGH_DIFFUSE || lobe == PP_LOBE_THROUGH_GLOSS
                   || lobe == PP_LOBE_STRAIGHT;
    path->ray.from = hit->point;
    path->ray.off = through ? pp_scale(lobes->n, -1.0) : lobes->n;
    path->ray.space =
        through ? space_of(walk->scene, hit->part, !hit->back) : hit->space;
    if (lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE) {
        path->aimed = AIMED_AT_ALL;
        path->depth++;
    } else if (lobe == PP_LOBE_GLOSS || lobe == PP_LOBE_THROUGH_GLOSS) {
        path->aimed = AIMED_AT_SMALL;
        path->from = hit->point;
        path->width = AIMED_WIDTHS * pp_lobes_width(lobes);
    } else if (lobe == PP_LOBE_MIRROR) {
        path->aimed = AIMED_AT_NOTHING;
    }

    double chance = pp_rgb_most(path->weight) / path->least;
    if (chance >= 1.0)
        return true;
    path->weight = pp_rgb_scale(path->weight, 1.0 / chance);
    return u[3] < chance;
}

/* What glass mirrors, as a path of its own: the first one looks through it alone. */
static struct pp_rgb mirrored(struct pp_radiance_walk *walk, const struct path *path,
                              struct pp_lobes *lobes, const struct pp_light_hit *hit)
{
    struct path other = *path;
    double factor;
    other.weight = pp_rgb_times(path->weight, lobes->share[PP_LOBE_MIRROR]);
    lobes->share[PP_LOBE_MIRROR] = pp_rgb_grey(0.0);
    pp_lobes_sample(lobes, PP_LOBE_MIRROR, 0.0, 0.0, &other.ray.to, &factor);
    other.ray.from = hit->point;
    other.ray.off = lobes->n;
    other.ray.space = hit->space;
    other.vertex = branch(path->vertex, DRAWS);
    return follow(walk, &other, NULL);
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

/* Takes what a path finds where it has come to, and turns it on to where it goes from
 * there; false where it ends. */
static bool arrive(struct pp_radiance_walk *walk, struct path *path,
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
    pp_lobes_init(&lobes, &scene->materials[hit->material], hit->normal,
                  pp_scale(path->ray.to, -1.0));
    int window = scene->parts[hit->part].window;
    if (window >= 0 && !hit->back && window_counted(walk, path, window))
        lobes.share[PP_LOBE_STRAIGHT] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);

    bool scatters = !pp_rgb_is_black(lobes.share[PP_LOBE_DIFFUSE])
                    || !pp_rgb_is_black(lobes.share[PP_LOBE_THROUGH_DIFFUSE])
                    || !pp_rgb_is_black(lobes.share[PP_LOBE_GLOSS]);
    struct pp_light_hit from = drawn_back(hit, path->ray.to);
    struct pp_rgb here = aim_at_all(walk, &lobes, &from, path);
    int most = walk->options.bounces;
    if (most >= 0 && path->depth >= most)
        lobes.share[PP_LOBE_DIFFUSE] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);
    else if (walk->ambient)
        here = pp_rgb_add(here, ask_ambient(walk, &lobes, hit, path));
    *total = pp_rgb_add(*total, pp_rgb_times(path->weight, here));
    /* Behind clear glass it is still the first surface that scatters. */
    if (path->many && path->bounces <= BOTH_WAYS
        && !pp_rgb_is_black(lobes.share[PP_LOBE_MIRROR])
        && !pp_rgb_is_black(lobes.share[PP_LOBE_STRAIGHT]))
        *total = pp_rgb_add(*total, mirrored(walk, path, &lobes, &from));
    path->many = path->many && !scatters;
    bool goes = send_on(walk, path, &lobes, &from);
    path->vertex++;
    return goes;
}

/* ---- what is asked for ---- */

static struct pp_rgb along(struct pp_radiance_walk *walk,
                           const struct pp_light_ray *ray, enum aimed aimed,
                           struct pp_light_hit *hit)
{
    struct path path = {.ray = *ray,
                        .weight = pp_rgb_grey(1.0),
                        .least = walk->options.least,
                        .aimed = aimed,
                        .depth = aimed == AIMED_AT_ALL,
                        .vertex = 1,
                        .many = aimed == AIMED_AT_NOTHING};
    path.ray.from = pp_sub(ray->from, walk->scene->centre);
    struct pp_rgb radiance = follow(walk, &path, hit);
    if (hit)
        hit->point = pp_add(hit->point, walk->scene->centre);
    return radiance;
}

struct pp_rgb pp_radiance_along(struct pp_radiance_walk *walk,
                                const struct pp_light_ray *ray,
                                struct pp_light_hit *hit)
{
    return along(walk, ray, AIMED_AT_NOTHING, hit);
}

struct pp_rgb pp_radiance_indirect(struct pp_radiance_walk *walk,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit)
{
    return along(walk, ray, AIMED_AT_ALL, hit);
}

struct pp_irradiance pp_radiance_direct(struct pp_radiance_walk *walk,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        enum pp_space space)
{
    struct pp_irradiance e = {.rest = pp_rgb_grey(0.0)};
    struct pp_lobes lobes = {.n = normal};
    lobes.share[PP_LOBE_DIFFUSE] = pp_rgb_grey(PP_PI);
    struct lit lit = {.point = pp_sub(point, walk->scene->centre),
                      .normal = normal,
                      .space = space,
                      .lobes = &lobes,
                      .many = true};
    e.sources = from_sources(walk, &lit);
    from_windows(walk, &lit, &e);
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
