/* waldram.c - `waldram`: direct component by counting squares on Waldram's diagram
 * [WW23].
 *
 * The visible part of each opening is drawn on the diagram (waldram_scale.h), and the
 * squares of sky and of obstructions are counted (waldram_squares.h):
 *
 *     SC  = squares of sky x 0.1 %
 *     ERC = luminance factor x squares of obstruction x 0.1 %
 *
 * For skies without azimuth dependence and points that face up. Vertical openings with
 * clear glass, by the diagram that has its losses, and unglazed ones at any slope.
 */
#include <stdlib.h>
#include <string.h>

#include "methods/exact/direct.h"
#include "methods/exact/quadrature.h"
#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/view/visible.h"
#include "methods/waldram/waldram_squares.h"

/* The diagrams for the room's openings; one that no opening needs is not set. */
struct waldram_diagrams {
    struct pp_waldram unglazed, glazed;
};

static enum pp_status prepare(void **tools, const struct pp_world *world,
                              struct pp_error *err)
{
    struct waldram_diagrams *diagrams = malloc(sizeof *diagrams);
    if (!diagrams)
        return pp_fail_memory(err);
    bool glazed = false, unglazed = false;
    for (int i = 0; i < world->opening_count; i++)
        *(world->openings[i].glass.panes > 0 ? &glazed : &unglazed) = true;
    enum pp_status status = PP_OK;
    if (unglazed)
        status = pp_waldram_scale_init(&diagrams->unglazed, &world->sky, false, err);
    if (glazed && status == PP_OK)
        status = pp_waldram_scale_init(&diagrams->glazed, &world->sky, true, err);
    if (status != PP_OK)
        free(diagrams);
    else
        *tools = diagrams;
    return status;
}

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    if (pp_sky_has_azimuth(&world->sky))
        return "the diagram holds skies that are the same in all azimuths";
    const char *why = pp_refusals_unless_up(receiver);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)world, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass; the diagram holds clear glass only";
    if (opening->glass.panes > 0 && pp_refusals_unless_vertical(opening))
        return "has sloping glass; the diagram with glass holds vertical openings only";
    return NULL;
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    const struct waldram_diagrams *diagrams = tools;
    const struct pp_waldram *waldram =
        opening->glass.panes > 0 ? &diagrams->glazed : &diagrams->unglazed;
    struct pp_window_drawing drawing;
    enum pp_status status =
        pp_window_drawing_init(&drawing, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    pp_steps_add_named(part->steps, PP_UNIT_SHARE, PP_WALDRAM_WORTH, "w",
                       "a square of the diagram is worth");
    struct pp_part_steps terms = pp_part_steps_begin(part->steps, drawing.count);
    for (int i = 0; i < drawing.count && status == PP_OK; i++) {
        const struct pp_drawn_part *drawn = &drawing.parts[i];
        struct pp_waldram_count count;
        status = pp_waldram_squares_count(&count, waldram, &drawing.axes,
                                          &drawn->region, err);
        if (status != PP_OK)
            break;
        double share = drawn->factor * count.squares * PP_WALDRAM_WORTH;
        *(drawn->hidden ? &part->external : &part->sky) += share;
        pp_window_drawing_steps(&terms, drawn, count.squares, "squares", share);
        pp_waldram_squares_clear(&count);
    }
    pp_part_steps_end(&terms);
    pp_window_drawing_clear(&drawing);
    return status;
}

/* The diagram, and the window's axes, for the luminance of the sky through the glass
 * with the diagram's product of losses. */
struct charted {
    const struct pp_waldram *waldram;
    struct pp_vec3 along, toward;
};

static double charted_luminance(const void *context, struct pp_vec3 u)
{
    const struct charted *charted = context;
    const struct pp_glass *glass = &charted->waldram->glass;
    double aside = pp_vec_dot(u, charted->along),
           ahead = pp_vec_dot(u, charted->toward);
    double level = hypot(aside, ahead);
    if (!(level > 0.0))
        return 0.0;
    return pp_sky_luminance(&charted->waldram->sky, u)
           * pp_glass_transmittance(glass, level)
           * pp_glass_transmittance(glass, ahead / level) / glass->normal;
}

/* The component through glass by quadrature, with the diagram's losses. */
static enum pp_status integrate_glazed(const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const struct pp_waldram *waldram,
                                       struct pp_part *part, struct pp_error *err)
{
    struct pp_visible visible;
    enum pp_status status =
        pp_visible_through(&visible, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    struct charted charted = {waldram, visible.view.along, visible.view.toward};
    struct pp_integrand integrand = {charted_luminance, &charted, NULL};
    for (int i = 0; i < visible.patch_count && status == PP_OK; i++) {
        const struct pp_visible_patch *patch = &visible.patches[i];
        struct pp_vec3 planes[3] = {receiver->normal};
        struct pp_quadrature result;
        memcpy(planes + 1, patch->half_spaces, sizeof patch->half_spaces);
        status = pp_quadrature_over(&result, &visible.view, &patch->region, planes,
                                    1 + patch->half_space_count, receiver->normal,
                                    &integrand, PP_QUADRATURE_ROUGH, err);
        if (patch->hidden)
            part->external +=
                pp_visible_luminance_factor(&world->sky, patch->reflectance)
                * result.value;
        else
            part->sky += result.value;
    }
    pp_visible_clear(&visible);
    return status;
}

/* The mean of many counts is the area: for averages over many points the area is taken,
 * by quadrature, instead of squares. */
static enum pp_status evaluate_roughly(const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    if (opening->glass.panes == 0) {
        struct pp_direct sum = {.rough = true};
        enum pp_status plain =
            pp_direct_through(&sum, world, opening, receiver, &opening->glass, err);
        part->sky = sum.sky;
        part->external = sum.external;
        return plain;
    }
    const struct waldram_diagrams *diagrams = tools;
    return integrate_glazed(world, opening, receiver, &diagrams->glazed, part, err);
}

const struct pp_method pp_method_waldram = {
    .name = "waldram",
    .summary = "direct component by counting squares on a Waldram diagram",
    .source = "WW23",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .counts = true,
    .prepare = prepare,
    .destroy_tools = free,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
    .evaluate_roughly = evaluate_roughly,
};
