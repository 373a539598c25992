/* protractor.c - `protractor`: direct component by the BRS daylight protractors
 * [BRE309].
 *
 * The opening is divided into rectangles of sky and of obstructions
 * (protractor_read.c). For each rectangle a user reads, in this order:
 *
 *   1. on the section, the primary scale at the upper and at the lower sight line;
 *      their difference is the initial component, that of an infinitely long opening
 *   2. the average altitude of both sight lines
 *   3. on the plan, the auxiliary scale at both jambs, between the semicircles for that
 *      altitude. The sum for jambs on both sides of the normal, else the difference, is
 *      the correction factor
 *   4. SC  = initial component x correction factor
 *      ERC = the obstruction's initial component x its correction factor x luminance
 *            factor (0.2 under the overcast sky for a reflectance of 0.2)
 *
 * Protractors 1 to 8 are for clear single glass at 90, 0, 30 and 60 degrees; 9 and 10
 * are for unglazed openings at any slope.
 */
#include <stdlib.h>

#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/part_steps.h"
#include "methods/protractor/protractor_read.h"

enum { GLAZED_90, GLAZED_0, GLAZED_30, GLAZED_60, BARE, DIALS };

/* Protractors needed for the room's openings, and the one for each opening; NULL: none
 * is suitable. */
struct dial_set {
    struct pp_protractor_dial *dials[DIALS];
    const struct pp_protractor_dial *of[];
};

static void destroy_protractor_tools(void *tools)
{
    struct dial_set *set = tools;
    if (!set)
        return;
    for (int i = 0; i < DIALS; i++)
        free(set->dials[i]);
    free(set);
}

/* The index of a protractor in the set. */
static int index_of(const struct pp_protractor *protractor)
{
    if (protractor->glass.panes == 0)
        return BARE;
    double slope_deg = protractor->slope_rad / PP_RAD;
    return slope_deg > 89.0   ? GLAZED_90
           : slope_deg > 59.0 ? GLAZED_60
           : slope_deg > 29.0 ? GLAZED_30
                              : GLAZED_0;
}

static enum pp_status prepare_protractor(void **tools, const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         struct pp_error *err)
{
    size_t openings = (size_t)world->opening_count;
    struct dial_set *set = calloc(1, sizeof *set + openings * sizeof *set->of);
    if (!set)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_protractor protractor;
        const struct pp_opening *opening = &world->openings[i];
        if (pp_protractor_read_choose(&protractor, &light->sky, opening, NULL) != PP_OK)
            continue;
        struct pp_protractor_dial **dial = &set->dials[index_of(&protractor)];
        if (!*dial) {
            *dial = malloc(sizeof **dial);
            if (!*dial) {
                destroy_protractor_tools(set);
                return pp_fail_memory(err);
            }
            pp_protractor_dial_init(*dial, &protractor);
        }
        set->of[i] = *dial;
    }
    *tools = set;
    return PP_OK;
}

static const char *protractor_refuses_room(const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receiver)
{
    if (!pp_sky_is_graded(&light->sky))
        return "valid only for the overcast and the uniform sky";
    const char *why = pp_refusals_unless_up(receiver);
    why = why ? why : pp_refusals_if_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *protractor_refuses(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver)
{
    (void)world, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass, but protractors are for clear glass only";
    struct pp_protractor protractor;
    if (pp_protractor_read_choose(&protractor, &light->sky, opening, NULL) != PP_OK)
        return "has a slope that no protractor covers; protractors cover 0, 30, 60 "
               "and 90 degrees";
    return NULL;
}

/* Records an angle and the reading of a scale at that angle. */
static void put_pair(struct pp_worksheet *sheet, double angle_rad,
                     enum pp_step_unit unit, double read, const char *symbol,
                     const char *what, const char *scale)
{
    pp_worksheet_note(sheet, PP_UNIT_ANGLE, angle_rad, "%s", what);
    pp_worksheet_put(sheet, unit, read, symbol, "%s", scale);
}

/* Records the readings of a rectangle. off_sky: the obstruction's equivalent sky
 * component is subtracted from the sky component. */
static void work_reading(struct pp_part_steps *terms, struct pp_part *sum,
                         const struct pp_protractor_reading *reading, bool off_sky)
{
    struct pp_worksheet *sheet = terms->sheet;
    bool hidden = reading->hidden;
    pp_part_steps_next(terms);
    put_pair(sheet, reading->edge_rad[1], PP_UNIT_DAYLIGHT_FACTOR, reading->share[1],
             "p_u",
             hidden ? "altitude of the upper edge of the obstruction"
                    : "altitude of the upper edge of the opening",
             "reading of the primary scale at this altitude");
    put_pair(sheet, reading->edge_rad[0], PP_UNIT_DAYLIGHT_FACTOR, reading->share[0],
             "p_l",
             hidden ? "altitude of the lower edge of the obstruction"
                    : "altitude of the lower edge of the opening",
             "reading of the primary scale at this altitude");
    pp_worksheet_work(sheet, &pp_protractor_read_initial,
                      "initial component, for an infinitely long opening");
    pp_worksheet_note(sheet, PP_UNIT_ANGLE, reading->average_rad,
                      "mean altitude of the upper and lower edges");
    put_pair(sheet, reading->jamb_rad[0], PP_UNIT_NUMBER, reading->correction[0], "k_l",
             "angle of the left jamb from the normal (positive to the right)",
             "reading of the auxiliary scale at this angle");
    put_pair(sheet, reading->jamb_rad[1], PP_UNIT_NUMBER, reading->correction[1], "k_r",
             "angle of the right jamb from the normal",
             "reading of the auxiliary scale at this angle");
    pp_worksheet_work(sheet,
                      reading->correction[1] < reading->correction[0]
                          ? &pp_protractor_read_no_width
                          : &pp_protractor_read_width,
                      "correction factor for the width");
    if (!hidden) {
        sum->sky +=
            pp_part_steps_work(terms, false, &pp_protractor_read_sc, "sky component");
        return;
    }
    pp_worksheet_work(sheet, &pp_protractor_read_e,
                      "equivalent sky component of the obstruction");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, reading->factor, "f",
                     "luminance factor of the obstruction");
    sum->external += pp_part_steps_work(terms, true, &pp_protractor_read_erc,
                                        "externally reflected component");
    if (off_sky)
        sum->sky += pp_part_steps_work(terms, false, &pp_protractor_read_less,
                                       "reduction of the sky component");
}

static const struct pp_formula *const formulae[] = {
    &pp_protractor_read_initial,  &pp_protractor_read_width,
    &pp_protractor_read_no_width, &pp_protractor_read_sc,
    &pp_protractor_read_e,        &pp_protractor_read_erc,
    &pp_protractor_read_less,     NULL};

static enum pp_status evaluate_protractor(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver,
                                          const void *tools, struct pp_part *part,
                                          struct pp_error *err)
{
    const struct dial_set *set = tools;
    const struct pp_protractor_dial *dial = set->of[opening - world->openings];
    if (!dial) {
        struct pp_protractor none;
        return pp_protractor_read_choose(&none, &light->sky, opening, err);
    }
    struct pp_protractor_readings readings;
    enum pp_status status = pp_protractor_read(&readings, dial, world, light, opening,
                                               receiver->position, err);
    if (status != PP_OK)
        return status;
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, readings.count);
    for (int i = 0; i < readings.count; i++)
        work_reading(&terms, part, &readings.list[i], readings.less_hidden);
    pp_part_steps_end(&terms);
    part->sky = fmax(part->sky, 0.0);
    pp_protractor_sheet_readings_clear(&readings);
    return PP_OK;
}

const struct pp_method pp_method_protractor = {
    .name = "protractor",
    .summary = "direct component by the BRS daylight protractors",
    .source = "BRE309",
    .formulae = formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .prepare = prepare_protractor,
    .destroy_tools = destroy_protractor_tools,
    .refuses_room = protractor_refuses_room,
    .refuses = protractor_refuses,
    .evaluate = evaluate_protractor,
};
