/* pepper_pot.c - `pepper-pot`: direct component by counting dots on Pleijel's diagram
 * [PLE54].
 *
 * The window in true perspective from the point is laid under the diagram
 * (pepper_pot_dots.h); each dot within the outline is worth 0.1 %:
 *
 *     SC  = dots on the sky x 0.1 %
 *     ERC = luminance factor x dots on obstructions x 0.1 %
 *
 * The method is for vertical openings, clear glass or none, the overcast or the uniform
 * sky, and receivers that face up or are vertical. Vertical receivers need one diagram
 * for each direction that they face.
 */
#include <stdlib.h>

#include "methods/average/plane_light.h"
#include "methods/exact/direct.h"
#include "methods/method.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/refusals.h"
#include "methods/view/window_drawing.h"

/* The diagrams for points that face up; NULL if no opening needs one. */
struct pepper_pot_diagrams {
    struct pp_pepper_pot *unglazed, *glazed;
};

static void destroy_pepper_pot_tools(void *tools)
{
    struct pepper_pot_diagrams *diagrams = tools;
    if (diagrams) {
        pp_pepper_pot_dots_destroy(diagrams->unglazed);
        pp_pepper_pot_dots_destroy(diagrams->glazed);
    }
    free(diagrams);
}

static enum pp_status prepare_pepper_pot(void **tools, const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         struct pp_error *err)
{
    struct pepper_pot_diagrams *diagrams = calloc(1, sizeof *diagrams);
    if (!diagrams)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        bool glazed = world->openings[i].glass.panes > 0;
        struct pp_pepper_pot **pot = glazed ? &diagrams->glazed : &diagrams->unglazed;
        if (!*pot)
            status = pp_pepper_pot_dots_create(pot, &light->sky, glazed, false, 0.0,
                                               PP_PEPPER_POT_WORTH, err);
    }
    if (status != PP_OK)
        destroy_pepper_pot_tools(diagrams);
    else
        *tools = diagrams;
    return status;
}

static bool pane_is_upright(struct pp_vec3 normal)
{
    return fabs(normal.z) < 1e-9;
}

static const char *pepper_pot_refuses_room(const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receiver)
{
    if (!pp_sky_is_graded(&light->sky))
        return "valid only for the overcast and the uniform sky";
    if (receiver && !pane_is_upright(receiver->normal)
        && pp_refusals_unless_up(receiver))
        return "valid only for points that face up or horizontally";
    const char *why = pp_refusals_if_fine_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *pepper_pot_refuses(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass, but the diagram is for clear glass only";
    return pp_refusals_unless_vertical(opening);
}

/* Counts the dots of a diagram on sky and on obstructions. */
static void count_dots(struct pp_part *part, const struct pp_pepper_pot *pot,
                       const struct pp_window_drawing *drawing)
{
    pp_worksheet_put(&part->sheet, PP_UNIT_DAYLIGHT_FACTOR, pot->worth, "w",
                     "value of one dot");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, drawing->count);
    for (int i = 0; i < drawing->count; i++) {
        const struct pp_drawn_part *drawn = &drawing->parts[i];
        int dots = pp_pepper_pot_dots_count(pot, &drawn->region);
        *(drawn->hidden ? &part->external : &part->sky) +=
            pp_window_drawing_work(&terms, drawn, dots, "dots");
    }
    pp_part_steps_end(&terms);
}

static enum pp_status evaluate_pepper_pot(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver,
                                          const void *tools, struct pp_part *part,
                                          struct pp_error *err)
{
    const struct pepper_pot_diagrams *diagrams = tools;
    bool glazed = opening->glass.panes > 0;
    struct pp_window_drawing drawing;
    enum pp_status status = pp_window_drawing_init(&drawing, world, light, opening,
                                                   receiver->position, err);
    if (status != PP_OK)
        return status;
    if (pane_is_upright(receiver->normal)) {
        double facing = atan2(pp_vec_dot(receiver->normal, drawing.axes.along),
                              pp_vec_dot(receiver->normal, drawing.axes.out));
        struct pp_pepper_pot *pot;
        status = pp_pepper_pot_dots_create(&pot, &light->sky, glazed, true, facing,
                                           PP_PEPPER_POT_WORTH, err);
        if (status == PP_OK)
            count_dots(part, pot, &drawing);
        pp_pepper_pot_dots_destroy(pot);
    } else {
        count_dots(part, glazed ? diagrams->glazed : diagrams->unglazed, &drawing);
    }
    pp_window_drawing_clear(&drawing);
    return status;
}

/* The mean of many counts converges to the component itself, so an average over the
 * plane integrates the component instead of counting dots. */
static enum pp_status average_pepper_pot(struct pp_beams *beams,
                                         const struct pp_outside_light *light,
                                         const struct pp_opening *opening,
                                         const void *tools, struct pp_part *part,
                                         bool *known, struct pp_error *err)
{
    const struct pepper_pot_diagrams *diagrams = tools;
    const struct pp_glass *glass =
        opening->glass.panes > 0 ? &diagrams->glazed->glass : &opening->glass;
    double mean[2] = {0.0};
    *known = true;
    enum pp_status status =
        pp_plane_light_direct(mean, beams, light, opening, glass, err);
    part->sky = mean[0];
    part->external = mean[1];
    return status;
}

const struct pp_method pp_method_pepper_pot = {
    .name = "pepper-pot",
    .summary = "direct component by counting dots on a pepper-pot diagram",
    .source = "PLE54",
    .formulae = pp_window_drawing_formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .counts = true,
    .prepare = prepare_pepper_pot,
    .destroy_tools = destroy_pepper_pot_tools,
    .refuses_room = pepper_pot_refuses_room,
    .refuses = pepper_pot_refuses,
    .evaluate = evaluate_pepper_pot,
    .average = average_pepper_pot,
};
