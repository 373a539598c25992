/* waldram.c - `waldram`: direct component by counting squares on Waldram's diagram
 * [WW23].
 *
 * The visible part of each opening is drawn on the diagram (waldram_scale.h), and the
 * squares of sky and of obstructions are counted (waldram_squares.h):
 *
 *     SC  = squares of sky x 0.1 %
 *     ERC = luminance factor x squares of obstruction x 0.1 %
 *
 * The method is for skies without azimuth dependence and points that face up. Vertical
 * openings may have clear glass, whose losses are in the diagram; unglazed openings may
 * have any slope.
 */
#include <stdlib.h>
#include <string.h>

#include "methods/average/plane_light.h"
#include "methods/exact/direct.h"
#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/view/visible.h"
#include "methods/waldram/waldram_squares.h"

/* The diagrams for the room's openings; a diagram that no opening needs is not set. */
struct waldram_diagrams {
    struct pp_waldram unglazed, glazed;
};

static enum pp_status prepare_waldram(void **tools, const struct pp_world *world,
                                      const struct pp_outside_light *light,
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
        status = pp_waldram_scale_init(&diagrams->unglazed, &light->sky, false, err);
    if (glazed && status == PP_OK)
        status = pp_waldram_scale_init(&diagrams->glazed, &light->sky, true, err);
    if (status != PP_OK)
        free(diagrams);
    else
        *tools = diagrams;
    return status;
}

static const char *waldram_refuses_room(const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_receiver *receiver)
{
    if (pp_sky_has_azimuth(&light->sky))
        return "valid only for skies whose luminance does not depend on azimuth";
    const char *why = pp_refusals_unless_up(receiver);
    why = why ? why : pp_refusals_if_fine_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *waldram_refuses(const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_opening *opening,
                                   const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass, but the diagram is for clear glass only";
    if (opening->glass.panes > 0 && pp_refusals_unless_vertical(opening))
        return "has sloping glass, but the diagram that includes glass is for vertical "
               "openings only";
    return NULL;
}

static enum pp_status evaluate_waldram(const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    const struct waldram_diagrams *diagrams = tools;
    const struct pp_waldram *waldram =
        opening->glass.panes > 0 ? &diagrams->glazed : &diagrams->unglazed;
    struct pp_window_drawing drawing;
    enum pp_status status = pp_window_drawing_init(&drawing, world, light, opening,
                                                   receiver->position, err);
    if (status != PP_OK)
        return status;
    pp_worksheet_put(&part->sheet, PP_UNIT_DAYLIGHT_FACTOR, PP_WALDRAM_WORTH, "w",
                     "value of one square");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, drawing.count);
    for (int i = 0; i < drawing.count && status == PP_OK; i++) {
        const struct pp_drawn_part *drawn = &drawing.parts[i];
        struct pp_waldram_count count;
        status = pp_waldram_squares_count(&count, waldram, &drawing.axes,
                                          &drawn->region, err);
        if (status != PP_OK)
            break;
        *(drawn->hidden ? &part->external : &part->sky) +=
            pp_window_drawing_work(&terms, drawn, count.squares, "squares");
        pp_waldram_squares_clear(&count);
    }
    pp_part_steps_end(&terms);
    pp_window_drawing_clear(&drawing);
    return status;
}

/* Context of the luminance of the sky through the glass, with the diagram's factorised
 * losses. */
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

/* The mean of many counts converges to the area, so an average over the plane
 * integrates the area, with the diagram's losses, instead of counting squares. */
static enum pp_status average_waldram(struct pp_beams *beams,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const void *tools, struct pp_part *part,
                                      bool *known, struct pp_error *err)
{
    const struct waldram_diagrams *diagrams = tools;
    *known = true;
    if (opening->glass.panes == 0) {
        double mean[2] = {0.0};
        enum pp_status plain =
            pp_plane_light_direct(mean, beams, light, opening, &opening->glass, err);
        part->sky = mean[0];
        part->external = mean[1];
        return plain;
    }
    struct charted charted = {&diagrams->glazed, opening->along,
                              pp_vec_scale(opening->inner.normal, -1.0)};
    const struct pp_plane_light beam = {
        .sky = charted_luminance,
        .context = &charted,
        .of_reflectance = pp_visible_luminance_factor(&light->sky, 1.0),
        .with_outside = true};
    double mean[2];
    enum pp_status status = pp_plane_light_average(mean, beams, opening, &beam, err);
    part->sky = mean[0];
    part->external = mean[1];
    return status;
}

const struct pp_method pp_method_waldram = {
    .name = "waldram",
    .summary = "direct component by counting squares on a Waldram diagram",
    .source = "WW23",
    .formulae = pp_window_drawing_formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .counts = true,
    .prepare = prepare_waldram,
    .destroy_tools = free,
    .refuses_room = waldram_refuses_room,
    .refuses = waldram_refuses,
    .evaluate = evaluate_waldram,
    .average = average_waldram,
};
