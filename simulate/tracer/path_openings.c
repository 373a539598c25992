/* path_openings.c - a direction to an opening, and the light that comes in by it. */
#include "simulate/tracer/path_openings.h"

#include <math.h>

#include "model/results/reading.h"

/* The ray that leaves by the opening in the sampled direction, its throughput
 * multiplied by cosine over density and transmittance; false where no light comes in
 * that way, or a surface stands before the opening. */
static bool leave_by(struct pp_path_state *state, const struct pp_pane *pane,
                     const struct pp_direction_sample *sample, struct pp_vec3 n,
                     int vertex, struct pp_path_ray *ray)
{
    const struct pp_ray_scene *scene = state->scene;
    double facing = pp_vec_dot(n, sample->direction);
    if (!(facing > 0.0))
        return false;
    if (!pane->seen_by_all || state->every_ray) {
        struct pp_contact met =
            pp_path_ray_first(state, ray->from, n, sample->direction);
        if (met.facet != pane->facet && !pane->seen_by_all)
            return false;
    }
    const struct pp_facet *facet = &scene->facets[pane->facet];
    double cosine = -pp_vec_dot(facet->normal, sample->direction);
    ray->throughput *= facing * sample->per_density / PP_PI
                       * pp_path_ray_transmittance(pane->opening, cosine);
    ray->from = sample->point;
    ray->normal = pp_path_ray_side_normal(facet, PP_BACK);
    ray->to = sample->direction;
    if (pane->opening->glass.diffusing) {
        double u[2];
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 2, u);
        ray->to = pp_path_ray_lobe(facet, PP_BACK, u[0], u[1]);
    }
    return ray->throughput > 0.0;
}

/* Was the sampler made for this target, point and normal? */
static bool is_made_for(const struct pp_polygon_sampler *sampler,
                        const struct pp_target *target, struct pp_vec3 p,
                        struct pp_vec3 n)
{
    return sampler->target == target && sampler->from.x == p.x && sampler->from.y == p.y
           && sampler->from.z == p.z && sampler->facing.x == n.x
           && sampler->facing.y == n.y && sampler->facing.z == n.z;
}

void pp_path_openings(struct pp_path_state *state, struct pp_vec3 p, struct pp_vec3 n,
                      const double u[3], int vertex, double throughput, int component,
                      struct pp_light *light)
{
    const struct pp_ray_scene *scene = state->scene;
    double probability;
    int chosen = pp_ray_scene_choose_pane(scene, p, n, u[2], &probability);
    if (chosen < 0)
        return;
    const struct pp_pane *pane = &scene->panes[chosen];
    if (!is_made_for(&state->sampler, &pane->target, p, n))
        pp_sample_polygon_init(&state->sampler, &pane->target, p, n, scene->brightness);
    struct pp_direction_sample sample =
        pp_sample_polygon_draw(&state->sampler, u[0], u[1]);

    int outside_vertex = PP_PATH_RAY_OUTSIDE_STEP * (vertex + 1);
    struct pp_path_ray ray = {.from = p,
                              .throughput = throughput / probability,
                              .inside = false,
                              .component = component};
    if (!leave_by(state, pane, &sample, n, outside_vertex, &ray))
        return;
    if (!pane->unobstructed) {
        pp_path_ray_follow(state, ray, outside_vertex + 1, light);
        return;
    }
    struct pp_contact nothing = {.facet = -1};
    if (state->every_ray)
        pp_path_ray_first(state, ray.from, ray.normal, ray.to);
    if (!pp_path_ray_add_near_skyline(scene, &ray, &nothing, light))
        pp_path_ray_add_sky(scene, &ray, light);
}
