/* arndt.c - `arndt`: average internally reflected component, with the room treated as
 * one surface of one reflectance.
 *
 * The oldest of the room formulae [ARN38], as quoted in the literature on daylight; the
 * original text was not available. All entering light is first reflected with the mean
 * reflectance R, wherever it falls; further reflections are as in an integrating
 * sphere. `sphere` and `bre` refine this formula: their first reflection depends on the
 * part of the room on which the light falls. The method is for any sky, any slope and
 * any number of openings, whose results are added. Diffusing panes need no special
 * treatment, since the place where light falls does not matter.
 *
 * The formula contains the opening's glass and, through Ag, the frame; no dirt, no
 * deterioration of decorations.
 */
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity quantities[] = {
    PP_ENTERING_LIGHT_QUANTITIES, PP_INTERIOR_QUANTITIES, {0}};

static const struct pp_formula average = {
    .symbol = "irc",
    .sum = "tau Ag (C + C_g) R / (A (1 - R))",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ARN38",
    .what = "average internally reflected component",
    .quantities = quantities,
};

static const struct pp_formula *const formulae[] = {
    PP_ENTERING_LIGHT_FORMULAE, &average, PP_ENTERING_LIGHT_WELL_FORMULAE, NULL};

static enum pp_status evaluate_arndt(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     const void *tools, struct pp_part *part,
                                     struct pp_error *err)
{
    (void)receiver, (void)tools;
    enum pp_status status = pp_entering_light(&part->sheet, world, light, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_interior all = pp_interior_all(world);
    pp_interior_put(&part->sheet, &all);
    double irc = pp_worksheet_work(&part->sheet, &average,
                                   "average internally reflected component");
    part->value = pp_entering_light_of_well(&part->sheet, &pp_entering_light_E_w, world,
                                            opening, irc);
    return PP_OK;
}

const struct pp_method pp_method_arndt = {
    .name = "arndt",
    .summary =
        "average internally reflected component from a single mean reflectance of the "
        "room",
    .source = "ARN38",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_luminous_room,
    .evaluate = evaluate_arndt,
};
