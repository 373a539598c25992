/* light_windows.c - direct light of windows: directions to the panes, and the light
 * outside in those directions. */
#include "simulate/transport/light_windows.h"

#include <math.h>

#include "simulate/sampling/lobe.h"
#include "simulate/transport/window_store.h"

static double angular_size(const struct pp_light_scene *scene, int window,
                           struct pp_vec3 from)
{
    const struct pp_target *target = &scene->room->panes[window].target;
    struct pp_vec3 to = pp_vec_sub(target->middle, from);
    return sqrt(target->area_m2 / pp_vec_dot(to, to));
}

bool pp_light_windows_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int window)
{
    if (!state->options.windows || path->from_window || path->sampled_in == PP_OUTDOORS
        || path->sampled == PP_DIRECTLY_SAMPLED_NONE || path->mirror_path >= 0)
        return false;
    if (path->sampled == PP_DIRECTLY_SAMPLED_ALL)
        return true;
    return angular_size(state->scene, window, path->gloss_point) < path->gloss_size;
}

/* The light that comes to the window along the ray, which leaves it to the outside:
 * known beforehand where nothing stands there, else read from the store, else that of a
 * path. */
static struct pp_rgb light_outside(struct pp_radiance_state *state,
                                   const struct pp_shading_point *shading,
                                   const struct pp_light_ray *ray, int window,
                                   int vertex, bool *is_sky)
{
    const struct pp_light_scene *scene = state->scene;
    *is_sky = false;
    if (scene->room->panes[window].unobstructed) {
        double exitance, near = pp_environment_near_skyline(
                             &scene->room->environment, ray->from, ray->to, &exitance);
        return pp_light_scene_environment(scene, ray, near, is_sky);
    }
    struct pp_light_hit hit;
    enum pp_meeting meeting = pp_radiance_state_meet(state, ray, &hit);
    if (meeting == PP_MEETS_ENVIRONMENT)
        return pp_light_scene_environment(scene, ray, hit.distance_m, is_sky);
    struct pp_rgb radiance = pp_rgb_grey(0.0);
    if (meeting == PP_MEETS_LEAK)
        return radiance;
    if (state->options.stored && state->store
        && pp_window_table_radiance(&state->store->tables[window],
                                    &scene->room->panes[window].target, ray->from,
                                    ray->to, hit.distance_m, &radiance))
        return radiance;
    struct pp_light_path path =
        pp_path_vertex_outside(state, ray, vertex, shading->depth);
    return shading->follow_outside(state, &path, meeting, &hit);
}

/* Up to this many windows are all sampled. One of them at random was most of a path's
 * noise: all of them have a quarter less in the
 * example studio. */
enum { FEW_WINDOWS = 4 };

/* The light that a diffusing pane gives off to the room at a point, by one direction
 * from outside. */
static struct pp_rgb light_of_pane(struct pp_radiance_state *state,
                                   const struct pp_shading_point *shading, int window,
                                   struct pp_vec3 point, int vertex,
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
                        light_outside(state, shading, &ray, window,
                                      pp_path_vertex_branch(vertex, 1), is_sky));
}

/* The radiance of the pane towards the shading point; *is_sky: it is the sky's. */
static struct pp_rgb pane_radiance(struct pp_radiance_state *state,
                                   const struct pp_shading_point *shading, int window,
                                   const struct pp_direction_sample *sample,
                                   bool *is_sky)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_light_part *part = &scene->parts[scene->room->panes[window].facet];
    const struct pp_material *material = &scene->materials[part->material[0]];
    int vertex = pp_path_vertex_branch(
        pp_path_vertex_branch(shading->vertex, PP_DRAW_PANES), window);
    if (material->kind == PP_MATERIAL_TRANSLUCENT)
        return light_of_pane(state, shading, window, sample->point, vertex,
                             material->through_diffuse, is_sky);
    struct pp_light_ray ray = {sample->point, pp_vec_scale(part->normal, -1.0),
                               sample->direction, PP_OUTDOORS};
    double cosine = -pp_vec_dot(part->normal, sample->direction);
    return pp_rgb_times(pp_scatter_regular_transmittance(material, cosine),
                        light_outside(state, shading, &ray, window, vertex, is_sky));
}

/* Light from one direction to a window; *is_sky: it is the sky's. */
static struct pp_rgb light_from(struct pp_radiance_state *state,
                                const struct pp_shading_point *shading, int window,
                                double size, const struct pp_direction_sample *sample,
                                bool *is_sky)
{
    const struct pp_pane *pane = &state->scene->room->panes[window];
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    *is_sky = false;
    double cosine = pp_vec_dot(shading->normal, sample->direction);
    if (!(cosine > 0.0))
        return none;
    struct pp_rgb f = pp_path_vertex_brdf(shading, sample->direction, size);
    bool open = pane->seen_by_all && shading->space == PP_INDOORS;
    if (pp_rgb_is_black(f)
        || (!open
            && !pp_radiance_state_unoccluded(
                state, pp_path_vertex_shadow_ray(shading, sample->direction),
                pane->facet, sample->distance_m, &through)))
        return none;
    f = pp_rgb_scale(pp_rgb_times(f, through), cosine * sample->per_density);
    return pp_rgb_times(f, pane_radiance(state, shading, window, sample, is_sky));
}

static void sample_window(struct pp_radiance_state *state,
                          const struct pp_shading_point *shading, int window,
                          int vertex, double weight, struct pp_irradiance *sum)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_target *target = &scene->room->panes[window].target;
    if (!pp_sample_polygon_in_sight(target, shading->point, shading->normal))
        return;
    struct pp_polygon_sampler sampler;
    pp_sample_polygon_init(&sampler, target, shading->point, shading->normal,
                           scene->room->brightness);
    double size = angular_size(scene, window, shading->point);
    uint32_t index = state->index;
    uint32_t count = pp_path_vertex_direction_count(state, shading, size);
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        bool is_sky;
        state->index = index * count + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 2, u);
        struct pp_direction_sample sample =
            pp_sample_polygon_draw(&sampler, u[0], u[1]);
        struct pp_rgb light =
            light_from(state, shading, window, size, &sample, &is_sky);
        struct pp_rgb *part = is_sky ? &sum->sky : &sum->outside;
        *part = pp_rgb_along(*part, weight / count, light);
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
    if (scene->room->pane_count <= FEW_WINDOWS || shading->split) {
        for (int i = 0; i < scene->room->pane_count; i++)
            sample_window(state, shading, i,
                          i == 0 ? vertex : pp_path_vertex_branch(vertex, i), 1.0, sum);
        return;
    }
    double u, probability;
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_path_vertex_branch(vertex, 0), 1, &u);
    int chosen = pp_ray_scene_choose_pane(scene->room, shading->point, shading->normal,
                                          u, &probability);
    if (chosen >= 0)
        sample_window(state, shading, chosen, vertex, 1.0 / probability, sum);
}
