/* irc_atlas.c - `irc-atlas`: internally reflected component at a point, by a hand
 * formula of six terms whose constants were fitted to simulated rooms [ATLAS].
 *
 *     L   = ((V + E_b) rho_l + E_g) sqrt(rho_u) ((A_l / A_u)^c exp(-e d (1/w + 1/h)))^(1 - R)
 *     irc = tau Ag L / (A (1 - R)) f_d f_s
 *
 *   E_b, E_g           light from obstructions and from the ground (fitted_light.h)
 *   (A_l / A_u)^c      a low opening lights less of the room above the working plane
 *   exp(-e d ...)      light lost in the reveal
 *   f_d, f_s           for the point's depth and sideways position (fitted_position.h)
 *
 * Light from the sky falls on the lower part of the room and is reflected by it and by
 * the upper part before it reaches the working plane; light from the ground is
 * reflected by the upper part only. The second line is the formula of `sphere` with the
 * light outside separated by source (fitted_light.h) and the square root of rho_u
 * (fitted exponent 0.51). The six fitted terms have one constant each. In the limit R
 * to 1 under an open sky (a furnace) the formula is the energy balance tau Ag (V +
 * C_g)/(A (1 - R)) everywhere, for any fitted constants. Without openings, with a black
 * upper part or in an infinitely deep room the component is 0.
 *
 * The method is for vertical openings of clear glass under the CIE overcast sky, and
 * for points that face up. The formula contains the opening's glass and, through Ag,
 * the frame; no dirt, no deterioration of decorations.
 */
#include "methods/fitted/irc_atlas.h"

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
    PP_FITTED_OPENING_REVEAL,
    PP_FITTED_POSITION_QUANTITIES,
    {"L", PP_UNIT_DAYLIGHT_FACTOR, "effective illuminance on the opening"},
    {"irc_m", PP_UNIT_DAYLIGHT_FACTOR,
     "mean internally reflected component over the working plane"},
    {0},
};

const struct pp_formula pp_irc_atlas_light = {
    .symbol = "L",
    .sum = "((V + E_b) rho_l + E_g) sqrt(rho_u) "
           "((A_l / A_u)^" PP_FITTED_PARTS " exp(-" PP_FITTED_REVEAL
           " d (1 / w + 1 / h)))^(1 - R)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "effective illuminance on the opening",
    .quantities = quantities,
};

static const struct pp_formula mean = {
    .symbol = "irc_m",
    .sum = "tau Ag L / (A (1 - R))",
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
                                                    &pp_irc_atlas_light,
                                                    &mean,
                                                    &at_point,
                                                    NULL};

static enum pp_status evaluate_irc_atlas(const struct pp_world *world,
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
    pp_fitted_opening_put_reveal(sheet, opening);
    pp_worksheet_work(sheet, &pp_irc_atlas_light,
                      "effective illuminance on the opening");
    if (receiver)
        pp_fitted_position_put_room(sheet, world, opening);
    part->value =
        pp_fitted_position_work(sheet, &mean, &at_point, world, opening, receiver);
    return PP_OK;
}

const struct pp_method pp_method_irc_atlas = {
    .name = "irc-atlas",
    .summary = "internally reflected component by position, by a formula fitted to "
               "simulated rooms",
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
    .evaluate = evaluate_irc_atlas,
};
