/* protractor.c - `protractor`: direct component by the BRS daylight protractors
 * [BRE309].
 *
 * Of each rectangle of sky or obstruction in an opening (protractor_read.c) a user
 * reads, in this order:
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
#include "methods/protractor.h"

#include <stdlib.h>

#include "methods/methods.h"
#include "methods/refusals.h"

enum { GLAZED_90, GLAZED_0, GLAZED_30, GLAZED_60, BARE, DIALS };

/* The protractors that the room's openings need. */
struct box {
    struct pp_dial *dials[DIALS];
};

static void put_away(void *tools)
{
    struct box *box = tools;
    if (!box)
        return;
    for (int i = 0; i < DIALS; i++)
        free(box->dials[i]);
    free(box);
}

/* Which of the box an opening is read with, by the protractor made for it. */
static int place_of(const struct pp_protractor *protractor)
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
    struct box *box = calloc(1, sizeof *box);
    if (!box)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_protractor protractor;
        const struct pp_opening *opening = &world->openings[i];
        if (pp_protractor_for(&protractor, &world->sky, opening, NULL) != PP_OK)
            continue;
        struct pp_dial **dial = &box->dials[place_of(&protractor)];
        if (*dial)
            continue;
        *dial = malloc(sizeof **dial);
        if (!*dial) {
            put_away(box);
            return pp_fail_memory(err);
        }
        pp_dial_make(*dial, &protractor);
    }
    *tools = box;
    return PP_OK;
}

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    if (world->sky.kind == PP_SKY_ISO)
        return "there are protractors for the overcast and the uniform sky only";
    const char *why = pp_refuse_unless_up(receiver);
    return why ? why : pp_refuse_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass; there are protractors for clear glass only";
    struct pp_protractor protractor;
    if (pp_protractor_for(&protractor, &world->sky, opening, NULL) != PP_OK)
        return "has glass at a slope without a protractor; there are some for 0, 30, "
               "60 and 90 degrees";
    return NULL;
}

static void set_down(struct pp_steps *steps, int line,
                     const struct pp_protractor_reading *reading)
{
    const char *what = reading->hidden ? "obstruction" : "opening";
    static const char *const edge[] = {"lower", "upper"};
    static const char *const side[] = {"left", "right"};
    for (int i = 1; i >= 0; i--) {
        pp_step(steps, PP_UNIT_ANGLE, reading->edge_rad[i],
                "opening on line %d: %s, %s edge: altitude", line, what, edge[i]);
        pp_step(steps, PP_UNIT_SHARE, reading->share[i], "primary scale there");
    }
    pp_step(steps, PP_UNIT_SHARE, reading->initial,
            "their difference: initial component");
    pp_step(steps, PP_UNIT_ANGLE, reading->average_rad, "average altitude");
    for (int i = 0; i < 2; i++) {
        pp_step(steps, PP_UNIT_ANGLE, reading->jamb_rad[i],
                "%s jamb from the normal, to the right positive", side[i]);
        pp_step(steps, PP_UNIT_NUMBER, reading->correction[i], "auxiliary scale there");
    }
    pp_step(steps, PP_UNIT_NUMBER, reading->width_factor,
            "right less left: correction factor");
    if (reading->hidden)
        pp_step(steps, PP_UNIT_NUMBER, reading->factor,
                "luminance factor of the obstruction");
    pp_step(steps, PP_UNIT_SHARE, reading->component, "%s",
            reading->hidden ? "externally reflected component" : "sky component");
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    const struct box *box = tools;
    struct pp_protractor protractor;
    enum pp_status status = pp_protractor_for(&protractor, &world->sky, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_protractor_readings readings;
    status = pp_protractor_read(&readings, box->dials[place_of(&protractor)], world,
                                opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    part->sky = readings.sky;
    part->external = readings.external;
    for (int i = 0; i < readings.count; i++)
        set_down(part->steps, opening->line, &readings.list[i]);
    if (readings.less_hidden)
        pp_step(part->steps, PP_UNIT_SHARE, readings.sky,
                "sky component, less that of what is hidden");
    pp_protractor_readings_clear(&readings);
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
    .put_away = put_away,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
