/* bre_min.c - `bre-min`: minimum internally reflected component in the room: the
 * average by `bre`, divided by a factor k for the walls [BRE310].
 *
 * k is published for walls with a mean reflectance of 0.2, 0.4, 0.6 and 0.8. Between
 * these values k is interpolated linearly; outside them k is the value at the nearer
 * end. The minimum is therefore too high for walls darker than 0.2 and too low for
 * walls lighter than 0.8: the more evenly light is spread, the nearer the minimum is to
 * the average. The mean is over all walls, without their openings.
 *
 * The minimum is at the point farthest from the windows. The method is published for
 * rooms with windows in one wall that are at most twice as long as wide. The minimum is
 * a lower bound for each point, not an average. Scope and allowances are those of
 * `bre`.
 */
#include <stddef.h>

#include "methods/reflected/bre_terms.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/irc_minimum.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity quantities[] = {
    {"IRC_av", PP_UNIT_DAYLIGHT_FACTOR, "average internally reflected component"},
    {"R_w", PP_UNIT_NUMBER, "mean reflectance of the walls"},
    {"k", PP_UNIT_NUMBER,
     "ratio of the average to the minimum for this wall reflectance, from the table"},
    {0},
};

static const struct pp_formula minimum = {
    .symbol = "irc",
    .sum = "IRC_av / k",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "BRE310",
    .what = "minimum internally reflected component",
    .quantities = quantities,
};

static const struct pp_formula *const formulae[] = {
    &pp_allowance_glass_W, &pp_bre_terms_IRC_av, &minimum, NULL};

static enum pp_status evaluate_bre_min(const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_bre_terms terms;
    enum pp_status status = pp_bre_terms(&terms, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_bre_terms_work(&part->sheet, &pp_bre_terms_IRC_av, &terms, opening);
    double walls = pp_interior_role(world, PP_WALL).reflectance;
    pp_worksheet_put(&part->sheet, PP_UNIT_NUMBER, walls, "R_w",
                     "mean reflectance of the walls");
    pp_worksheet_put(
        &part->sheet, PP_UNIT_NUMBER, pp_irc_minimum_average_ratio(walls), "k",
        "ratio of the average to the minimum for this wall reflectance, from the "
        "table");
    part->value = pp_worksheet_work(&part->sheet, &minimum,
                                    "minimum internally reflected component");
    return PP_OK;
}

const struct pp_method pp_method_bre_min = {
    .name = "bre-min",
    .summary = "minimum internally reflected component: the average from bre, divided "
               "by a published ratio",
    .source = "BRE310",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .own_ground = PP_BRE_GROUND_REFLECTANCE,
    .speaks_for = PP_FOR_MINIMUM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate_bre_min,
};
