/* protractor.c - `protractor`: direct component by the BRS daylight protractors
 * [BRE309].
 *
 * The opening is divided into rectangles of sky and of obstructions
 * (protractor_read.c). For each rectangle a user reads, in this order:
 *
 *   1. on the section, the primary scale at the upper and at the lower sight line;
 *      their difference is the component of an endless opening
 *   2. the average altitude of both sight lines
 *   3. on the plan, the auxiliary scale at both jambs, between the semicircles for that
 *      altitude: added for jambs on both sides of the normal, else subtracted
 *   4. SC  = initial component x that correction factor
 *      ERC = the obstruction's initial component x its correction factor x luminance
 *            factor (0.2 under the overcast sky for a reflectance of 0.2)
 *
 * Protractors 1 to 8 contain clear single glass, at 90, 0, 30 and 60 degrees; 9 and 10
 * are for unglazed openings at any slope.
 */
#include <stdio.h>
#include <stdlib.h>

#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/part_steps.h"
#include "methods/protractor/protractor_read.h"

enum { GLAZED_90, GLAZED_0, GLAZED_30, GLAZED_60, BARE, DIALS };

/* The protractors that the room's openings need. */
struct dial_set {
    struct pp_protractor_dial *dials[DIALS];
};

static void destroy_tools(void *tools)
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

static enum pp_status prepare(void **tools, const struct pp_world *world,
                              struct pp_error *err)
{
    struct dial_set *set = calloc(1, sizeof *set);
    if (!set)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_protractor protractor;
        const struct pp_opening *opening = &world->openings[i];
        if (pp_protractor_read_choose(&protractor, &world->sky, opening, NULL) != PP_OK)
            continue;
        struct pp_protractor_dial **dial = &set->dials[index_of(&protractor)];
        if (*dial)
            continue;
        *dial = malloc(sizeof **dial);
        if (!*dial) {
            destroy_tools(set);
            return pp_fail_memory(err);
        }
        pp_protractor_dial_init(*dial, &protractor);
    }
    *tools = set;
    return PP_OK;
}

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    if (world->sky.kind == PP_SKY_ISO)
        return "there are protractors for the overcast and the uniform sky only";
    const char *why = pp_refusals_unless_up(receiver);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass; there are protractors for clear glass only";
    struct pp_protractor protractor;
    if (pp_protractor_read_choose(&protractor, &world->sky, opening, NULL) != PP_OK)
        return "has glass at a slope without a protractor; there are some for 0, 30, "
               "60 and 90 degrees";
    return NULL;
}

/* Records an angle and the reading of a scale at that angle. */
static void add_pair_steps(const struct pp_part_steps *terms, double angle_rad,
                           enum pp_step_unit unit, double read, const char *symbol,
                           const char *what, const char *scale)
{
    pp_steps_add(terms->steps, PP_UNIT_ANGLE, angle_rad, "%s", what);
    pp_steps_add_named(terms->steps, unit, read,
                       pp_part_steps_symbol(terms, symbol).text, "%s", scale);
}

/* off_sky: the obstruction's equivalent sky component is subtracted from the sky's. */
static void add_reading_steps(struct pp_part_steps *terms,
                              const struct pp_protractor_reading *reading, bool off_sky)
{
    pp_part_steps_next(terms);
    const char *of = reading->hidden ? "obstruction" : "opening";
    char upper[48], lower[48];
    snprintf(upper, sizeof upper, "%s, upper edge: altitude", of);
    snprintf(lower, sizeof lower, "%s, lower edge: altitude", of);
    add_pair_steps(terms, reading->edge_rad[1], PP_UNIT_SHARE, reading->share[1], "p_u",
                   upper, "primary scale there");
    add_pair_steps(terms, reading->edge_rad[0], PP_UNIT_SHARE, reading->share[0], "p_l",
                   lower, "primary scale there");
    pp_part_steps_figure(terms, PP_UNIT_SHARE, reading->initial, "i", "p_u# - p_l#",
                         "initial component, of an endless opening");
    pp_steps_add(terms->steps, PP_UNIT_ANGLE, reading->average_rad,
                 "average altitude of both edges");
    add_pair_steps(terms, reading->jamb_rad[0], PP_UNIT_NUMBER, reading->correction[0],
                   "k_l", "left jamb from the normal, right is positive",
                   "auxiliary scale there");
    add_pair_steps(terms, reading->jamb_rad[1], PP_UNIT_NUMBER, reading->correction[1],
                   "k_r", "right jamb from the normal", "auxiliary scale there");
    pp_part_steps_figure(terms, PP_UNIT_NUMBER, reading->width_factor, "K",
                         reading->correction[1] < reading->correction[0]
                             ? "max(k_r# - k_l#, 0)"
                             : "k_r# - k_l#",
                         "correction factor for the width");
    if (!reading->hidden) {
        pp_part_steps_component(terms, false, reading->component, "i# K#",
                                "sky component");
        return;
    }
    pp_part_steps_figure(terms, PP_UNIT_SHARE, reading->initial * reading->width_factor,
                         "e", "i# K#", "equivalent sky component of the obstruction");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, reading->factor, "f",
                       "luminance factor of the obstruction");
    pp_part_steps_component(terms, true, reading->component, "f# e#",
                            "externally reflected component");
    if (off_sky)
        pp_part_steps_component(terms, false, -reading->initial * reading->width_factor,
                                "-e#", "taken off the sky component");
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    const struct dial_set *set = tools;
    struct pp_protractor protractor;
    enum pp_status status =
        pp_protractor_read_choose(&protractor, &world->sky, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_protractor_readings readings;
    status = pp_protractor_read(&readings, set->dials[index_of(&protractor)], world,
                                opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    part->sky = readings.sky;
    part->external = readings.external;
    struct pp_part_steps terms = pp_part_steps_begin(part->steps, readings.count);
    for (int i = 0; i < readings.count; i++)
        add_reading_steps(&terms, &readings.list[i], readings.less_hidden);
    pp_part_steps_end(&terms);
    pp_protractor_sheet_readings_clear(&readings);
    return PP_OK;
}

const struct pp_method pp_method_protractor = {
    .name = "protractor",
    .summary = "direct component by the BRS daylight protractors",
    .source = "BRE309",
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .prepare = prepare,
    .destroy_tools = destroy_tools,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
