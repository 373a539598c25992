/* exact.c - `exact`: the direct component without approximation.
 *
 * The sky component is calculated
 *
 *   - by closed form [ARVO95] for the overcast and uniform skies without glass, to
 *     1e-9 or 1e-15 of the open sky
 *   - by sums over edges (pane_light.h), to 1e-9 of the open sky: with glass, for the
 *     overcast and uniform skies; without glass, for skies of ISO 15469 that do not
 *     depend on the sun; if the method was not prepared, by quadrature
 *   - by quadrature for other skies of ISO 15469, to 1e-9 without glass and 1e-6 with
 *     it; if the method was prepared for the points of a plane, by sums over edges, to
 *     1e-6 of the open sky
 *
 * The externally reflected component follows the conventions in direct.h. The method is
 * for any number of windows, rooflights and sloping openings, any receiver and any
 * shape of room; reveals, skylines, blocks and free-standing surfaces are included.
 *
 * A diffusing pane is a Lambertian emitter of the light that falls on its outside:
 * exact if that illuminance is uniform (nothing in front of the pane but sky, ground
 * and skylines without a distance), otherwise to 1e-6 by polynomials over parts of the
 * pane (diffusing_pane.h lists cases with larger errors). The illuminance of such panes
 * is calculated once for a room if the method is prepared, else again for each
 * receiver. The numbers are the same, except under skies of ISO 15469: a prepared
 * method has a table of the sky, with errors up to 1e-6 of the open sky.
 */
#include "methods/method.h"
#include "methods/refusals.h"

#include <stdlib.h>

#include "methods/average/plane_light.h"
#include "methods/exact/direct.h"
#include "methods/exact/exterior.h"
#include "methods/exact/diffusing_pane.h"
#include "methods/fast/pane_tables.h"
#include "methods/view/visible.h"

/* ---- calculated once for a room ---- */

struct exact_tools {
    struct pp_pane_tables *tables;
    /* Illuminance of non-uniformly lit diffusing panes: one item for each opening,
     * empty if the opening has no such pane. */
    int count;
    struct pp_diffusing_pane panes[];
};

static void destroy_exact_tools(void *of_exact)
{
    struct exact_tools *tools = of_exact;
    if (!tools)
        return;
    pp_pane_tables_destroy(tools->tables);
    for (int i = 0; i < tools->count; i++)
        pp_diffusing_pane_clear(&tools->panes[i]);
    free(tools);
}

static enum pp_status prepare_with(void **of_exact, const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_vec3 *plane, struct pp_error *err)
{
    size_t count = (size_t)world->opening_count;
    struct exact_tools *tools = calloc(1, sizeof *tools + count * sizeof *tools->panes);
    if (!tools)
        return pp_fail_memory(err);
    tools->count = world->opening_count;
    enum pp_status status =
        pp_pane_tables_create(&tools->tables, world, light, plane, err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (opening->glass.diffusing && !pp_exterior_is_uniform(world, opening))
            status = pp_diffusing_pane_init(&tools->panes[i], world, light, opening,
                                            true, err);
    }
    if (status != PP_OK)
        destroy_exact_tools(tools);
    else
        *of_exact = tools;
    return status;
}

static enum pp_status prepare_exact(void **tools, const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    struct pp_error *err)
{
    return prepare_with(tools, world, light, NULL, err);
}

static enum pp_status prepare_for_plane(void **tools, const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        struct pp_error *err)
{
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    return prepare_with(tools, world, light, &up, err);
}

/* ---- diffusing panes ---- */

/* Records the steps for a uniformly lit pane: its illuminance outside, its
 * transmittance, and the configuration factor c of its visible part. */
static void add_even_pane_steps(struct pp_steps *steps,
                                const struct pp_exterior_light *outside, double c,
                                double tau)
{
    pp_steps_add_named(
        steps, PP_UNIT_NUMBER, c, "c",
        "configuration factor of the visible part of the diffusing pane");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, tau, "tau", "transmittance of the pane");
    pp_steps_add_named(steps, PP_UNIT_DAYLIGHT_FACTOR, outside->sky, "E_s",
                       "illuminance on the outside of the pane from the sky");
    pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, tau * outside->sky * c, "sc",
                        "tau E_s c", "sky component");
    if (outside->external == 0.0)
        return;
    pp_steps_add_named(
        steps, PP_UNIT_DAYLIGHT_FACTOR, outside->external, "E_e",
        "illuminance on the outside of the pane from ground and obstructions");
    pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, tau * outside->external * c,
                        "erc", "tau E_e c", "externally reflected component");
}

static enum pp_status from_even_pane(struct pp_direct *sum,
                                     const struct pp_visible *visible,
                                     const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     struct pp_error *err)
{
    struct pp_exterior_light outside;
    struct pp_moments moments;
    enum pp_status status = pp_exterior_light_on_plane(
        &outside, world, light, opening->outer.vertices[0],
        pp_vec_scale(opening->inner.normal, -1.0), opening->face, err);
    if (status == PP_OK)
        status = pp_direct_moments(&moments, visible, &visible->patches[0],
                                   receiver->normal, &receiver->normal, 1, err);
    if (status != PP_OK)
        return status;
    sum->sky += outside.sky * moments.cosine;
    sum->external += outside.external * moments.cosine;
    add_even_pane_steps(sum->steps, &outside, moments.cosine / PP_PI,
                        opening->glass.diffuse);
    return PP_OK;
}

static enum pp_status from_diffusing_pane(struct pp_direct *sum,
                                          const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver,
                                          const struct pp_diffusing_pane *prepared,
                                          struct pp_error *err)
{
    struct pp_visible visible;
    enum pp_status status =
        pp_visible_opening(&visible, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    if (visible.patch_count > 0) {
        struct pp_diffusing_pane own = {0};
        if (pp_exterior_is_uniform(world, opening)) {
            status =
                from_even_pane(sum, &visible, world, light, opening, receiver, err);
        } else {
            if (!prepared)
                status =
                    pp_diffusing_pane_init(&own, world, light, opening, false, err);
            if (status == PP_OK)
                status = pp_diffusing_pane_add(sum, prepared ? prepared : &own,
                                               &visible, opening, receiver, err);
            pp_diffusing_pane_clear(&own);
        }
        /* A Lambertian emitter of exitance tau E has luminance tau E / pi. */
        sum->sky *= opening->glass.diffuse / PP_PI;
        sum->external *= opening->glass.diffuse / PP_PI;
    }
    pp_visible_clear(&visible);
    return status;
}

/* ---- the method ---- */

static enum pp_status direct_of(const struct pp_world *world,
                                const struct pp_outside_light *light,
                                const struct pp_opening *opening,
                                const struct pp_receiver *receiver, bool rough,
                                const void *tools, struct pp_part *part,
                                struct pp_error *err)
{
    const struct exact_tools *prepared = tools;
    int index = (int)(opening - world->openings);
    struct pp_direct sum = {
        .rough = rough,
        .tables = prepared ? pp_pane_tables_at(prepared->tables, index) : NULL,
        .steps = part->sheet.steps};
    enum pp_status status;
    if (opening->glass.diffusing)
        status = from_diffusing_pane(&sum, world, light, opening, receiver,
                                     prepared ? &prepared->panes[index] : NULL, err);
    else
        status = pp_direct_through(&sum, world, light, opening, receiver,
                                   &opening->glass, err);
    part->sky = sum.sky;
    part->external = sum.external;
    return status;
}

static enum pp_status evaluate_exact(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     const void *tools, struct pp_part *part,
                                     struct pp_error *err)
{
    return direct_of(world, light, opening, receiver, false, tools, part, err);
}

static enum pp_status evaluate_roughly(const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    return direct_of(world, light, opening, receiver, true, tools, part, err);
}

/* A uniformly lit diffusing pane has the same luminance in all directions. */
static double unity(const void *context, struct pp_vec3 u)
{
    (void)context, (void)u;
    return 1.0;
}

static enum pp_status average_of_even_pane(struct pp_beams *beams,
                                           const struct pp_outside_light *light,
                                           const struct pp_opening *opening,
                                           struct pp_part *part, struct pp_error *err)
{
    const struct pp_plane_light beam = {.sky = unity};
    struct pp_exterior_light outside;
    double mean[2];
    enum pp_status status = pp_exterior_light_on_plane(
        &outside, pp_beams_world(beams), light, opening->outer.vertices[0],
        pp_vec_scale(opening->inner.normal, -1.0), opening->face, err);
    if (status == PP_OK)
        status = pp_plane_light_average(mean, beams, opening, &beam, err);
    if (status != PP_OK)
        return status;
    part->sky = opening->glass.diffuse / PP_PI * outside.sky * mean[0];
    part->external = opening->glass.diffuse / PP_PI * outside.external * mean[0];
    return PP_OK;
}

static enum pp_status average_exact(struct pp_beams *beams,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening, const void *tools,
                                    struct pp_part *part, bool *known,
                                    struct pp_error *err)
{
    (void)tools;
    *known = !opening->glass.diffusing
             || pp_exterior_is_uniform(pp_beams_world(beams), opening);
    if (!*known)
        return PP_OK;
    if (opening->glass.diffusing)
        return average_of_even_pane(beams, light, opening, part, err);
    double mean[2] = {0.0};
    enum pp_status status =
        pp_plane_light_direct(mean, beams, light, opening, &opening->glass, err);
    part->sky = mean[0];
    part->external = mean[1];
    return status;
}

static const char *exact_refuses_room(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_receiver *receiver)
{
    (void)light, (void)receiver;
    return pp_refusals_if_fine_mesh(world);
}

const struct pp_method pp_method_exact = {
    .name = "exact",
    .summary = "direct component in closed form or by quadrature",
    .source = "ARVO95",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS,
    .refuses_room = exact_refuses_room,
    .prepare_fast = prepare_exact,
    .prepare_for_plane = prepare_for_plane,
    .destroy_tools = destroy_exact_tools,
    .evaluate = evaluate_exact,
    .average = average_exact,
    .evaluate_roughly = evaluate_roughly,
};
