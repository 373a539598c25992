/* pepper_pot_sky.c - `pepper-pot-sky`: direct component by counting dots, for openings
 * of any slope, receivers of any kind and any sky [PLE54].
 *
 * The method is that of `pepper-pot`, but a diagram is made for the sky of the room
 * file (with the azimuth of its sun), the slope and direction of the opening, and the
 * receiver (pepper_pot_cloud.h). Each dot within the outline is worth 0.1 %:
 *
 *     SC  = dots on the sky x 0.1 %
 *     ERC = luminance factor x dots on obstructions x 0.1 %
 *
 * The method is for clear glass or none. The figures contain clear single glass.
 */
#include <stdlib.h>

#include "methods/average/plane_light.h"
#include "methods/exact/direct.h"
#include "methods/method.h"
#include "methods/pepper_pot/pepper_pot_cloud.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/refusals.h"
#include "methods/view/window_drawing.h"

/* The diagrams of each opening for points that face up. */
struct pepper_pot_clouds {
    int count;
    struct pp_pepper_pot_cloud list[];
};

static struct pp_glass glass_of(const struct pp_opening *opening)
{
    return opening->glass.panes > 0 ? pp_glass_clear_single() : opening->glass;
}

static void destroy_pepper_pot_sky_tools(void *tools)
{
    struct pepper_pot_clouds *clouds = tools;
    for (int i = 0; clouds && i < clouds->count; i++)
        pp_pepper_pot_cloud_clear(&clouds->list[i]);
    free(clouds);
}

static struct pp_window_axes axes_of(const struct pp_opening *opening)
{
    return (struct pp_window_axes){opening->along, opening->up,
                                   pp_vec_scale(opening->inner.normal, -1.0)};
}

static enum pp_status prepare_pepper_pot_sky(void **tools, const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             struct pp_error *err)
{
    size_t openings = (size_t)world->opening_count;
    struct pepper_pot_clouds *clouds =
        calloc(1, sizeof *clouds + openings * sizeof *clouds->list);
    if (!clouds)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (; clouds->count < world->opening_count && status == PP_OK; clouds->count++) {
        const struct pp_opening *opening = &world->openings[clouds->count];
        struct pp_glass glass = glass_of(opening);
        struct pp_window_axes axes = axes_of(opening);
        status = pp_pepper_pot_cloud_init(&clouds->list[clouds->count], &light->sky,
                                          &glass, &axes, pp_vec(0.0, 0.0, 1.0),
                                          PP_PEPPER_POT_WORTH, err);
    }
    if (status == PP_OK)
        *tools = clouds;
    else
        destroy_pepper_pot_sky_tools(clouds);
    return status;
}

static const char *pepper_pot_sky_refuses_room(const struct pp_world *world,
                                               const struct pp_outside_light *light,
                                               const struct pp_receiver *receiver)
{
    (void)light, (void)receiver;
    const char *why = pp_refusals_if_fine_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *pepper_pot_sky_refuses(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    return opening->glass.diffusing
               ? "has diffusing glass, but the diagram is for clear glass only"
               : NULL;
}

static void count_dots(struct pp_part *part, const struct pp_pepper_pot_cloud *cloud,
                       const struct pp_window_drawing *drawing)
{
    pp_worksheet_put(&part->sheet, PP_UNIT_DAYLIGHT_FACTOR, PP_PEPPER_POT_WORTH, "w",
                     "value of one dot");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, drawing->count);
    for (int i = 0; i < drawing->count; i++) {
        const struct pp_drawn_part *drawn = &drawing->parts[i];
        int dots = pp_pepper_pot_cloud_count(cloud, &drawn->region);
        *(drawn->hidden ? &part->external : &part->sky) +=
            pp_window_drawing_work(&terms, drawn, dots, "dots");
    }
    pp_part_steps_end(&terms);
}

static enum pp_status evaluate_pepper_pot_sky(const struct pp_world *world,
                                              const struct pp_outside_light *light,
                                              const struct pp_opening *opening,
                                              const struct pp_receiver *receiver,
                                              const void *tools, struct pp_part *part,
                                              struct pp_error *err)
{
    const struct pepper_pot_clouds *clouds = tools;
    struct pp_window_drawing drawing;
    enum pp_status status = pp_window_drawing_init(&drawing, world, light, opening,
                                                   receiver->position, err);
    if (status != PP_OK)
        return status;
    if (!pp_refusals_unless_up(receiver)) {
        count_dots(part, &clouds->list[opening - world->openings], &drawing);
    } else {
        struct pp_pepper_pot_cloud own;
        struct pp_glass glass = glass_of(opening);
        struct pp_window_axes axes = axes_of(opening);
        status = pp_pepper_pot_cloud_init(&own, &light->sky, &glass, &axes,
                                          receiver->normal, PP_PEPPER_POT_WORTH, err);
        if (status == PP_OK)
            count_dots(part, &own, &drawing);
        pp_pepper_pot_cloud_clear(&own);
    }
    pp_window_drawing_clear(&drawing);
    return status;
}

/* The mean of many counts converges to the component itself, which is integrated
 * instead. */
static enum pp_status average_pepper_pot_sky(struct pp_beams *beams,
                                             const struct pp_outside_light *light,
                                             const struct pp_opening *opening,
                                             const void *tools, struct pp_part *part,
                                             bool *known, struct pp_error *err)
{
    (void)tools;
    double mean[2] = {0.0};
    struct pp_glass glass = glass_of(opening);
    *known = true;
    enum pp_status status =
        pp_plane_light_direct(mean, beams, light, opening, &glass, err);
    part->sky = mean[0];
    part->external = mean[1];
    return status;
}

const struct pp_method pp_method_pepper_pot_sky = {
    .name = "pepper-pot-sky",
    .summary = "direct component by counting dots on a pepper-pot diagram generated "
               "for the sky, glass slope and receiver",
    .source = "PLE54",
    .formulae = pp_window_drawing_formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .counts = true,
    .prepare = prepare_pepper_pot_sky,
    .destroy_tools = destroy_pepper_pot_sky_tools,
    .refuses_room = pepper_pot_sky_refuses_room,
    .refuses = pepper_pot_sky_refuses,
    .evaluate = evaluate_pepper_pot_sky,
    .average = average_pepper_pot_sky,
};
