/* year_path.c - the loop of path_trace.c, which here reports events instead of
 * light. */
#include "simulate/year/year_path.h"

#include <stddef.h>

#include "simulate/sampling/lobe.h"
#include "simulate/scene/light_scene_parts.h"

/* As in path_trace.c. */
static const double LEAST = 0.3;
enum { MOST_BOUNCES = 1 << 14 };

/* State of one path. */
struct year_path {
    struct pp_path_walk *walk;
    const struct pp_year_sink *sink;
    struct pp_light_ray ray;
    double weight; /* weight of the radiance along the ray */
    int opening;
    bool counted, aims;
    bool scattered; /* by anything except clear glass */
    bool is_first;  /* at the receiver itself, which aims at openings */
};

/* Like pp_path_walk_meet, but with the short cut for convex rooms, which saves time. */
static enum pp_meeting meet_next(struct year_path *path, struct pp_light_hit *hit)
{
    struct pp_path_walk *walk = path->walk;
    enum pp_meeting meeting = pp_light_scene_meet(walk->scene, &path->ray, hit);
    walk->rays++;
    walk->leaks += meeting == PP_MEETS_LEAK;
    if (meeting == PP_MEETS_PART || meeting == PP_MEETS_GROUND)
        hit->point = pp_rays_draw_back(hit->point, path->ray.to);
    return meeting;
}

static struct pp_year_event event_of(const struct year_path *path, double weight)
{
    return (struct pp_year_event){
        .weight = weight, .opening = path->opening, .straight = !path->scattered};
}

/* Reports the event of a path that leaves the scene. */
static void end_outside(const struct year_path *path)
{
    struct pp_path_walk *walk = path->walk;
    struct pp_year_event event = event_of(path, path->weight);
    struct pp_vec3 u = path->ray.to;
    if (!(u.z > 0.0)) {
        event.weight *= pp_outside_light_ground(&walk->environment->light) / PP_PI;
        path->sink->horizontal(path->sink->data, &event);
        return;
    }
    event.u = u;
    event.far = pp_scene_skylines_far(&walk->scene->skylines, u);
    if (event.far >= 0)
        path->sink->skyline(path->sink->data, &event);
    else
        path->sink->sky(path->sink->data, &event);
}

static void add_exitance(const struct year_path *path, const struct pp_light_hit *hit)
{
    const struct pp_light_scene *scene = path->walk->scene;
    const struct pp_material *material = &scene->materials[hit->material];
    if (material->emits == PP_EMITS_NOTHING
        || (hit->back && !scene->parts[hit->part].back_emits))
        return;
    struct pp_year_event event = event_of(path, path->weight * material->radiance.g);
    path->sink->horizontal(path->sink->data, &event);
}

static void follow(struct year_path *path);

/* Reports the sunlight that a scattering pane, hit from inside, sends along the
 * path. */
static void add_pane_sun(const struct year_path *path, const struct pp_lobes *lobes,
                         const struct pp_light_hit *hit)
{
    const struct pp_light_scene *scene = path->walk->scene;
    const struct pp_pane_scatter *scatter = lobes->scatter;
    if (!scatter || hit->back || !path->sink->pane_sun
        || pp_rgb_is_black(lobes->share[PP_LOBE_THROUGH_GLOSS]))
        return;
    int window = scene->parts[hit->part].window;
    const struct pp_opening *opening = &scene->world->openings[window];
    const struct pp_material *material = &scene->materials[hit->material];
    struct pp_vec3 out = pp_vec(pp_vec_dot(lobes->eye, opening->along),
                                pp_vec_dot(lobes->eye, opening->up),
                                pp_vec_dot(lobes->eye, lobes->frame.z));
    struct pp_year_event event =
        event_of(path, path->weight * material->clear_share * material->dirt);
    event.opening = window;
    event.leaving = scatter->class_of(scatter->data, out);
    event.at = (struct pp_lit_point){hit->point, pp_vec_scale(lobes->frame.z, -1.0),
                                     pp_light_scene_parts_space(scene, hit, true)};
    path->sink->pane_sun(path->sink->data, &event);
}

/* Chooses an opening and a direction to it, from one side of a surface; `weight` is the
 * weight of the irradiance there. Sets the path, and the lobes through the pane that it
 * has hit. False if it does not hit the chosen opening. */
static bool aim_at_pane(struct year_path *path, const struct pp_lit_point *at,
                        double weight, struct pp_light_hit *hit, struct pp_lobes *lobes)
{
    struct pp_path_walk *walk = path->walk;
    const struct pp_light_scene *scene = walk->scene;
    if (scene->pane_count == 0 || at->space == PP_OUTDOORS)
        return false;
    const struct pp_openings_viewer viewer = {&walk->environment->brightness, at->point,
                                              at->normal, false};
    double u[3], probability;
    pp_path_walk_draw(walk, 3, u);
    int opening = pp_openings_choose(scene, &viewer, &walk->shares, u[2], &probability);
    if (opening < 0)
        return false;
    struct pp_polygon_sampler sampler;
    pp_sample_polygon_init(&sampler, &scene->panes[opening].target, at->point,
                           at->normal, viewer.brightness);
    struct pp_direction_sample to = pp_sample_polygon_draw(&sampler, u[0], u[1]);
    path->ray = (struct pp_light_ray){at->point, at->normal, to.direction, at->space};
    double cosine = pp_vec_dot(at->normal, to.direction);
    if (!(cosine > 0.0) || meet_next(path, hit) != PP_MEETS_PART
        || hit->part != scene->panes[opening].part)
        return false;
    *lobes = pp_path_walk_lobes(walk, hit, pp_vec_scale(to.direction, -1.0));
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        if (!pp_scatter_goes_through((enum pp_lobe)i))
            lobes->share[i] = pp_rgb_grey(0.0);
    path->weight = weight * cosine * to.per_density / probability;
    path->opening = scene->parts[hit->part].window;
    return true;
}

/* Next-event estimation of openings from one side of a surface. */
static void aim(const struct year_path *from, const struct pp_lit_point *at,
                double weight)
{
    struct pp_path_walk *walk = from->walk;
    struct year_path path = *from;
    struct pp_light_hit hit;
    struct pp_lobes lobes;
    if (!aim_at_pane(&path, at, weight, &hit, &lobes))
        return;

    /* The path goes out through the pane. A pane that scatters is lit by the sun
     * outside. */
    if (path.sink->pane) {
        struct pp_year_event event = event_of(&path, path.weight);
        path.sink->pane(path.sink->data, &event);
    }
    if (!(path.is_first && path.sink->pane_sun_apart))
        add_pane_sun(&path, &lobes, &hit);
    path.is_first = false;
    double diffuse = lobes.share[PP_LOBE_THROUGH_DIFFUSE].g;
    if (diffuse > 0.0) {
        struct pp_year_event event = event_of(&path, path.weight * diffuse / PP_PI);
        event.at =
            (struct pp_lit_point){hit.point, pp_vec_scale(lobes.frame.z, -1.0),
                                  pp_light_scene_parts_space(walk->scene, &hit, true)};
        event.hit = &hit;
        path.sink->lit(path.sink->data, &event);
    }
    struct pp_rgb beta = pp_rgb_grey(1.0);
    enum pp_lobe lobe = pp_path_walk_scatter(walk, &lobes, &hit, &path.ray, &beta);
    if (lobe == PP_LOBE_COUNT)
        return;
    path.weight *= beta.g;
    path.scattered |= lobe != PP_LOBE_STRAIGHT;
    path.counted = path.aims = false;
    follow(&path);
}

/* Adds the light of sun and openings that the diffuse lobes of a surface scatter, on
 * either side. */
static void add_diffuse(struct year_path *path, const struct pp_lobes *lobes,
                        const struct pp_light_hit *hit)
{
    for (int side = 0; side < 2; side++) {
        double albedo =
            lobes->share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE].g;
        if (!(albedo > 0.0))
            continue;
        struct pp_year_event event = event_of(path, path->weight * albedo / PP_PI);
        event.at = (struct pp_lit_point){
            hit->point, side ? pp_vec_scale(lobes->frame.z, -1.0) : lobes->frame.z,
            hit->part >= 0 ? pp_light_scene_parts_space(path->walk->scene, hit, side)
                           : hit->space};
        event.hit = hit;
        path->sink->lit(path->sink->data, &event);
        struct year_path through = *path;
        through.scattered = true;
        if (path->aims)
            aim(&through, &event.at, event.weight);
    }
}

/* True if the surface is diffuse and the sink knows its irradiance. The path then
 * ends. */
static bool ends_known(struct year_path *path, const struct pp_lobes *lobes,
                       const struct pp_light_hit *hit)
{
    const struct pp_light_scene *scene = path->walk->scene;
    if (!path->sink->known || hit->part < 0 || !scene->parts[hit->part].matt[hit->back]
        || hit->space != PP_INDOORS)
        return false;
    struct pp_year_event event =
        event_of(path, path->weight * lobes->share[PP_LOBE_DIFFUSE].g / PP_PI);
    event.hit = hit;
    return path->sink->known(path->sink->data, &event);
}

static void follow(struct year_path *path)
{
    struct pp_path_walk *walk = path->walk;
    double beta = 1.0; /* throughput, for Russian roulette */
    for (int bounce = 0; bounce < MOST_BOUNCES; bounce++) {
        /* 1. The first surface that the ray meets, if any. */
        struct pp_light_hit hit;
        enum pp_meeting meeting = meet_next(path, &hit);
        if (meeting == PP_MEETS_LEAK)
            return;
        if (meeting == PP_MEETS_ENVIRONMENT) {
            end_outside(path);
            return;
        }
        if (meeting == PP_MEETS_PART)
            add_exitance(path, &hit);

        /* 2. The lobes of its BSDF. Light that enters through an opening was already
         * counted where the ray began. */
        struct pp_vec3 wo = pp_vec_scale(path->ray.to, -1.0);
        struct pp_lobes lobes = pp_path_walk_lobes(walk, &hit, wo);
        int window =
            meeting == PP_MEETS_PART ? walk->scene->parts[hit.part].window : -1;
        if (window >= 0 && !hit.back && path->counted)
            lobes.share[PP_LOBE_STRAIGHT] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
                lobes.share[PP_LOBE_THROUGH_GLOSS] = pp_rgb_grey(0.0);
        if (ends_known(path, &lobes, &hit))
            return;

        /* 3. Light on the surface from sun and openings. */
        if (window >= 0 && !hit.back)
            path->opening = window;
        if (window >= 0)
            add_pane_sun(path, &lobes, &hit);
        add_diffuse(path, &lobes, &hit);

        /* 4. Sample a direction wi from one of the lobes. */
        enum pp_space before = path->ray.space;
        struct pp_rgb factor = pp_rgb_grey(1.0);
        enum pp_lobe lobe =
            pp_path_walk_scatter(walk, &lobes, &hit, &path->ray, &factor);
        if (lobe == PP_LOBE_COUNT)
            return;
        path->weight *= factor.g;
        beta *= factor.g;
        path->scattered |= lobe != PP_LOBE_STRAIGHT;
        if (lobe != PP_LOBE_STRAIGHT)
            path->counted =
                path->aims && before != PP_OUTDOORS
                && (lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE);

        /* 5. Russian roulette: a path of low throughput continues with probability
         * q. */
        double u, q = beta / LEAST;
        pp_path_walk_draw(walk, 1, &u);
        if (u >= q)
            return;
        if (q < 1.0) {
            path->weight /= q;
            beta /= q;
        }
    }
}

void pp_year_path_openings(struct pp_path_walk *walk, const struct pp_year_sink *sink,
                           const struct pp_lit_point *at)
{
    struct year_path path = {
        .walk = walk, .sink = sink, .opening = -1, .is_first = true};
    aim(&path, at, 1.0);
}

void pp_year_path_pane_sun(struct pp_path_walk *walk, const struct pp_year_sink *sink,
                           const struct pp_lit_point *at)
{
    struct year_path path = {.walk = walk, .sink = sink, .opening = -1};
    struct pp_light_hit hit;
    struct pp_lobes lobes;
    if (aim_at_pane(&path, at, 1.0, &hit, &lobes))
        add_pane_sun(&path, &lobes, &hit);
}

void pp_year_path_lobe(struct pp_path_walk *walk, const struct pp_year_sink *sink,
                       const struct pp_lit_point *at)
{
    double u[2];
    struct pp_vec3 a, b;
    pp_path_walk_draw(walk, 2, u);
    pp_lobe_frame(at->normal, &a, &b);
    bool indoors = at->space != PP_OUTDOORS;
    struct year_path path = {
        .walk = walk,
        .sink = sink,
        .ray = {at->point, at->normal,
                pp_lobe_sample_in_frame(a, b, at->normal, u[0], u[1]), at->space},
        .weight = PP_PI,
        .opening = -1,
        .counted = indoors,
        .aims = indoors};
    follow(&path);
}
