/* exact.c - see exact.h. */
#include "methods/exact.h"

#include <stdlib.h>

#include "methods/direct.h"
#include "methods/occluders.h"
#include "methods/outside.h"
#include "methods/quadrature.h"
#include "methods/visible.h"

/* ---- diffusing panes ---- */

/* Places along each side of a pane, from -1 to 1, at the nodes of Chebyshev's
 * polynomial: -cos((2 i + 1) pi / 10), and the product of each one's distances from the
 * others. */
enum { PLACES = 5 };
static const double places[PLACES] = {-0.95105651629515357, -0.58778525229247313, 0.0,
                                      0.58778525229247313, 0.95105651629515357};
static const double apart[PLACES] = {1.0112712429686841, -0.38627124296868427, 0.3125,
                                     -0.38627124296868427, 1.0112712429686841};

/* What falls on the outside of a pane, at places over its extent along the opening's
 * own axes (m, from the room's origin). */
struct pane {
    double low[2], high[2];
    struct pp_outside at[PLACES][PLACES];
};

/* The pane as a receiver sees it. */
struct pane_seen {
    const struct pane *pane;
    struct pp_vec3 along, up, toward;
    double eye[2]; /* the foot of its perpendicular, on the pane's axes */
    double distance_m;
};

/* Lagrange's polynomials through the places, at t from -1 to 1. */
static void weigh(double weights[PLACES], double t)
{
    for (int i = 0; i < PLACES; i++) {
        weights[i] = 1.0 / apart[i];
        for (int k = 0; k < PLACES; k++)
            if (k != i)
                weights[i] *= t - places[k];
    }
}

static struct pp_outside pane_at(const struct pane_seen *seen, struct pp_vec3 u)
{
    const struct pane *pane = seen->pane;
    double reach_m = seen->distance_m / pp_dot(u, seen->toward);
    double xy[2] = {seen->eye[0] + reach_m * pp_dot(u, seen->along),
                    seen->eye[1] + reach_m * pp_dot(u, seen->up)};
    double weights[2][PLACES];
    for (int axis = 0; axis < 2; axis++) {
        double middle = (pane->low[axis] + pane->high[axis]) / 2.0;
        weigh(weights[axis],
              (xy[axis] - middle) / ((pane->high[axis] - pane->low[axis]) / 2.0));
    }
    struct pp_outside sum = {0};
    for (int i = 0; i < PLACES; i++)
        for (int k = 0; k < PLACES; k++) {
            double weight = weights[0][i] * weights[1][k];
            sum.sky += weight * pane->at[i][k].sky;
            sum.external += weight * pane->at[i][k].external;
        }
    return sum;
}

static double pane_sky(const void *seen, struct pp_vec3 u)
{
    return pane_at(seen, u).sky;
}

static double pane_external(const void *seen, struct pp_vec3 u)
{
    return pane_at(seen, u).external;
}

static enum pp_status light_pane(struct pane *pane, const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    const struct pp_polygon *outline = &opening->outer;
    struct pp_vec3 toward = pp_scale(opening->inner.normal, -1.0);
    *pane = (struct pane){.low = {INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY}};
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 v = outline->vertices[i];
        double xy[2] = {pp_dot(v, opening->along), pp_dot(v, opening->up)};
        for (int axis = 0; axis < 2; axis++) {
            pane->low[axis] = fmin(pane->low[axis], xy[axis]);
            pane->high[axis] = fmax(pane->high[axis], xy[axis]);
        }
    }
    struct pp_vec3 foot = pp_scale(toward, pp_dot(outline->vertices[0], toward));
    for (int i = 0; i < PLACES; i++)
        for (int k = 0; k < PLACES; k++) {
            double share[2] = {(1.0 + places[i]) / 2.0, (1.0 + places[k]) / 2.0}, xy[2];
            for (int axis = 0; axis < 2; axis++)
                xy[axis] = pane->low[axis]
                           + share[axis] * (pane->high[axis] - pane->low[axis]);
            struct pp_vec3 at = pp_along(foot, xy[0], opening->along);
            at = pp_along(at, xy[1], opening->up);
            enum pp_status status = pp_outside_at(&pane->at[i][k], world, &world->sky,
                                                  at, toward, opening->face, err);
            if (status != PP_OK)
                return status;
        }
    return PP_OK;
}

/* The panes that are lit unevenly are lit once for the room: a list with one for each
 * opening, of which the others stay empty. NULL where there are none. */
static enum pp_status light_panes(void **tools, const struct pp_world *world,
                                  struct pp_error *err)
{
    struct pane *panes = NULL;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (!opening->glass.diffusing || pp_outside_is_even(world, opening))
            continue;
        if (!panes)
            panes = calloc((size_t)world->opening_count, sizeof *panes);
        status =
            panes ? light_pane(&panes[i], world, opening, err) : pp_fail_memory(err);
    }
    if (status != PP_OK)
        free(panes);
    else
        *tools = panes;
    return status;
}

/* Integral of what falls on the pane's outside times (n.u) over what is seen of it. */
static enum pp_status from_uneven_pane(struct pp_direct *sum,
                                       const struct pp_visible *visible,
                                       const struct pane *pane,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       struct pp_error *err)
{
    struct pp_vec3 eye = receiver->position;
    struct pane_seen seen = {
        .pane = pane,
        .along = opening->along,
        .up = opening->up,
        .toward = pp_scale(opening->inner.normal, -1.0),
        .eye = {pp_dot(eye, opening->along), pp_dot(eye, opening->up)}};
    seen.distance_m = pp_dot(pp_sub(opening->outer.vertices[0], eye), seen.toward);
    struct pp_integrand parts[2] = {{pane_sky, &seen, NULL},
                                    {pane_external, &seen, NULL}};
    double *values[2] = {&sum->sky, &sum->external};
    enum pp_status status = PP_OK;
    for (int i = 0; i < 2 && status == PP_OK; i++) {
        struct pp_quadrature result;
        status = pp_quadrature_over(
            &result, &visible->view, &visible->patches[0].region, &receiver->normal, 1,
            receiver->normal, &parts[i],
            sum->rough ? PP_QUADRATURE_ROUGH : PP_QUADRATURE_GLAZED, err);
        *values[i] += result.value;
    }
    return status;
}

/* The pane is lit evenly: what falls on it, what of that it lets through, and its
 * configuration factor c. */
static void set_down_even_pane(struct pp_steps *steps, const struct pp_outside *outside,
                               double c, double tau)
{
    pp_step_named(steps, PP_UNIT_NUMBER, c, "c",
                  "configuration factor of what is seen of the diffusing pane");
    pp_step_named(steps, PP_UNIT_NUMBER, tau, "tau", "its transmittance");
    pp_step_named(steps, PP_UNIT_SHARE, outside->sky, "E_s",
                  "illuminance of its outside, from the sky");
    pp_step_worked(steps, PP_UNIT_SHARE, tau * outside->sky * c, "sc", "tau E_s c",
                   "sky component");
    if (outside->external == 0.0)
        return;
    pp_step_named(steps, PP_UNIT_SHARE, outside->external, "E_e",
                  "the same, from the ground and what hides the sky");
    pp_step_worked(steps, PP_UNIT_SHARE, tau * outside->external * c, "erc",
                   "tau E_e c", "externally reflected component");
}

static enum pp_status from_even_pane(struct pp_direct *sum,
                                     const struct pp_visible *visible,
                                     const struct pp_world *world,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     struct pp_error *err)
{
    struct pp_outside outside;
    struct pp_moments moments;
    enum pp_status status =
        pp_outside_at(&outside, world, &world->sky, opening->outer.vertices[0],
                      pp_scale(opening->inner.normal, -1.0), opening->face, err);
    if (status == PP_OK)
        status = pp_direct_moments(&moments, visible, &visible->patches[0],
                                   receiver->normal, &receiver->normal, 1, err);
    if (status != PP_OK)
        return status;
    sum->sky += outside.sky * moments.cosine;
    sum->external += outside.external * moments.cosine;
    set_down_even_pane(sum->steps, &outside, moments.cosine / PP_PI,
                       opening->glass.diffuse);
    return PP_OK;
}

static enum pp_status from_diffusing_pane(struct pp_direct *sum,
                                          const struct pp_world *world,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver,
                                          const struct pane *panes,
                                          struct pp_error *err)
{
    struct pp_visible visible;
    enum pp_status status =
        pp_visible_opening(&visible, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    if (visible.patch_count > 0) {
        struct pane own;
        const struct pane *pane = panes ? panes + (opening - world->openings) : &own;
        bool even = pp_outside_is_even(world, opening);
        if (!even && !panes)
            status = light_pane(&own, world, opening, err);
        if (even)
            status = from_even_pane(sum, &visible, world, opening, receiver, err);
        else if (status == PP_OK)
            status = from_uneven_pane(sum, &visible, pane, opening, receiver, err);
        /* A Lambertian emitter of exitance tau E has luminance tau E / pi. */
        sum->sky *= opening->glass.diffuse / PP_PI;
        sum->external *= opening->glass.diffuse / PP_PI;
    }
    pp_visible_clear(&visible);
    return status;
}

/* ---- the method ---- */

static enum pp_status direct_of(const struct pp_world *world,
                                const struct pp_opening *opening,
                                const struct pp_receiver *receiver, bool rough,
                                const void *tools, struct pp_part *part,
                                struct pp_error *err)
{
    struct pp_direct sum = {.rough = rough, .steps = part->steps};
    enum pp_status status;
    if (opening->glass.diffusing)
        status = from_diffusing_pane(&sum, world, opening, receiver, tools, err);
    else
        status =
            pp_direct_through(&sum, world, opening, receiver, &opening->glass, err);
    part->sky = sum.sky;
    part->external = sum.external;
    return status;
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    return direct_of(world, opening, receiver, false, tools, part, err);
}

static enum pp_status evaluate_roughly(const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    return direct_of(world, opening, receiver, true, tools, part, err);
}

const struct pp_method pp_method_exact = {
    .name = "exact",
    .summary = "direct component by closed form or quadrature",
    .source = "ARVO95",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS,
    .prepare = light_panes,
    .put_away = free,
    .evaluate = evaluate,
    .evaluate_roughly = evaluate_roughly,
};
