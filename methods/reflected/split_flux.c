/* split_flux.c - `split-flux`: internally reflected component by splitting the entering
 * light into the parts that fall first on the upper and on the lower part of the room.
 *
 * Light from above the horizon falls on the lower part and light from the ground on the
 * upper part. Through a diffusing pane the fraction u, published as 1/2, falls on the
 * upper part (entering_light.h). The result is the lower part's illuminance from the
 * upper part, divided by Eh.
 *
 * The method is for any sky, any slope and any number of openings, each with its own
 * parts. The results of all openings are added. The formula contains the opening's
 * glass and, through Ag, the frame; no dirt, no deterioration of decorations.
 */
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const char *split_flux_refuses(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver)
{
    (void)light, (void)receiver;
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    if (!(parts.upper.reflectance * parts.lower.reflectance < 1.0))
        return "is in a room whose upper and lower parts both have a mean reflectance "
               "of 1";
    return NULL;
}

#define QUANTITIES                                                                     \
    PP_ENTERING_LIGHT_QUANTITIES,                                                      \
        {"A_u", PP_UNIT_SQUARE_METRE,                                                  \
         "area of surfaces above the centre of the opening, including window walls, "  \
         "excluding openings"},                                                        \
        {"rho_u", PP_UNIT_NUMBER, "mean reflectance of these surfaces"},               \
        {"A_l", PP_UNIT_SQUARE_METRE, "area of surfaces below this height"},           \
    {                                                                                  \
        "rho_l", PP_UNIT_NUMBER, "mean reflectance of these surfaces"                  \
    }

static const struct pp_formula_quantity of_clear[] = {QUANTITIES, {0}};
static const struct pp_formula_quantity of_diffusing[] = {
    QUANTITIES, PP_ENTERING_LIGHT_SHARE_UP, {0}};

static const struct pp_formula clear = {
    .symbol = "irc",
    .sum = "tau Ag / (1 - rho_u rho_l) (rho_u C_g / A_u + rho_u rho_l C / A_l)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "GEEBELEN, eq. 9",
    .what = "average internally reflected component, for clear glass",
    .quantities = of_clear,
};

static const struct pp_formula diffusing = {
    .symbol = "irc",
    .sum =
        "tau Ag / (1 - rho_u rho_l) (C_g + C) (u rho_u / A_u + (1 - u) rho_u rho_l / "
        "A_l)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "GEEBELEN, eq. 12",
    .what = "average internally reflected component, for a diffusing pane",
    .quantities = of_diffusing,
};

static const struct pp_formula one_part = {
    .symbol = "irc",
    .sum = "0",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "average internally reflected component in a room that is entirely above "
            "or below the centre of the opening",
    .quantities = of_clear,
    .fixed = true,
};

static const struct pp_formula *const formulae[] = {
    PP_ENTERING_LIGHT_FORMULAE,      &clear, &diffusing, &one_part,
    PP_ENTERING_LIGHT_WELL_FORMULAE, NULL};

static enum pp_status evaluate_split_flux(const struct pp_world *world,
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
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, parts.upper.area_m2, "A_u",
                     "area of surfaces above %.2f m, the height of the opening's "
                     "centre",
                     opening->middle_z_m);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.upper.reflectance, "rho_u",
                     "mean reflectance of these surfaces");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, parts.lower.area_m2, "A_l",
                     "area of surfaces below this height");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.lower.reflectance, "rho_l",
                     "mean reflectance of these surfaces");
    bool both = parts.upper.area_m2 > 0.0 && parts.lower.area_m2 > 0.0;
    double irc = pp_worksheet_work(sheet,
                                   !both                      ? &one_part
                                   : opening->glass.diffusing ? &diffusing
                                                              : &clear,
                                   "average internally reflected component");
    part->value = pp_entering_light_of_well(&part->sheet, &pp_entering_light_E_w, world,
                                            opening, irc);
    return PP_OK;
}

const struct pp_method pp_method_split_flux = {
    .name = "split-flux",
    .summary = "average internally reflected component, with the light split into "
               "upward and downward flux",
    .source = "GEEBELEN",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_luminous_room,
    .refuses = split_flux_refuses,
    .evaluate = evaluate_split_flux,
};
