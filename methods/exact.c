/* exact.c - see exact.h. */
#include "methods/exact.h"

#include <stdlib.h>

#include "methods/direct.h"
#include "methods/occluders.h"
#include "methods/outside.h"
#include "methods/quadrature.h"
#include "methods/visible.h"

/* ---- diffusing panes ---- */

/* Places along each side of a pane, at the nodes of Chebyshev's polynomial. */
enum { PLACES = 5 };

static double place(int i)
{
    return -cos((2 * i + 1) * PP_PI / (2 * PLACES));
}

/* What falls on the outside of a pane, at places over its extent. */
struct pane {
    struct pp_vec3 eye;
    struct pp_vec3 along, up, toward;
    double distance_m;      /* from the eye */
    double low[2], high[2]; /* extent, from the foot of the eye's perpendicular */
    struct pp_outside at[PLACES][PLACES];
};

/* Lagrange's polynomials through the places, at t from -1 to 1. */
static void weigh(double weights[PLACES], double t)
{
    for (int i = 0; i < PLACES; i++) {
        weights[i] = 1.0;
        for (int k = 0; k < PLACES; k++)
            if (k != i)
                weights[i] *= (t - place(k)) / (place(i) - place(k));
    }
}

static struct pp_outside pane_at(const struct pane *pane, struct pp_vec3 u)
{
    double depth = pp_dot(u, pane->toward), weights[2][PLACES];
    double xy[2] = {pp_dot(u, pane->along) / depth * pane->distance_m,
                    pp_dot(u, pane->up) / depth * pane->distance_m};
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

static double pane_sky(const void *pane, struct pp_vec3 u)
{
    return pane_at(pane, u).sky;
}

static double pane_external(const void *pane, struct pp_vec3 u)
{
    return pane_at(pane, u).external;
}

static enum pp_status light_pane(struct pane *pane, const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_vec3 eye,
                                 struct pp_error *err)
{
    const struct pp_polygon *outline = &opening->outer;
    *pane = (struct pane){.eye = eye,
                          .along = opening->along,
                          .up = opening->up,
                          .toward = pp_scale(opening->inner.normal, -1.0),
                          .low = {INFINITY, INFINITY},
                          .high = {-INFINITY, -INFINITY}};
    pane->distance_m = pp_dot(pp_sub(outline->vertices[0], eye), pane->toward);
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 v = pp_sub(outline->vertices[i], eye);
        double xy[2] = {pp_dot(v, pane->along), pp_dot(v, pane->up)};
        for (int axis = 0; axis < 2; axis++) {
            pane->low[axis] = fmin(pane->low[axis], xy[axis]);
            pane->high[axis] = fmax(pane->high[axis], xy[axis]);
        }
    }
    for (int i = 0; i < PLACES; i++)
        for (int k = 0; k < PLACES; k++) {
            double share[2] = {(1.0 + place(i)) / 2.0, (1.0 + place(k)) / 2.0}, xy[2];
            for (int axis = 0; axis < 2; axis++)
                xy[axis] = pane->low[axis]
                           + share[axis] * (pane->high[axis] - pane->low[axis]);
            struct pp_vec3 at = pp_along(eye, xy[0], pane->along);
            at = pp_along(at, xy[1], pane->up);
            at = pp_along(at, pane->distance_m, pane->toward);
            enum pp_status status = pp_outside_at(&pane->at[i][k], world, &world->sky,
                                                  at, pane->toward, opening->face, err);
            if (status != PP_OK)
                return status;
        }
    return PP_OK;
}

/* Integral of what falls on the pane's outside times (n.u) over what is seen of it. */
static enum pp_status from_uneven_pane(struct pp_direct *sum,
                                       const struct pp_visible *visible,
                                       const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       struct pp_error *err)
{
    struct pane pane;
    enum pp_status status = light_pane(&pane, world, opening, receiver->position, err);
    struct pp_integrand parts[2] = {{pane_sky, &pane, NULL},
                                    {pane_external, &pane, NULL}};
    double *values[2] = {&sum->sky, &sum->external};
    for (int i = 0; i < 2 && status == PP_OK; i++) {
        struct pp_quadrature result;
        status = pp_quadrature_over(
            &result, &visible->view, &visible->patches[0].region, &receiver->normal, 1,
            receiver->normal, &parts[i], PP_QUADRATURE_GLAZED, err);
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
                                          struct pp_error *err)
{
    struct pp_visible visible;
    enum pp_status status =
        pp_visible_opening(&visible, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    if (visible.patch_count > 0) {
        if (pp_outside_is_even(world, opening))
            status = from_even_pane(sum, &visible, world, opening, receiver, err);
        else
            status = from_uneven_pane(sum, &visible, world, opening, receiver, err);
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
                                struct pp_part *part, struct pp_error *err)
{
    struct pp_direct sum = {.rough = rough, .steps = part->steps};
    enum pp_status status;
    if (opening->glass.diffusing)
        status = from_diffusing_pane(&sum, world, opening, receiver, err);
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
    (void)tools;
    return direct_of(world, opening, receiver, false, part, err);
}

static enum pp_status evaluate_roughly(const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    (void)tools;
    return direct_of(world, opening, receiver, true, part, err);
}

const struct pp_method pp_method_exact = {
    .name = "exact",
    .summary = "direct component by closed form or quadrature",
    .source = "ARVO95",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS,
    .evaluate = evaluate,
    .evaluate_roughly = evaluate_roughly,
};
