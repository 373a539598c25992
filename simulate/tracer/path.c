/* path.c - the three estimators of path.h: direct light, gathering of the control
 * variate, and its correction. */
#include "simulate/tracer/path.h"

#include <math.h>
#include <stddef.h>

#include "model/results/reading.h"
#include "simulate/tracer/path_openings.h"

enum {
    /* Directions from each surface met, where the control variate leaves a small
     * difference of two large numbers. Measured in two rooms: half and twice as many
     * lose 10 to 40 % of the efficiency, one of each two thirds. */
    OPENINGS = 4,
    LOBES = 8
};

/* Chance of a path to go on, for each unit of throughput, where the control variate
 * stands for the light that it would bring. Measured: any value between 0.5 and 1 is as
 * good. */
static const double GOING_ON = 0.7;

/* The point, and the random numbers that the path begins with: direction (2) and
 * choice. */
static struct pp_vec3 begin(const struct pp_path_state *state,
                            const struct pp_start *start, double u[3])
{
    double draw[5];
    pp_sobol_sequence_draw(&state->sequence, state->index, 0, start->anywhere ? 5 : 3,
                           draw);
    u[0] = draw[0];
    u[1] = draw[1];
    u[2] = draw[2];
    if (!start->anywhere)
        return start->position;
    u[2] = draw[4];
    return pp_ray_scene_plane_point(state->scene, draw[2], draw[3]);
}

static struct pp_path_ray lobe_ray(struct pp_vec3 p, struct pp_vec3 n,
                                   const double u[2], bool inside)
{
    struct pp_vec3 a, b;
    pp_lobe_frame(n, &a, &b);
    return (struct pp_path_ray){.from = p,
                                .normal = n,
                                .to = pp_lobe_sample_in_frame(a, b, n, u[0], u[1]),
                                .throughput = 1.0,
                                .inside = inside,
                                .component = inside ? PP_IRC : PP_PATH_RAY_UNSORTED};
}

void pp_path_direct(struct pp_path_state *state, const struct pp_start *start,
                    struct pp_light *light)
{
    double u[3];
    struct pp_vec3 p = begin(state, start, u);
    if (state->scene->has_room)
        pp_path_openings(state, p, start->normal, u, 0, 1.0, PP_PATH_RAY_UNSORTED,
                         light);
    else
        pp_path_ray_follow(state, lobe_ray(p, start->normal, u, false), 1, light);
}

double pp_path_gather(struct pp_path_state *state, const struct pp_start *start)
{
    double u[3];
    struct pp_vec3 p = begin(state, start, u);
    if (!state->radiosity)
        return 0.0;
    struct pp_path_ray ray = lobe_ray(p, start->normal, u, true);
    struct pp_contact met = pp_path_ray_first(state, ray.from, ray.normal, ray.to);
    return pp_radiosity_at(state->radiosity, state->scene, &met);
}

/* Follows a ray in the room until it meets a surface, past glass and frames; false if
 * the path ends before. Light that comes in on the way is added. */
static bool to_surface(struct pp_path_state *state, struct pp_path_ray *ray, int vertex,
                       struct pp_contact *met, bool *at_once, struct pp_light *light)
{
    const struct pp_ray_scene *scene = state->scene;
    double least = PP_PATH_RAY_LEAST_SHARE * ray->throughput;
    bool count_through = false;
    *at_once = true;
    for (;; vertex++) {
        *met = pp_path_ray_first(state, ray->from, ray->normal, ray->to);
        if (pp_path_ray_is_leak(scene, ray, met)) {
            state->leaks++;
            return false;
        }
        if (scene->facets[met->facet].opening < 0)
            return true;
        *at_once = false;
        double u[6]; /* direction (2), event, place in an opening (2), choice */
        enum pp_opening_event event;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 6, u);
        if (!pp_path_ray_pass_opening(scene, ray, met, count_through, u, &event))
            return false;
        if (event == PP_OPENING_TRANSMITS) {
            pp_path_ray_follow(state, *ray, vertex + PP_PATH_RAY_OUTSIDE_STEP / 2,
                               light);
            return false;
        }
        if (event == PP_OPENING_SCATTERS)
            pp_path_openings(state, ray->from, ray->normal, &u[3], vertex,
                             ray->throughput, PP_IRC, light);
        count_through = event == PP_OPENING_MIRRORS;
        double roulette;
        pp_sobol_sequence_draw(&state->sequence, state->index,
                               vertex + PP_PATH_RAY_OUTSIDE_STEP / 4, 1, &roulette);
        if (!pp_path_ray_survives(ray, ray->throughput / least, roulette))
            return false;
    }
}

static double radiosity_at(const struct pp_path_state *state,
                           const struct pp_contact *met)
{
    return state->radiosity ? pp_radiosity_at(state->radiosity, state->scene, met)
                            : 0.0;
}

/* E + K G of a surface, over several directions; one of these goes on as *ray with the
 * whole throughput, to *met; false if that ends before. */
static bool bounce(struct pp_path_state *state, struct pp_path_ray *ray, int vertex,
                   uint32_t openings, uint32_t lobes, struct pp_contact *met,
                   struct pp_light *light)
{
    const struct pp_facet *facet = &state->scene->facets[met->facet];
    struct pp_path_ray from = *ray;
    enum pp_facet_side side = met->side;
    uint32_t path = state->index;
    for (uint32_t i = 0; i < openings; i++) {
        double u[3];
        state->index = path * openings + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 3, u);
        pp_path_openings(state, from.from, from.normal, u, vertex,
                         from.throughput / openings, PP_IRC, light);
    }
    bool reached = false;
    for (uint32_t i = 0; i < lobes; i++) {
        double u[2];
        state->index = path * lobes + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex + 1, 2, u);
        struct pp_path_ray arm = from;
        struct pp_contact end;
        bool at_once;
        arm.throughput /= lobes;
        arm.to = pp_path_ray_lobe(facet, side, u[0], u[1]);
        if (!to_surface(state, &arm, PP_PATH_RAY_OUTSIDE_STEP * (vertex + 2), &end,
                        &at_once, light))
            continue;
        light->part[PP_IRC] += arm.throughput * radiosity_at(state, &end);
        if (i == 0) {
            reached = true;
            *met = end;
            *ray = arm;
            ray->throughput *= lobes;
        }
    }
    state->index = path;
    return reached;
}

/* Follows a path in the room from the start to its end. */
static void correct(struct pp_path_state *state, const struct pp_start *start,
                    struct pp_light *light)
{
    double u[3];
    struct pp_vec3 p = begin(state, start, u);
    struct pp_path_ray ray = lobe_ray(p, start->normal, u, true);
    struct pp_contact met;
    bool at_once;
    if (!to_surface(state, &ray, PP_PATH_RAY_OUTSIDE_STEP, &met, &at_once, light))
        return;
    if (!at_once) /* else the gathering has G there */
        light->part[PP_IRC] += ray.throughput * radiosity_at(state, &met);
    for (int vertex = 1; vertex < 3 * PP_PATH_RAY_MOST_BOUNCES; vertex += 3) {
        double chance = 1.0, roulette = 0.0;
        if (vertex > 1) {
            pp_sobol_sequence_draw(&state->sequence, state->index, vertex + 2, 1,
                                   &roulette);
            chance = state->radiosity ? GOING_ON * ray.throughput
                                      : ray.throughput / PP_PATH_RAY_LEAST_SHARE;
        }
        if (!pp_path_ray_survives(&ray, chance, roulette))
            return;
        const struct pp_facet *facet = &state->scene->facets[met.facet];
        light->part[PP_IRC] -= ray.throughput * radiosity_at(state, &met);
        pp_path_ray_leave_surface(facet, &ray, &met, light);
        if (!(ray.throughput > 0.0))
            return;
        bool many = state->radiosity != NULL;
        if (!bounce(state, &ray, vertex, many ? OPENINGS : 1, many ? LOBES : 1, &met,
                    light))
            return;
    }
}

double pp_path_correction(struct pp_path_state *state, const struct pp_start *start)
{
    struct pp_light light = {{0.0, 0.0, 0.0}};
    if (state->scene->has_room)
        correct(state, start, &light);
    return light.part[PP_IRC];
}
