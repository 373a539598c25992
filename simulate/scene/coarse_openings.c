/* coarse_openings.c - see coarse_openings.h. */
#include "simulate/scene/coarse_openings.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sample_discrete.h"
#include "simulate/scene/openings.h"

/* Greatest number of targets. Light through more openings is found by the cosine lobe:
 * with 32 rooflights, the choice among them took more time than it saved. */
enum { MOST_TARGETS = 8 };

/* Limits of q, the share of the directions to openings. Between them it is 1 less the
 * throughput, so that the throughput of other directions does not grow above 1 where
 * surfaces are bright. With q = 0.5 throughout, a well with a reflectance of 0.7 took
 * three times longer. */
static const double LEAST_AIMED = 0.1, MOST_AIMED = 0.5;

/* Points on surfaces count as inside, with this allowance (m) for rounding. */
static const double INSIDE_M = 0.001;

static bool is_matched(const struct pp_world *world, int coarse)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].is_nested && world->openings[i].counterpart == coarse)
            return true;
    return false;
}

/* Position in the scene of a point in the axes of the coarse model. */
static struct pp_vec3 placed(const struct pp_world *world, struct pp_vec3 centre,
                             struct pp_vec3 point)
{
    return pp_vec_sub(pp_placement_to_building(&world->within_place, point), centre);
}

static struct pp_target coarse_target(const struct pp_world *world,
                                      const struct pp_opening *opening,
                                      struct pp_vec3 centre)
{
    const struct pp_vec3 origin = {0.0, 0.0, 0.0};
    double angle_rad = world->within_place.rotate_rad;
    struct pp_target target = pp_openings_target(opening, origin);
    target.normal = pp_placement_turn(target.normal, angle_rad);
    target.along = pp_placement_turn(target.along, angle_rad);
    target.up = pp_placement_turn(target.up, angle_rad);
    target.corner = placed(world, centre, target.corner);
    target.middle = placed(world, centre, target.middle);
    return target;
}

enum pp_status pp_coarse_openings_find(struct pp_coarse_openings *coarse,
                                       const struct pp_world *world,
                                       struct pp_vec3 centre, struct pp_error *err)
{
    const struct pp_world *within = world->within;
    coarse->inside = pp_bounds3_empty();
    if (!within || !world->within_is_before)
        return PP_OK;
    coarse->list = calloc((size_t)within->opening_count + 1, sizeof *coarse->list);
    if (!coarse->list)
        return pp_fail_memory(err);
    for (int i = 0; i < within->opening_count; i++)
        if (within->openings[i].rectangle && !is_matched(world, i))
            coarse->list[coarse->count++] =
                coarse_target(world, &within->openings[i], centre);
    if (coarse->count > MOST_TARGETS)
        coarse->count = 0;
    for (int i = 0; i < within->face_count; i++) {
        const struct pp_polygon *face = &within->surfaces[i].outline;
        for (int k = 0; k < face->count; k++)
            pp_bounds3_add(&coarse->inside, placed(world, centre, face->vertices[k]));
    }
    return PP_OK;
}

static bool is_inside(const struct pp_bounds3 *box, struct pp_vec3 p)
{
    return p.x > box->low.x - INSIDE_M && p.x < box->high.x + INSIDE_M
           && p.y > box->low.y - INSIDE_M && p.y < box->high.y + INSIDE_M
           && p.z > box->low.z - INSIDE_M && p.z < box->high.z + INSIDE_M;
}

/* A surface that sees the openings of the coarse model. */
struct coarse_viewer {
    const struct pp_coarse_openings *coarse;
    struct pp_brightness brightness;
    struct pp_vec3 from, normal;
    double share[MOST_TARGETS], total; /* importance of each opening, and their sum */
};

static bool sees_openings(struct coarse_viewer *viewer)
{
    for (int i = 0; i < viewer->coarse->count; i++)
        viewer->total += viewer->share[i] =
            pp_sample_polygon_importance(&viewer->coarse->list[i], viewer->from,
                                         viewer->normal, &viewer->brightness);
    return viewer->total > 0.0;
}

/* Density of directions to the openings, per steradian. */
static double aimed_pdf(const struct coarse_viewer *viewer, struct pp_vec3 to)
{
    double pdf = 0.0;
    for (int i = 0; i < viewer->coarse->count; i++) {
        const struct pp_target *target = &viewer->coarse->list[i];
        struct pp_polygon_sampler sampler;
        struct pp_vec3 there;
        if (!(viewer->share[i] > 0.0)
            || !pp_target_meets_rectangle(target, viewer->from, to, &there))
            continue;
        pp_sample_polygon_init(&sampler, target, viewer->from, viewer->normal,
                               &viewer->brightness);
        pdf += viewer->share[i] / viewer->total * pp_sample_polygon_pdf(&sampler, to);
    }
    return pdf;
}

static struct pp_vec3 aimed(const struct coarse_viewer *viewer, const double u[2],
                            double choice)
{
    struct pp_polygon_sampler sampler;
    int chosen = pp_sample_discrete(viewer->share, viewer->coarse->count,
                                    choice * viewer->total);
    pp_sample_polygon_init(&sampler, &viewer->coarse->list[chosen], viewer->from,
                           viewer->normal, &viewer->brightness);
    return pp_sample_polygon_draw(&sampler, u[0], u[1]).direction;
}

bool pp_coarse_openings_draw(const struct pp_coarse_openings *coarse,
                             const struct pp_brightness *brightness,
                             struct pp_vec3 from, const struct pp_frame *frame,
                             double throughput, const double u[3], struct pp_vec3 *to,
                             double *weight)
{
    double q = fmax(LEAST_AIMED, fmin(MOST_AIMED, 1.0 - throughput));
    struct coarse_viewer viewer = {
        .coarse = coarse, .brightness = *brightness, .from = from, .normal = frame->z};
    viewer.brightness.beyond_count = 0;
    if (coarse->count == 0 || !is_inside(&coarse->inside, from)
        || !sees_openings(&viewer))
        return false;
    *to = u[2] < q ? aimed(&viewer, u, u[2] / q)
                   : pp_lobe_sample_in_frame(frame->x, frame->y, frame->z, u[0], u[1]);
    double own = pp_vec_dot(frame->z, *to) / PP_PI;
    *weight = own > 0.0 ? own / ((1.0 - q) * own + q * aimed_pdf(&viewer, *to)) : 0.0;
    return true;
}
