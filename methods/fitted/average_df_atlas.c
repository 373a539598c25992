/* average_df_atlas.c - `average-df-atlas`: the average daylight factor by a single
 * formula (average_df.c), with corrections fitted to simulated rooms [ATLAS].
 *
 *     df = k T W (1 - n + n rho_f) M / (A (1 - R^2)) 2 E
 *          exp(-e d (1/w + 1/h)) (A / A_f)^c exp(-g E_u)
 *
 * theta is replaced by twice the light on the opening's outside, E = V + E_b + E_g
 * (fitted_light.h): 2 E is 90 % under an open sky with a ground of reflectance 0.1,
 * just as theta is 90 degrees in the printed formula. The depth of the reveal enters as
 * an exponential, the floor's share of the room's surfaces as a power. Light from the
 * ground has less effect, since it falls on the ceiling first. E_u is the fraction of
 * the light that comes from the ground, C_g / (V + C_b + C_g). The fraction n of the
 * opening below the working plane is weighted by the floor's reflectance.
 *
 * The method is for vertical openings of clear glass under the CIE overcast sky. The
 * formula contains the opening's glass, the frame and dirt.
 */
#include <stdlib.h>

#include "methods/allowance.h"
#include "methods/fitted/fitted_constants.h"
#include "methods/fitted/fitted_light.h"
#include "methods/fitted/fitted_opening.h"
#include "methods/method.h"
#include "methods/reflected/interior.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity quantities[] = {
    {"T", PP_UNIT_NUMBER, "diffuse transmittance of the glass (1 if unglazed)"},
    {"W", PP_UNIT_SQUARE_METRE, "net glass area: opening area times frame factor"},
    {"M", PP_UNIT_NUMBER, "maintenance factor (dirt)"},
    PP_INTERIOR_QUANTITIES,
    {"A_f", PP_UNIT_SQUARE_METRE, "floor area"},
    {"rho_f", PP_UNIT_NUMBER, "reflectance of the floor"},
    PP_FITTED_LIGHT_QUANTITIES,
    PP_FITTED_OPENING_REVEAL,
    PP_FITTED_OPENING_LOW,
    {"E", PP_UNIT_DAYLIGHT_FACTOR, "total illuminance on the outside of the opening"},
    {"k_r", PP_UNIT_NUMBER, "correction for reveal, floor and ground"},
    {0},
};

static const struct pp_formula outside = {
    .symbol = "E",
    .sum = "V + E_b + E_g",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "total illuminance on the outside of the opening",
    .quantities = quantities,
};

static const struct pp_formula correction = {
    .symbol = "k_r",
    .sum =
        "exp(-" PP_FITTED_DF_REVEAL " d (1 / w + 1 / h)) (A / A_f)^" PP_FITTED_DF_FLOOR
        " exp(-" PP_FITTED_DF_UPWARD " C_g / max(V + C_b + C_g, 0.001))",
    .unit = PP_UNIT_NUMBER,
    .source = "ATLAS",
    .what = "correction for reveal, floor and ground",
    .quantities = quantities,
};

static const struct pp_formula average = {
    .symbol = "df",
    .sum = PP_FITTED_DF " T W (1 - n + n rho_f) M 2 E k_r / (A (1 - R^2))",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "average daylight factor over the working plane",
    .quantities = quantities,
};

static const struct pp_formula *const formulae[] = {&pp_allowance_glass_W,
                                                    PP_FITTED_LIGHT_FORMULAE,
                                                    &outside,
                                                    &correction,
                                                    &average,
                                                    NULL};

static enum pp_status evaluate_average_df_atlas(const struct pp_world *world,
                                                const struct pp_outside_light *light,
                                                const struct pp_opening *opening,
                                                const struct pp_receiver *receiver,
                                                const void *tools, struct pp_part *part,
                                                struct pp_error *err)
{
    (void)light, (void)receiver, (void)err;
    struct pp_worksheet *sheet = &part->sheet;
    struct pp_interior all = pp_interior_all(world);
    struct pp_interior floor = pp_interior_role(world, PP_FLOOR);
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "T",
                     "diffuse transmittance of the glass");
    pp_allowance_net_glass(sheet, &pp_allowance_glass_W, opening);
    pp_fitted_opening_put_low(sheet, world, opening);
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, floor.area_m2, "A_f", "floor area");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, floor.reflectance, "rho_f",
                     "reflectance of the floor");
    pp_allowance_put(sheet, PP_ALLOWS_DIRT, opening, "M", "maintenance factor");
    pp_interior_put(sheet, &all);
    pp_fitted_light_put(sheet, tools, world, opening);
    pp_worksheet_work(sheet, &outside,
                      "total illuminance on the outside of the opening");
    pp_fitted_opening_put_reveal(sheet, opening);
    pp_worksheet_work(sheet, &correction, "correction for reveal, floor and ground");
    part->value = pp_worksheet_work(sheet, &average, "average daylight factor");
    return PP_OK;
}

const struct pp_method pp_method_average_df_atlas = {
    .name = "average-df-atlas",
    .summary = "average daylight factor by a single formula, corrected to match "
               "simulated rooms",
    .source = "ATLAS",
    .formulae = formulae,
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .of_real_room = true,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_fitted_light_refuses,
    .prepare = pp_fitted_light_prepare,
    .destroy_tools = free,
    .evaluate = evaluate_average_df_atlas,
};
