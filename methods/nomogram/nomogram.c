/* nomogram.c - `nomogram`: average internally reflected component, read with a
 * straight-edge on nomogram I, which `chart nomogram` prints.
 *
 *     A to B, read C;  C to D, read E                                 [GEEBELEN]
 *
 *   A  net glass area divided by the area of all inside surfaces
 *   B  mean reflectance of all inside surfaces (0.1 for openings)
 *   C  internally reflected component without an obstruction
 *   D  altitude of the obstruction from the middle of the opening
 *   E  internally reflected component with the obstruction
 *
 * The chart represents the formula of `bre`. The room's R_fw and R_cw are replaced by
 * the rule R_cw = 1.5 R_fw, R_fw = 0.8 R (nomogram_scale.c). Every value is set and
 * read to a fifth of a division of the chart on A4. Several openings are read one by
 * one, and the results are added.
 *
 * The method is for vertical openings under the CIE overcast sky, in rooms with a mean
 * reflectance of 0.1 to 0.9. The chart contains clear single glass and, through A, the
 * frame; no dirt, no deterioration of decorations.
 */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include "methods/method.h"
#include "methods/nomogram/nomogram_reading.h"
#include "methods/nomogram/nomogram_scale.h"
#include "methods/refusals.h"

static enum pp_status prepare_nomogram(void **tools, const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       struct pp_error *err)
{
    (void)world, (void)light;
    struct pp_nomogram *nomogram = malloc(sizeof *nomogram);
    if (!nomogram)
        return pp_fail_memory(err);
    *nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_AVERAGE);
    *tools = nomogram;
    return PP_OK;
}

static const char *nomogram_refuses_room(const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_formula_room(world, light, receiver);
    return why ? why : pp_nomogram_reading_refuses_room(world);
}

/* Records the quantities entered, set on the scales, and read. */
static void add_steps(struct pp_worksheet *sheet, const struct pp_nomogram *nomogram,
                      const struct pp_nomogram_reading *reading)
{
    struct pp_steps *steps = sheet->steps;
    const double *value = reading->value;
    char shift[32] = "", formula[32];
    if (reading->tens)
        snprintf(shift, sizeof shift, " %s %.0f", reading->tens > 0 ? "times" : "over",
                 pow(10.0, abs(reading->tens)));
    pp_steps_add_named(steps, PP_UNIT_NUMBER, nomogram->k, "k",
                       "ratio of R_cw to R_fw that the nomogram assumes");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, reading->glass_m2, "W",
                     "net glass area");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, reading->inside_m2, "S",
                     "area of all interior surfaces");
    pp_worksheet_work(sheet, &pp_nomogram_reading_ratio,
                      "ratio of the glass area to the area of all interior surfaces");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, value[PP_STEM_A], "A",
                       "scale A, set to this ratio%s", shift);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, value[PP_STEM_B], "B",
                       "scale B, set to the mean reflectance of all interior surfaces");
    pp_steps_add_named(steps, PP_UNIT_DAYLIGHT_FACTOR, value[PP_STEM_C], "C",
                       "scale C, read on the line from A to B, without obstruction");
    if (reading->used[1]) {
        pp_steps_add_named(steps, PP_UNIT_ANGLE, value[PP_STEM_D], "D",
                           "scale D, set to the altitude of the obstruction");
        pp_steps_add_named(steps, PP_UNIT_DAYLIGHT_FACTOR, value[PP_STEM_E], "E",
                           "scale E, read on the line from C to D, with obstruction");
    }
    snprintf(formula, sizeof formula, "%c %s %.0f", reading->used[1] ? 'E' : 'C',
             reading->tens > 0 ? "/" : "*", pow(10.0, abs(reading->tens)));
    if (reading->tens)
        pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, reading->component, "IRC",
                            formula,
                            "average internally reflected component, corrected for the "
                            "shift of scale A");
}

static const struct pp_formula *const formulae[] = {&pp_nomogram_reading_ratio, NULL};

static enum pp_status evaluate_nomogram(const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        const struct pp_receiver *receiver,
                                        const void *tools, struct pp_part *part,
                                        struct pp_error *err)
{
    (void)receiver;
    const struct pp_nomogram *nomogram = tools;
    struct pp_nomogram_reading reading;
    enum pp_status status =
        pp_nomogram_reading_of_opening(&reading, nomogram, world, light, opening, err);
    if (status != PP_OK)
        return status;
    part->value = reading.component;
    if (part->sheet.steps)
        add_steps(&part->sheet, nomogram, &reading);
    return PP_OK;
}

const struct pp_method pp_method_nomogram = {
    .name = "nomogram",
    .summary = "average internally reflected component, read from a nomogram",
    .source = "GEEBELEN",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .own_ground = 0.1, /* as in `bre` */
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = nomogram_refuses_room,
    .refuses = pp_refusals_sloping_opening,
    .prepare = prepare_nomogram,
    .destroy_tools = free,
    .evaluate = evaluate_nomogram,
};
