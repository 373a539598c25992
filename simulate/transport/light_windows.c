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
    struct pp_vec3 to = pp_vec_sub(target->middle, from);
    return sqrt(target->area_m2 / pp_vec_dot(to, to));
}

bool pp_light_windows_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int window)
{
    if (!state->options.windows || path->by_window || path->aimed_in == PP_OUTDOORS
        || path->aimed == PP_DIRECTLY_SAMPLED_NONE || path->mirror_path >= 0)
        return false;
    if (path->aimed == PP_DIRECTLY_SAMPLED_ALL)
        return true;
    return window_spread(state->scene, window, path->from) < path->width;
}

/* ---- outside ---- */

static struct pp_light_path path_outside(const struct pp_radiance_state *state,
                                         const struct pp_light_ray *ray, int vertex,
                                         int depth)
{
    return (struct pp_light_path){.ray = *ray,
                                  .weight = pp_rgb_grey(1.0),
                                  .least = state->options.least,
                                  .aimed = PP_DIRECTLY_SAMPLED_ALL,
                                  .aimed_in = PP_OUTDOORS,
                                  .mirror_path = -1,
                                  .depth = depth,
                                  .vertex = vertex,
                                  .by_window = true};
}

bool pp_light_windows_outside_radiance(struct pp_radiance_state *state,
                                       const struct pp_light_ray *ray,
                                       struct pp_rgb *radiance, double *distance_m)
{
    struct pp_light_hit hit;
    struct pp_light_path path = path_outside(state, ray, 1, 0);
    *radiance = pp_rgb_grey(0.0);
    enum pp_meeting meeting = pp_light_path_meet(state, ray, &hit);
    *distance_m = hit.distance_m;
    if (meeting != PP_MEETS_PART)
        return false;
    if (pp_light_path_arrive(state, &path, meeting, &hit, radiance))
        *radiance = pp_rgb_add(*radiance, pp_light_path_follow(state, &path, NULL));
    return true;
}

/* The light that comes along the ray from outside to the window. */
static struct pp_rgb light_outside(struct pp_radiance_state *state,
                                   const struct pp_light_ray *ray, int window,
                                   int vertex, int depth, bool *is_sky)
{
    const struct pp_light_scene *scene = state->scene;
    *is_sky = false;
    if (scene->room->panes[window].unobstructed) {
        double exitance, near = pp_environment_near_skyline(
                             &scene->room->outside, ray->from, ray->to, &exitance);
        return pp_light_scene_environment(scene, ray, near, is_sky);
    }
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_light_path_meet(state, ray, &hit);
    if (meeting == PP_MEETS_ENVIRONMENT)
        return pp_light_scene_environment(scene, ray, hit.distance_m, is_sky);
    struct pp_rgb radiance = pp_rgb_grey(0.0);
    if (meeting == PP_MEETS_LEAK)
        return radiance;
    if (state->options.stored && state->store
        && pp_window_store_radiance(state->store, scene, window, ray->from, ray->to,
                                    hit.distance_m, &radiance))
        return radiance;
    struct pp_light_path path = path_outside(state, ray, vertex, depth);
    if (pp_light_path_arrive(state, &path, meeting, &hit, &radiance))
        radiance = pp_rgb_add(radiance, pp_light_path_follow(state, &path, NULL));
    return radiance;
}

/* ---- in the room ---- */

/* Up to so many windows are all aimed at: choosing among them would be the most of a
 * path's noise. */
enum { FEW_WINDOWS = 4 };

/* What a diffusing pane gives off to the room, of what falls on it at the point. */
static struct pp_rgb light_of_pane(struct pp_radiance_state *state, int window,
                                   struct pp_vec3 point, int vertex, int depth,
                                   struct pp_rgb transmittance, bool *is_sky)
{
    const struct pp_facet *facet =
        &state->scene->room->facets[state->scene->room->panes[window].facet];
    struct pp_vec3 out = pp_vec_scale(facet->normal, -1.0);
    double u[2];
    pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 2, u);
    struct pp_light_ray ray = {
        point, out, pp_lobe_sample_in_frame(facet->a, facet->b, out, u[0], u[1]),
        PP_OUTDOORS};
    return pp_rgb_times(transmittance,
                        light_outside(state, &ray, window,
                                      pp_light_path_branch_vertex(vertex, 1), depth,
                                      is_sky));
}

/* Light from one direction to a window; what of it is sky goes to *sky. */
static struct pp_rgb from_window(struct pp_radiance_state *state,
                                 const struct pp_shading_point *shading, int window,
                                 double spread, const struct pp_direction_sample *aimed,
                                 struct pp_rgb *sky)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_pane *pane = &scene->room->panes[window];
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    *sky = none;
    double facing = pp_vec_dot(shading->normal, aimed->direction);
    if (!(facing > 0.0))
        return none;
    struct pp_rgb f = pp_light_sources_brdf(shading, aimed->direction, spread);
    bool open = pane->seen_by_all && shading->space == PP_INDOORS;
    if (pp_rgb_is_black(f)
        || (!open
            && !pp_light_sources_unoccluded(
                state, pp_light_path_shadow_ray(shading, aimed->direction), pane->facet,
                aimed->distance_m, &through)))
        return none;
    f = pp_rgb_scale(pp_rgb_times(f, through), facing * aimed->per_density);

    const struct pp_light_part *part = &scene->parts[pane->facet];
    const struct pp_material *material = &scene->materials[part->material[0]];
    int outside_vertex = pp_light_path_branch_vertex(
        pp_light_path_branch_vertex(shading->vertex, PP_DRAW_PANES), window);
    bool is_sky;
    struct pp_rgb light;
    if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        light = light_of_pane(state, window, aimed->point, outside_vertex,
                              shading->depth, material->through_diffuse, &is_sky);
    } else {
        struct pp_light_ray ray = {aimed->point, pp_vec_scale(part->normal, -1.0),
                                   aimed->direction, PP_OUTDOORS};
        double cosine = -pp_vec_dot(part->normal, aimed->direction);
        light = pp_rgb_times(pp_scatter_regular_transmittance(material, cosine),
                             light_outside(state, &ray, window, outside_vertex,
                                           shading->depth, &is_sky));
    }
    light = pp_rgb_times(f, light);
    if (is_sky)
        *sky = light;
    return is_sky ? none : light;
}

static void light_of_window(struct pp_radiance_state *state,
                            const struct pp_shading_point *shading, int window,
                            int vertex, double weight, struct pp_irradiance *sum)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_target *target = &scene->room->panes[window].target;
    if (!pp_sample_polygon_in_sight(target, shading->point, shading->normal))
        return;
    struct pp_polygon_sampler aim;
    pp_sample_polygon_init(&aim, target, shading->point, shading->normal,
                           scene->room->brightness);
    double spread = window_spread(scene, window, shading->point);
    uint32_t index = state->index;
    uint32_t count = shading->many ? pp_emitters_direction_count(
                         spread, state->options.source_size, state->options.source_most)
                                   : 1;
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        struct pp_rgb sky;
        state->index = index * count + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 2, u);
        struct pp_direction_sample aimed = pp_sample_polygon_draw(&aim, u[0], u[1]);
        struct pp_rgb light = from_window(state, shading, window, spread, &aimed, &sky);
        sum->outside = pp_rgb_along(sum->outside, weight / count, light);
        sum->sky = pp_rgb_along(sum->sky, weight / count, sky);
    }
    state->index = index;
}

void pp_light_windows_next_event(struct pp_radiance_state *state,
                                 const struct pp_shading_point *shading,
                                 struct pp_irradiance *sum)
{
    const struct pp_light_scene *scene = state->scene;
    if (!state->options.windows || !scene->room || scene->room->pane_count == 0
        || shading->space == PP_OUTDOORS)
        return;
    int vertex = shading->vertex * PP_DRAWS + PP_DRAW_WINDOWS;
    if (scene->room->pane_count <= FEW_WINDOWS || shading->many) {
        for (int i = 0; i < scene->room->pane_count; i++)
            light_of_window(state, shading, i,
                            i == 0 ? vertex : pp_light_path_branch_vertex(vertex, i),
                            1.0, sum);
        return;
    }
    double u, probability;
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_light_path_branch_vertex(vertex, 0), 1, &u);
    int chosen = pp_ray_scene_choose_pane(scene->room, shading->point, shading->normal,
                                          u, &probability);
    if (chosen >= 0)
        light_of_window(state, shading, chosen, vertex, 1.0 / probability, sum);
}
