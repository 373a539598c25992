/* entering_light.c - records C, C_g and u for an opening, with the quantities on which
 * they depend. */
#include "methods/reflected/entering_light.h"

#include "methods/reflected/obstruction.h"
#include "methods/reflected/well.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_C[] = {
    {"C_hv", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on glass of this slope from the open sky"},
    {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},
    {0},
};

const struct pp_formula pp_entering_light_C = {
    .symbol = "C",
    .sum = "C_hv (1 - alpha / 90)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "GEEBELEN",
    .what = "illuminance on the glass from above the horizon (for vertical glass under "
            "an overcast sky, from the table)",
    .quantities = of_C,
};

static const struct pp_formula_quantity of_C_of_well[] = {
    {"C_hv", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on glass of this slope from the open sky"},
    {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},
    PP_WELL_QUANTITIES,
    {0},
};

const struct pp_formula pp_entering_light_C_of_well = {
    .symbol = "C",
    .sum = "C_hv (1 - alpha / 90) N",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "light from above the horizon that leaves the foot of a well",
    .quantities = of_C_of_well,
    .fixed = true,
};

static const struct pp_formula_quantity of_C_g[] = {
    {"rho_g", PP_UNIT_NUMBER, "reflectance of the ground"},
    {"beta", PP_UNIT_ANGLE, "slope of the glass (0: horizontal)"},
    {0},
};

const struct pp_formula pp_entering_light_C_g = {
    .symbol = "C_g",
    .sum = "100 rho_g (1 - cos(beta)) / 2",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "GEEBELEN",
    .what = "illuminance on the glass from the ground",
    .quantities = of_C_g,
};

static const struct pp_formula_quantity of_C_g_of_well[] = {
    {"rho_g", PP_UNIT_NUMBER, "reflectance of the ground"},
    {"beta", PP_UNIT_ANGLE, "slope of the glass (0: horizontal)"},
    PP_WELL_QUANTITIES,
    {0},
};

const struct pp_formula pp_entering_light_C_g_of_well = {
    .symbol = "C_g",
    .sum = "100 rho_g (1 - cos(beta)) / 2 N",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "ground-reflected light that leaves the foot of a well",
    .quantities = of_C_g_of_well,
    .fixed = true,
};

static const struct pp_formula_quantity of_E_w[] = {
    PP_ENTERING_LIGHT_QUANTITIES,
    PP_WELL_QUANTITIES,
    {"f", PP_UNIT_NUMBER,
     "fraction of the light from the foot of the well that falls on the plane"},
    {"S", PP_UNIT_SQUARE_METRE, "area of the working plane"},
    {0},
};

const struct pp_formula pp_entering_light_E_w = {
    .symbol = "E_w",
    .sum = "tau Ag (C + C_g) (1 - N_d / N) f / S",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "illuminance on the working plane from light reflected by the sides of the "
            "well",
    .quantities = of_E_w,
};

static const struct pp_formula_quantity of_with_well[] = {
    {"irc", PP_UNIT_DAYLIGHT_FACTOR,
     "internally reflected component from the formula for the room"},
    {"E_w", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on the working plane from light reflected by the sides of the well"},
    {0},
};

const struct pp_formula pp_entering_light_with_well = {
    .symbol = "irc",
    .sum = "irc + E_w",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "internally reflected component, including light from the sides of a well",
    .quantities = of_with_well,
    .fixed = true,
};

const struct pp_formula pp_entering_light_u = {
    .symbol = "u",
    .sum = "(1 - cos(beta)) / 2",
    .unit = PP_UNIT_NUMBER,
    .what = "fraction of the light from the diffusing pane that goes upwards",
    .quantities = of_C_g,
};

/* Records C, from the table of the BRE formula or from C_hv. */
static void put_C(struct pp_worksheet *sheet, const struct pp_outside_light *light,
                  const struct pp_opening *opening, double alpha_rad)
{
    bool vertical = pp_refusals_unless_vertical(opening) == NULL;
    if (vertical && light->sky.kind == PP_SKY_OVERCAST) {
        pp_worksheet_put(
            sheet, PP_UNIT_DAYLIGHT_FACTOR, pp_obstruction_factor(alpha_rad), "C",
            "illuminance on the glass from above the horizon, from the table");
        return;
    }
    struct pp_vec3 outward = pp_vec_scale(opening->inner.normal, -1.0);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_outside_light_sky_on_plane(light, outward), "C_hv",
                     "illuminance on glass of this slope from the open sky");
    if (pp_well_is(opening))
        pp_worksheet_work(sheet, &pp_entering_light_C_of_well,
                          "light from above the horizon that leaves the foot of the "
                          "well");
    else
        pp_worksheet_work(sheet, &pp_entering_light_C,
                          "illuminance on the glass from above the horizon");
}

enum pp_status pp_entering_light(struct pp_worksheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    double alpha_rad;
    enum pp_status status =
        pp_obstruction_angle(&alpha_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_allowance_net_glass(sheet, &pp_allowance_glass_Ag, opening);
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "tau",
                     "diffuse transmittance of the glass%s",
                     opening->glass.panes == 0 ? " (unglazed)" : "");
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, alpha_rad, "alpha",
                     "angle of the obstruction");
    if (pp_well_is(opening))
        pp_well_put(sheet, world, light, opening);
    put_C(sheet, light, opening, alpha_rad);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, light->ground_reflectance, "rho_g",
                     "reflectance of the ground");
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, opening->slope_rad, "beta",
                     "slope of the glass");
    if (pp_well_is(opening))
        pp_worksheet_work(sheet, &pp_entering_light_C_g_of_well,
                          "ground-reflected light that leaves the foot of the well");
    else
        pp_worksheet_work(sheet, &pp_entering_light_C_g,
                          "illuminance on the glass from the ground");
    if (opening->glass.diffusing)
        pp_worksheet_work(
            sheet, &pp_entering_light_u,
            "fraction of the light from the diffusing pane that goes upwards");
    return PP_OK;
}

double pp_entering_light_of_well(struct pp_worksheet *sheet,
                                 const struct pp_formula *E_w,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening, double irc)
{
    if (!pp_well_is(opening))
        return irc;
    pp_well_put_foot(sheet, world, opening);
    pp_worksheet_work(sheet, E_w,
                      "illuminance on the working plane from light reflected by the "
                      "sides of the well");
    return pp_worksheet_work(
        sheet, &pp_entering_light_with_well,
        "internally reflected component, including light from the sides of the well");
}
