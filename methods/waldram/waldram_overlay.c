/* waldram_overlay.c - `waldram-overlay`: direct component by counting squares on
 * Waldram's diagram without glass [WW23], under an overlay of the glass.
 *
 * Squares without glass are exact at any slope of the opening. The transmittance of
 * glass depends on altitude and azimuth together, so that a diagram that includes it
 * has equal squares for horizontal glass only. The overlay shows the transmittance of
 * the glass, at its slope and in its direction, over the diagram; each square is
 * weighted by the value at its middle:
 *
 *     SC  = sum over the squares of sky, part x tau(i) x 0.1 %
 *     ERC = luminance factor x the same over the squares of obstruction
 *
 * The method is for skies without azimuth dependence, points that face up, and clear
 * glass of any slope and type, or none. The figures contain the opening's own glass.
 */
#include <stdlib.h>

#include "methods/average/plane_light.h"
#include "methods/exact/direct.h"
#include "methods/method.h"
#include "methods/interpolate.h"
#include "methods/refusals.h"
#include "methods/view/window_drawing.h"
#include "methods/waldram/waldram_squares.h"
#include "model/geometry/angle.h"

static const struct pp_formula_quantity of_squares[] = {
    {"n", PP_UNIT_COUNT, "squares counted"},
    {"tau", PP_UNIT_NUMBER, "mean transmittance of the glass over these squares"},
    {"w", PP_UNIT_DAYLIGHT_FACTOR, "value of one square"},
    {"f", PP_UNIT_NUMBER, "luminance factor of the obstruction"},
    {0},
};
static const struct pp_formula sky_component = {.symbol = "sc",
                                                .sum = "n tau w",
                                                .unit = PP_UNIT_DAYLIGHT_FACTOR,
                                                .what = "sky component",
                                                .quantities = of_squares,
                                                .fixed = true};
static const struct pp_formula external_component = {
    .symbol = "erc",
    .sum = "f n tau w",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "externally reflected component",
    .quantities = of_squares,
    .fixed = true};
static const struct pp_formula *const formulae[] = {&sky_component, &external_component,
                                                    NULL};

/* The diagram without glass, and the altitude at the middle of each row of its
 * squares. */
enum { MOST_ROWS = 64 }; /* an upper bound: diagrams have 14 */
struct overlay {
    struct pp_waldram waldram;
    double width, height; /* size of a square on the diagram */
    int rows;
    struct pp_angle altitudes[MOST_ROWS];
};

static void place_rows(struct overlay *overlay)
{
    const double *y = overlay->waldram.y, top = y[PP_WALDRAM_PANELS];
    pp_waldram_squares_size(&overlay->waldram, &overlay->width, &overlay->height);
    overlay->rows = (int)fmin(ceil(top / overlay->height), MOST_ROWS);
    for (int row = 0; row < overlay->rows; row++) {
        double altitude =
            pp_interpolate_inverse(y, PP_WALDRAM_PANELS + 1, 0.0, PP_PI / 2.0,
                                   fmin((row + 0.5) * overlay->height, top));
        overlay->altitudes[row] = pp_angle_of(altitude);
    }
}

static enum pp_status prepare_waldram_overlay(void **tools,
                                              const struct pp_world *world,
                                              const struct pp_outside_light *light,
                                              struct pp_error *err)
{
    (void)world;
    struct overlay *overlay = malloc(sizeof *overlay);
    if (!overlay)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_waldram_scale_init(&overlay->waldram, &light->sky, false, err);
    if (status != PP_OK) {
        free(overlay);
        return status;
    }
    place_rows(overlay);
    *tools = overlay;
    return PP_OK;
}

static const char *waldram_overlay_refuses(const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_opening *opening,
                                           const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    return opening->glass.diffusing
               ? "has diffusing glass, but the overlay is for clear glass only"
               : NULL;
}

/* Transmittance at the middle of the square of a row in the column at an azimuth; `out`
 * is the direction of the glass in the diagram's axes. */
static double transmittance_at(const struct overlay *overlay,
                               const struct pp_glass *glass, struct pp_vec3 out,
                               struct pp_angle azimuth, int row)
{
    const struct pp_angle *altitude =
        &overlay->altitudes[row < overlay->rows ? row : overlay->rows - 1];
    struct pp_vec3 u = pp_vec(altitude->cosine * azimuth.sine,
                              altitude->cosine * azimuth.cosine, altitude->sine);
    double cosine = fmin(pp_vec_dot(u, out), 1.0);
    return cosine > 0.0 ? pp_glass_transmittance(glass, cosine) : 0.0;
}

static double mean_transmittance(const struct overlay *overlay,
                                 const struct pp_glass *glass,
                                 const struct pp_window_axes *axes,
                                 const struct pp_waldram_count *count)
{
    const double straight[2] = {0.0, 0.0};
    struct pp_vec3 out = pp_waldram_scale_direction(&overlay->waldram, axes, straight);
    double sum = 0.0;
    if (glass->panes == 0 || !(count->squares > 0.0))
        return 1.0;
    struct pp_angle azimuth = {0.0, 1.0};
    for (int i = 0; i < count->count; i++) { /* column by column */
        const struct pp_waldram_square *square = &count->list[i];
        if (i == 0 || square->column != square[-1].column)
            azimuth = pp_angle_of((square->column + 0.5) * overlay->width);
        sum += square->estimated
               * transmittance_at(overlay, glass, out, azimuth, square->row);
    }
    return sum / count->squares;
}

static double squares_worked(struct pp_part_steps *terms,
                             const struct pp_drawn_part *part, double squares,
                             double tau)
{
    pp_part_steps_next(terms);
    pp_worksheet_put(terms->sheet, PP_UNIT_COUNT, squares, "n", "squares on %s",
                     part->hidden ? "an obstruction" : "the sky");
    pp_worksheet_put(terms->sheet, PP_UNIT_NUMBER, tau, "tau",
                     "mean transmittance of the glass over these squares");
    pp_worksheet_know(terms->sheet, PP_UNIT_NUMBER, part->factor, "f");
    if (!part->hidden)
        return pp_part_steps_work(terms, false, &sky_component, "sky component");
    pp_worksheet_put(terms->sheet, PP_UNIT_NUMBER, part->factor, "f",
                     "luminance factor of the obstruction");
    return pp_part_steps_work(terms, true, &external_component,
                              "externally reflected component");
}

static enum pp_status evaluate_waldram_overlay(const struct pp_world *world,
                                               const struct pp_outside_light *light,
                                               const struct pp_opening *opening,
                                               const struct pp_receiver *receiver,
                                               const void *tools, struct pp_part *part,
                                               struct pp_error *err)
{
    const struct overlay *overlay = tools;
    struct pp_window_drawing drawing;
    enum pp_status status = pp_window_drawing_init(&drawing, world, light, opening,
                                                   receiver->position, err);
    if (status != PP_OK)
        return status;
    pp_worksheet_put(&part->sheet, PP_UNIT_DAYLIGHT_FACTOR, PP_WALDRAM_WORTH, "w",
                     "value of one square without glass");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, drawing.count);
    for (int i = 0; i < drawing.count; i++) {
        const struct pp_drawn_part *drawn = &drawing.parts[i];
        struct pp_waldram_count count;
        status = pp_waldram_squares_count(&count, &overlay->waldram, &drawing.axes,
                                          &drawn->region, err);
        if (status != PP_OK)
            break;
        double tau =
            mean_transmittance(overlay, &opening->glass, &drawing.axes, &count);
        *(drawn->hidden ? &part->external : &part->sky) +=
            squares_worked(&terms, drawn, count.squares, tau);
        pp_waldram_squares_clear(&count);
    }
    pp_part_steps_end(&terms);
    pp_window_drawing_clear(&drawing);
    return status;
}

/* The mean of many counts converges to the component itself, which is integrated
 * instead. */
static enum pp_status average_waldram_overlay(struct pp_beams *beams,
                                              const struct pp_outside_light *light,
                                              const struct pp_opening *opening,
                                              const void *tools, struct pp_part *part,
                                              bool *known, struct pp_error *err)
{
    (void)tools;
    double mean[2] = {0.0};
    *known = true;
    enum pp_status status =
        pp_plane_light_direct(mean, beams, light, opening, &opening->glass, err);
    part->sky = mean[0];
    part->external = mean[1];
    return status;
}

static const char *waldram_overlay_refuses_room(const struct pp_world *world,
                                                const struct pp_outside_light *light,
                                                const struct pp_receiver *receiver)
{
    return pp_method_waldram.refuses_room(world, light, receiver);
}

const struct pp_method pp_method_waldram_overlay = {
    .name = "waldram-overlay",
    .summary = "direct component by counting squares on a Waldram diagram with an "
               "overlay for the glass",
    .source = "WW23",
    .formulae = formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS,
    .counts = true,
    .prepare = prepare_waldram_overlay,
    .destroy_tools = free,
    .refuses_room = waldram_overlay_refuses_room,
    .refuses = waldram_overlay_refuses,
    .evaluate = evaluate_waldram_overlay,
    .average = average_waldram_overlay,
};
