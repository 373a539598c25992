/* sphere.c - `sphere`: average internally reflected component, the room taken as an
 * integrating sphere after the first reflection.
 *
 * The formula is that of `bre` with the room's own ground reflectance and with the
 * window's wall included in the mean reflectances, for any sky, any slope and any
 * number of openings, whose results are added. The published formula is for clear
 * glass. For a diffusing pane (entering_light.h) the fraction u of the light falls on
 * the upper part first, the rest on the lower part.
 *
 * The formula contains the opening's glass and, through Ag, the frame; no dirt, no
 * deterioration of decorations.
 */
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/method.h"
#include "methods/refusals.h"

#define QUANTITIES                                                                     \
    PP_ENTERING_LIGHT_QUANTITIES, PP_INTERIOR_QUANTITIES,                              \
        {"rho_u", PP_UNIT_NUMBER,                                                      \
         "mean reflectance of surfaces above the centre of the opening, including "    \
         "window walls, excluding openings"},                                          \
    {                                                                                  \
        "rho_l", PP_UNIT_NUMBER, "mean reflectance of surfaces below this height"      \
    }

static const struct pp_formula_quantity of_clear[] = {QUANTITIES, {0}};
static const struct pp_formula_quantity of_diffusing[] = {
    QUANTITIES, PP_ENTERING_LIGHT_SHARE_UP, {0}};

static const struct pp_formula clear = {
    .symbol = "irc",
    .sum = "tau Ag / (A (1 - R)) (rho_u C_g + rho_l C)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "GEEBELEN, eq. 15",
    .what = "average internally reflected component, for clear glass",
    .quantities = of_clear,
};

static const struct pp_formula diffusing = {
    .symbol = "irc",
    .sum = "tau Ag / (A (1 - R)) (C_g + C) (u rho_u + (1 - u) rho_l)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "average internally reflected component, for a diffusing pane",
    .quantities = of_diffusing,
};

static const struct pp_formula *const formulae[] = {
    PP_ENTERING_LIGHT_FORMULAE, &clear, &diffusing, PP_ENTERING_LIGHT_WELL_FORMULAE,
    NULL};

static enum pp_status evaluate_sphere(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver,
                                      const void *tools, struct pp_part *part,
                                      struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_worksheet *sheet = &part->sheet;
    enum pp_status status = pp_entering_light(sheet, world, light, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_interior all = pp_interior_all(world);
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    pp_interior_put(sheet, &all);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.upper.reflectance, "rho_u",
                     "mean reflectance of surfaces above %.2f m, the height of the "
                     "opening's centre",
                     opening->middle_z_m);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.lower.reflectance, "rho_l",
                     "mean reflectance of surfaces below this height");
    double irc =
        pp_worksheet_work(sheet, opening->glass.diffusing ? &diffusing : &clear,
                          "average internally reflected component");
    part->value = pp_entering_light_of_well(&part->sheet, &pp_entering_light_E_w, world,
                                            opening, irc);
    return PP_OK;
}

const struct pp_method pp_method_sphere = {
    .name = "sphere",
    .summary = "average internally reflected component, with the room as an "
               "integrating sphere",
    .source = "GEEBELEN",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_luminous_room,
    .evaluate = evaluate_sphere,
};
