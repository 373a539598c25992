/* split_flux_atlas.c - `split-flux-atlas`: the split-flux formula
 * (reflected/split_flux.c) with corrections fitted to simulated rooms [ATLAS]: for
 * obstructions and the visible ground, for light lost in openings, for glass below the
 * working plane, and for position.
 *
 *   1 - R^2   in place of 1 - rho_u rho_l: interreflected light is also lost in
 *             openings, which R includes; A/2 in place of A_u and A_l
 *   n         fraction of the opening below the working plane; its light falls on
 *             surfaces that points on the plane do not see
 *
 * In the limit R to 1 (a furnace) the formula is the energy balance tau Ag (V + C_g)/(A
 * (1 - R)) under an open sky, for any fitted constants. f_d and f_s are defined in
 * fitted_position.h. The method is for vertical openings of clear glass under the CIE
 * overcast sky, and for points that face up. Allowances are those of `split-flux`.
 */
#include <stdlib.h>

#include "methods/allowance.h"
#include "methods/fitted/fitted_constants.h"
#include "methods/fitted/fitted_light.h"
#include "methods/fitted/fitted_opening.h"
#include "methods/fitted/fitted_parts.h"
#include "methods/fitted/fitted_position.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity quantities[] = {
    {"tau", PP_UNIT_NUMBER, "diffuse transmittance of the glass (1 if unglazed)"},
    {"Ag", PP_UNIT_SQUARE_METRE, "net glass area: opening area times frame factor"},
    PP_INTERIOR_QUANTITIES,
    PP_FITTED_PARTS_QUANTITIES,
    PP_FITTED_LIGHT_QUANTITIES,
    PP_FITTED_OPENING_LOW,
    PP_FITTED_POSITION_QUANTITIES,
    {"irc_m", PP_UNIT_DAYLIGHT_FACTOR,
     "mean internally reflected component over the working plane"},
    {0},
};

static const struct pp_formula mean = {
    .symbol = "irc_m",
    .sum = "2 tau Ag / (A (1 - R^2)) (rho_u E_g + rho_u rho_l (V + E_b)) "
           "exp(-" PP_FITTED_FLUX_LOW " (1 - R) n)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "mean internally reflected component",
    .quantities = quantities,
};

static const struct pp_formula at_point = {
    .symbol = "irc",
    .sum = "irc_m f_d f_s",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "internally reflected component at the point",
    .quantities = quantities,
};

static const struct pp_formula *const formulae[] = {&pp_allowance_glass_Ag,
                                                    PP_FITTED_LIGHT_FORMULAE,
                                                    PP_FITTED_POSITION_FORMULAE,
                                                    &mean,
                                                    &at_point,
                                                    NULL};

static enum pp_status evaluate_split_flux_atlas(const struct pp_world *world,
                                                const struct pp_outside_light *light,
                                                const struct pp_opening *opening,
                                                const struct pp_receiver *receiver,
                                                const void *tools, struct pp_part *part,
                                                struct pp_error *err)
{
    (void)light, (void)err;
    struct pp_worksheet *sheet = &part->sheet;
    const struct pp_fitted_light *on =
        (const struct pp_fitted_light *)tools + (opening - world->openings);
    pp_allowance_net_glass(sheet, &pp_allowance_glass_Ag, opening);
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "tau",
                     "diffuse transmittance of the glass");
    pp_fitted_light_put(sheet, tools, world, opening);
    pp_interior_put(sheet, &on->all);
    pp_fitted_parts_put(sheet, tools, world, opening);
    pp_fitted_opening_put_low(sheet, world, opening);
    if (receiver) {
        pp_fitted_position_put_room(sheet, world, opening);
        pp_fitted_opening_put_breadth(sheet, opening);
    }
    part->value =
        pp_fitted_position_work(sheet, &mean, &at_point, world, opening, receiver);
    return PP_OK;
}

const struct pp_method pp_method_split_flux_atlas = {
    .name = "split-flux-atlas",
    .summary = "internally reflected component by position, by the split-flux formula "
               "corrected to match simulated rooms",
    .source = "ATLAS",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_POINT,
    .has_average = true,
    .of_real_room = true,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_fitted_parts_refuses,
    .refuses_alike = true,
    .prepare = pp_fitted_light_prepare,
    .destroy_tools = free,
    .evaluate = evaluate_split_flux_atlas,
};
