/* waldram.c - `waldram`: direct component by counting squares on Waldram's diagram
 * [WW23].
 *
 * What the point sees of each opening is drawn on the diagram (waldram_scale.h) and the
 * squares are counted (waldram_squares.h): of the sky, and of what hides it,
 *
 *     SC  = squares of sky x 0.1 %
 *     ERC = luminance factor x squares of obstruction x 0.1 %
 *
 * For skies without azimuth dependence and points that face up. Vertical openings with
 * clear glass, by the diagram that has its losses, and unglazed ones at any slope.
 */
#include <stdlib.h>

#include "methods/methods.h"
#include "methods/refusals.h"
#include "methods/waldram_squares.h"

/* The diagrams that are kept at hand. */
struct diagrams {
    struct pp_waldram unglazed, glazed;
};

static enum pp_status prepare(void **tools, const struct pp_world *world,
                              struct pp_error *err)
{
    struct diagrams *diagrams = malloc(sizeof *diagrams);
    if (!diagrams)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_waldram_make(&diagrams->unglazed, &world->sky, false, err);
    if (status == PP_OK)
        status = pp_waldram_make(&diagrams->glazed, &world->sky, true, err);
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
    const char *why = pp_refuse_unless_up(receiver);
    return why ? why : pp_refuse_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)world, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass; the diagram holds clear glass only";
    if (opening->glass.panes > 0 && pp_refuse_unless_vertical(opening))
        return "has sloping glass; the diagram with glass holds vertical openings only";
    return NULL;
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    const struct diagrams *diagrams = tools;
    const struct pp_waldram *waldram =
        opening->glass.panes > 0 ? &diagrams->glazed : &diagrams->unglazed;
    struct pp_window_drawing drawing;
    enum pp_status status =
        pp_window_drawing_create(&drawing, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < drawing.count && status == PP_OK; i++) {
        const struct pp_drawn_part *drawn = &drawing.parts[i];
        struct pp_waldram_count count;
        status = pp_waldram_count_squares(&count, waldram, &drawing.axes,
                                          &drawn->region, err);
        if (status != PP_OK)
            break;
        double share = drawn->factor * count.squares * PP_WALDRAM_WORTH;
        *(drawn->hidden ? &part->external : &part->sky) += share;
        pp_step(part->steps, PP_UNIT_COUNT, count.squares,
                "opening on line %d: squares of %s", opening->line,
                drawn->hidden ? "obstruction" : "sky");
        if (drawn->hidden)
            pp_step(part->steps, PP_UNIT_NUMBER, drawn->factor,
                    "opening on line %d: luminance factor of the obstruction",
                    opening->line);
        pp_waldram_count_clear(&count);
    }
    pp_step(part->steps, PP_UNIT_SHARE, PP_WALDRAM_WORTH, "a square is worth");
    pp_window_drawing_clear(&drawing);
    return status;
}

const struct pp_method pp_method_waldram = {
    .name = "waldram",
    .summary = "direct component by counting squares on a Waldram diagram",
    .source = "WW23",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .prepare = prepare,
    .put_away = free,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
