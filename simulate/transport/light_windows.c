/* light_windows.c - light through a room's openings, which are aimed at as lamps are.
 * See light_path.h. */
#include <math.h>

#include "simulate/transport/light_path.h"
#include "simulate/sampling/lobe.h"
#include "simulate/transport/window_store.h"

static double window_spread(const struct pp_light_scene *scene, int window,
                            struct pp_vec3 from)
{
    const struct pp_target *target = &scene->room->panes[window].target;
    struct pp_vec3 to = pp_sub(target->middle, from);
    return sqrt(target->area_m2 / pp_dot(to, to));
}

bool pp_window_counted(const struct pp_radiance_walk *walk,
                       const struct pp_light_path *path, int window)
{
    if (!walk->options.windows || path->by_window || path->aimed_in == PP_OUTDOORS
        || path->aimed == PP_AIMED_AT_NOTHING || path->chain >= 0)
        return false;
    if (path->aimed == PP_AIMED_AT_ALL)
        return true;
    return window_spread(walk->scene, window, path->from) < path->width;
}

/* ---- outside ---- */

static struct pp_light_path path_outside(const struct pp_radiance_walk *walk,
                                         const struct pp_light_ray *ray, int vertex,
                                         int depth)
{
    return (struct pp_light_path){.ray = *ray,
                                  .weight = pp_rgb_grey(1.0),
                                  .least = walk->options.least,
                                  .aimed = PP_AIMED_AT_ALL,
                                  .aimed_in = PP_OUTDOORS,
                                  .chain = -1,
                                  .depth = depth,
                                  .vertex = vertex,
                                  .by_window = true};
}

bool pp_radiance_of_outside(struct pp_radiance_walk *walk,
                            const struct pp_light_ray *ray, struct pp_rgb *radiance,
                            double *distance_m)
{
    struct pp_light_hit hit;
    struct pp_light_path path = path_outside(walk, ray, 1, 0);
    *radiance = pp_rgb_grey(0.0);
    enum pp_meeting meeting = pp_light_path_meet(walk, ray, &hit);
    *distance_m = hit.distance_m;
    if (meeting != PP_MEETS_PART)
        return false;
    if (pp_light_path_arrive(walk, &path, meeting, &hit, radiance))
        *radiance = pp_rgb_add(*radiance, pp_light_path_follow(walk, &path, NULL));
    return true;
}

/* The light that comes along the ray from outside to the window. */
static struct pp_rgb light_outside(struct pp_radiance_walk *walk,
                                   const struct pp_light_ray *ray, int window,
                                   int vertex, int depth, bool *is_sky)
{
    const struct pp_light_scene *scene = walk->scene;
    *is_sky = false;
    if (scene->room->panes[window].nothing_beyond) {
        double exitance, near = pp_outside_near(&scene->room->outside, ray->from,
                                                ray->to, &exitance);
        return pp_light_scene_beyond(scene, ray, near, is_sky);
    }
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_light_path_meet(walk, ray, &hit);
    if (meeting == PP_MEETS_BEYOND)
        return pp_light_scene_beyond(scene, ray, hit.distance_m, is_sky);
    struct pp_rgb radiance = pp_rgb_grey(0.0);
    if (meeting == PP_MEETS_CRACK)
        return radiance;
    if (walk->options.stored && walk->store
        && pp_window_store_radiance(walk->store, scene, window, ray->from, ray->to,
                                    hit.distance_m, &radiance))
        return radiance;
    struct pp_light_path path = path_outside(walk, ray, vertex, depth);
    if (pp_light_path_arrive(walk, &path, meeting, &hit, &radiance))
        radiance = pp_rgb_add(radiance, pp_light_path_follow(walk, &path, NULL));
    return radiance;
}

/* ---- in the room ---- */

/* Up to so many windows are all aimed at: choosing among them would be the most of a
 * path's noise. */
enum { FEW_WINDOWS = 4 };

/* What a diffusing pane gives off to the room, of what falls on it at the point. */
static struct pp_rgb light_of_pane(struct pp_radiance_walk *walk, int window,
                                   struct pp_vec3 point, int vertex, int depth,
                                   struct pp_rgb transmittance, bool *is_sky)
{
    const struct pp_facet *facet =
        &walk->scene->room->facets[walk->scene->room->panes[window].facet];
    struct pp_vec3 out = pp_scale(facet->normal, -1.0);
    double u[2];
    pp_sequence_draw(&walk->sequence, walk->index, vertex, 2, u);
    struct pp_light_ray ray = {
        point, out, pp_sample_lobe(facet->a, facet->b, out, u[0], u[1]), PP_OUTDOORS};
    return pp_rgb_times(
        transmittance,
        light_outside(walk, &ray, window, pp_branch_off(vertex, 1), depth, is_sky));
}

/* Light from one direction to a window; what of it is sky goes to *sky. */
static struct pp_rgb from_window(struct pp_radiance_walk *walk,
                                 const struct pp_lit *lit, int window, double spread,
                                 const struct pp_aimed *aimed, struct pp_rgb *sky)
{
    const struct pp_light_scene *scene = walk->scene;
    const struct pp_pane *pane = &scene->room->panes[window];
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    *sky = none;
    double facing = pp_dot(lit->normal, aimed->direction);
    if (!(facing > 0.0))
        return none;
    struct pp_rgb f = pp_lit_sends_on(lit, aimed->direction, spread);
    bool open = pane->seen_by_all && lit->space == PP_INDOORS;
    if (pp_rgb_is_black(f)
        || (!open
            && !pp_lit_reach(walk, pp_lit_ray(lit, aimed->direction), pane->facet,
                             aimed->distance_m, &through)))
        return none;
    f = pp_rgb_scale(pp_rgb_times(f, through), facing * aimed->per_density);

    const struct pp_light_part *part = &scene->parts[pane->facet];
    const struct pp_material *material = &scene->materials[part->material[0]];
    int beyond = pp_branch_off(pp_branch_off(lit->vertex, PP_DRAW_PANES), window);
    bool is_sky;
    struct pp_rgb light;
    if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        light = light_of_pane(walk, window, aimed->point, beyond, lit->depth,
                              material->through_diffuse, &is_sky);
    } else {
        struct pp_light_ray ray = {aimed->point, pp_scale(part->normal, -1.0),
                                   aimed->direction, PP_OUTDOORS};
        double cosine = -pp_dot(part->normal, aimed->direction);
        light = pp_rgb_times(
            pp_straight_through(material, cosine),
            light_outside(walk, &ray, window, beyond, lit->depth, &is_sky));
    }
    light = pp_rgb_times(f, light);
    if (is_sky)
        *sky = light;
    return is_sky ? none : light;
}

static void light_of_window(struct pp_radiance_walk *walk, const struct pp_lit *lit,
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

void pp_light_from_windows(struct pp_radiance_walk *walk, const struct pp_lit *lit,
                           struct pp_irradiance *sum)
{
    const struct pp_light_scene *scene = walk->scene;
    if (!walk->options.windows || !scene->room || scene->room->pane_count == 0
        || lit->space == PP_OUTDOORS)
        return;
    int vertex = lit->vertex * PP_DRAWS + PP_DRAW_WINDOWS;
    if (scene->room->pane_count <= FEW_WINDOWS || lit->many) {
        for (int i = 0; i < scene->room->pane_count; i++)
            light_of_window(walk, lit, i, i == 0 ? vertex : pp_branch_off(vertex, i),
                            1.0, sum);
        return;
    }
    double u, probability;
    pp_sequence_draw(&walk->sequence, walk->index, pp_branch_off(vertex, 0), 1, &u);
    int chosen =
        pp_scene_choose_pane(scene->room, lit->point, lit->normal, u, &probability);
    if (chosen >= 0)
        light_of_window(walk, lit, chosen, vertex, 1.0 / probability, sum);
}
