/* path_ray.c - rays of the tracer: what they meet, and what glass, frames, surfaces and
 * the environment do to them. */
#include "simulate/tracer/path_ray.h"

#include <math.h>
#include <stddef.h>

#include "model/results/reading.h"

/* ---- openings ---- */

/* The shares of light that an opening reflects and transmits. */
struct opening_optics {
    double mirror;  /* of the glass */
    double scatter; /* of the frame, and of a diffusing pane */
    double through;
};

double pp_path_ray_transmittance(const struct pp_opening *opening, double cos_incidence)
{
    return pp_glass_transmittance(&opening->glass, cos_incidence)
           * opening->frame_factor * opening->maintenance * opening->curtains;
}

static struct opening_optics optics_of(const struct pp_opening *opening,
                                       const struct pp_facet *facet,
                                       enum pp_facet_side side, double cos_incidence)
{
    double frame = (1.0 - opening->frame_factor) * facet->reflectance[side];
    double glass =
        opening->frame_factor * pp_glass_reflectance(&opening->glass, cos_incidence);
    double through = pp_path_ray_transmittance(opening, cos_incidence);
    if (opening->glass.diffusing)
        return (struct opening_optics){0.0, frame + glass, through};
    return (struct opening_optics){glass, frame, through};
}

/* One of the three events, with probabilities in proportion to their shares, whose sum
 * must not be 0. */
static enum pp_opening_event choose(const struct opening_optics *optics, double u)
{
    double left = u * (optics->mirror + optics->scatter + optics->through);
    if (left < optics->mirror)
        return PP_OPENING_MIRRORS;
    if (left < optics->mirror + optics->scatter || !(optics->through > 0.0))
        return optics->scatter > 0.0 ? PP_OPENING_SCATTERS : PP_OPENING_MIRRORS;
    return PP_OPENING_TRANSMITS;
}

bool pp_path_ray_pass_opening(const struct pp_ray_scene *scene, struct pp_path_ray *ray,
                              const struct pp_contact *met, bool count_through,
                              const double u[3], enum pp_opening_event *event)
{
    const struct pp_facet *facet = &scene->facets[met->facet];
    const struct pp_opening *opening = scene->panes[facet->opening].opening;
    double cosine = pp_vec_dot(facet->normal, ray->to);
    struct opening_optics optics = optics_of(opening, facet, met->side, fabs(cosine));
    if (!count_through)
        optics.through = 0.0;
    double sum = optics.mirror + optics.scatter + optics.through;
    if (!(sum > 0.0))
        return false;

    *event = choose(&optics, u[2]);
    enum pp_facet_side leaves = met->side;
    if (*event == PP_OPENING_TRANSMITS) {
        leaves = met->side == PP_FRONT ? PP_BACK : PP_FRONT;
        ray->inside = !ray->inside;
    }
    if (*event == PP_OPENING_MIRRORS)
        ray->to = pp_vec_along(ray->to, -2.0 * cosine, facet->normal);
    else if (*event == PP_OPENING_SCATTERS || opening->glass.diffusing)
        ray->to = pp_path_ray_lobe(facet, leaves, u[0], u[1]);
    ray->from = met->point;
    ray->normal = pp_path_ray_side_normal(facet, leaves);
    ray->throughput *= sum;
    return true;
}

/* ---- outside ---- */

void pp_path_ray_leave_surface(const struct pp_facet *facet, struct pp_path_ray *ray,
                               const struct pp_contact *met, struct pp_light *light)
{
    light->part[ray->component] += ray->throughput * facet->exitance;
    ray->throughput *= facet->reflectance[met->side];
    ray->from = met->point;
    ray->normal = pp_path_ray_side_normal(facet, met->side);
}

/* Russian roulette goes by the share that is left of the throughput, not by the
 * throughput itself: far from a window that is small from the start, and a façade
 * opposite would be seen by one path in hundreds, as bright as hundreds. */
void pp_path_ray_follow(struct pp_path_state *state, struct pp_path_ray ray, int vertex,
                        struct pp_light *light)
{
    const struct pp_ray_scene *scene = state->scene;
    double least = PP_PATH_RAY_LEAST_SHARE * ray.throughput;
    for (int last = vertex + PP_PATH_RAY_MOST_BOUNCES; vertex < last; vertex++) {
        struct pp_contact met = pp_path_ray_first(state, ray.from, ray.normal, ray.to);
        if (!ray.inside && pp_path_ray_add_near_skyline(scene, &ray, &met, light))
            return;
        if (pp_path_ray_is_leak(scene, &ray, &met)) {
            state->leaks++;
            return;
        }
        if (met.facet < 0) {
            pp_path_ray_add_sky(scene, &ray, light);
            return;
        }
        double u[4]; /* direction (2), event, Russian roulette */
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 4, u);
        const struct pp_facet *facet = &scene->facets[met.facet];
        int seen = ray.inside ? PP_IRC : PP_ERC;
        enum pp_opening_event event = PP_OPENING_SCATTERS;
        if (facet->opening >= 0) {
            if (!pp_path_ray_pass_opening(scene, &ray, &met, true, u, &event))
                return;
        }
        if (event != PP_OPENING_TRANSMITS && ray.component == PP_PATH_RAY_UNSORTED)
            ray.component = seen;
        if (facet->opening < 0) {
            pp_path_ray_leave_surface(facet, &ray, &met, light);
            ray.to = pp_path_ray_lobe(facet, met.side, u[0], u[1]);
        }
        if (!pp_path_ray_survives(&ray, ray.throughput / least, u[3]))
            return;
    }
}
