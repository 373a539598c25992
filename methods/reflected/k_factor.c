/* k_factor.c - `k-factor`: average internally reflected component of rooms with
 * rooflights and their wells, in the manner of BRE Digest 310 [BRE310].
 *
 * For windows the method is the same as `bre` (bre_terms.h). For horizontal rooflights
 * the same inter-reflection formula is used, as given in [TS93], algorithm 2.43. 0.85 C
 * is replaced by K, the mean daylight factor at the foot of the well, in the plane of
 * the ceiling. The Digest's own table of K was not available. Here K is 0.85 C N, with
 * C from the sky and its obstructions, and the efficiency N of the well by flux
 * transfer (well.h). All light from the foot of the well falls first on the floor and
 * the walls, with mean reflectance R_fw. Light reflected by the sides of the well is
 * internally reflected already; the part that falls on the working plane is added.
 *
 * The method is for the CIE overcast sky; sloping glass is not covered. The figures
 * contain clear single glass and, through W, the frame; no dirt, no deterioration of
 * decorations.
 */
#include <stddef.h>

#include "methods/reflected/bre_terms.h"
#include "methods/reflected/entering_light.h"
#include "methods/reflected/obstruction.h"
#include "methods/reflected/well.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_K[] = {
    {"C", PP_UNIT_DAYLIGHT_FACTOR, "illuminance on the glass from the sky"},
    PP_WELL_QUANTITIES,
    {0},
};

static const struct pp_formula factor = {
    .symbol = "K",
    .sum = "0.85 C N",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "mean daylight factor at the foot of the well, clear single glass",
    .quantities = of_K,
};

static const struct pp_formula_quantity of_rooflight[] = {
    {"W", PP_UNIT_SQUARE_METRE, "net glass area"},
    {"K", PP_UNIT_DAYLIGHT_FACTOR, "mean daylight factor at the foot of the well"},
    {"R_fw", PP_UNIT_NUMBER, "mean reflectance of floor and walls"},
    PP_INTERIOR_QUANTITIES,
    {0},
};

static const struct pp_formula rooflight = {
    .symbol = "irc",
    .sum = "W K R_fw / (A (1 - R))",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "TS93, algorithm 2.43",
    .what = "average internally reflected component, for horizontal rooflights",
    .quantities = of_rooflight,
};

static const struct pp_formula_quantity of_E_w[] = {
    {"W", PP_UNIT_SQUARE_METRE, "net glass area"},
    {"K", PP_UNIT_DAYLIGHT_FACTOR, "mean daylight factor at the foot of the well"},
    PP_WELL_QUANTITIES,
    {"f", PP_UNIT_NUMBER,
     "fraction of the light from the foot of the well that falls on the plane"},
    {"S", PP_UNIT_SQUARE_METRE, "area of the working plane"},
    {0},
};

static const struct pp_formula well = {
    .symbol = "E_w",
    .sum = "W K (1 - N_d / N) f / S",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "illuminance on the working plane from light reflected by the sides of the "
            "well",
    .quantities = of_E_w,
};

static const struct pp_formula *const formulae[] = {&pp_allowance_glass_W,
                                                    &pp_bre_terms_irc,
                                                    &pp_entering_light_C,
                                                    &factor,
                                                    &rooflight,
                                                    &well,
                                                    &pp_entering_light_with_well,
                                                    NULL};

static bool is_level(const struct pp_opening *opening)
{
    return sin(opening->slope_rad) < 1e-6;
}

static const char *k_factor_refuses(const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (is_level(opening) || !pp_refusals_unless_vertical(opening))
        return NULL;
    return "slopes, but the method covers only vertical windows and horizontal "
           "rooflights";
}

/* Records K and its quantities. */
static void put_K(struct pp_worksheet *sheet, const struct pp_world *world,
                  const struct pp_outside_light *light,
                  const struct pp_opening *opening, double alpha_rad)
{
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, alpha_rad, "alpha",
                     "angle of the obstruction");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, 1.0, "C_hv",
                     "illuminance on horizontal glass from the open sky");
    pp_worksheet_work(sheet, &pp_entering_light_C,
                      "illuminance on the glass from the sky");
    pp_well_put(sheet, world, light, opening);
    pp_worksheet_work(sheet, &factor, "mean daylight factor at the foot of the well");
}

static double of_level_glass(struct pp_worksheet *sheet, const struct pp_world *world,
                             const struct pp_outside_light *light,
                             const struct pp_opening *opening, double alpha_rad)
{
    struct pp_interior all = pp_interior_all(world);
    struct pp_interior below =
        pp_interior_split_without(world, opening->middle_z_m, opening->face).lower;
    pp_allowance_net_glass(sheet, &pp_allowance_glass_W, opening);
    put_K(sheet, world, light, opening, alpha_rad);
    pp_interior_put(sheet, &all);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, below.reflectance, "R_fw",
                     "mean reflectance of floor and walls");
    double irc =
        pp_worksheet_work(sheet, &rooflight, "average internally reflected component");
    return pp_entering_light_of_well(sheet, &well, world, opening, irc);
}

static enum pp_status evaluate_k_factor(const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        const struct pp_receiver *receiver,
                                        const void *tools, struct pp_part *part,
                                        struct pp_error *err)
{
    (void)receiver, (void)tools;
    double alpha_rad;
    struct pp_bre_terms terms;
    bool level = is_level(opening);
    enum pp_status status =
        level ? pp_obstruction_angle(&alpha_rad, world, light, opening, err)
              : pp_bre_terms(&terms, world, light, opening, err);
    if (status != PP_OK)
        return status;
    part->value =
        level ? of_level_glass(&part->sheet, world, light, opening, alpha_rad)
              : pp_bre_terms_work(&part->sheet, &pp_bre_terms_irc, &terms, opening);
    return PP_OK;
}

const struct pp_method pp_method_k_factor = {
    .name = "k-factor",
    .summary = "average internally reflected component, by the K factor for rooflights "
               "and wells",
    .source = "BRE310",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .own_ground = PP_BRE_GROUND_REFLECTANCE,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = k_factor_refuses,
    .evaluate = evaluate_k_factor,
};
