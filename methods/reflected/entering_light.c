/* entering_light.c - C, C_g and u of an opening, put down with what they come from. */
#include "methods/reflected/entering_light.h"

#include "methods/reflected/obstruction.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_C[] = {
    {"C_hv", PP_UNIT_SHARE, "on glass of that slope from the open sky"},
    {"alpha", PP_UNIT_ANGLE, "angle of the obstruction outside"},
    {0},
};

const struct pp_formula pp_entering_light_C = {
    .symbol = "C",
    .sum = "C_hv (1 - alpha / 90)",
    .unit = PP_UNIT_SHARE,
    .source = "GEEBELEN",
    .what =
        "on the glass from above the horizon; vertical under the overcast sky: from "
        "the table",
    .quantities = of_C,
};

static const struct pp_formula_quantity of_C_g[] = {
    {"rho_g", PP_UNIT_NUMBER, "reflectance of the ground"},
    {"beta", PP_UNIT_ANGLE, "slope of the glass, 0 horizontal"},
    {0},
};

const struct pp_formula pp_entering_light_C_g = {
    .symbol = "C_g",
    .sum = "100 rho_g (1 - cos(beta)) / 2",
    .unit = PP_UNIT_SHARE,
    .source = "GEEBELEN",
    .what = "on the glass from the ground",
    .quantities = of_C_g,
};

const struct pp_formula pp_entering_light_u = {
    .symbol = "u",
    .sum = "(1 - cos(beta)) / 2",
    .unit = PP_UNIT_NUMBER,
    .what = "share of the diffusing pane's light that goes up",
    .quantities = of_C_g,
};

/* C, by the table or by C_hv, which are read of the room. */
static void put_C(struct pp_worksheet *sheet, const struct pp_outside_light *light,
                  const struct pp_opening *opening, double alpha_rad)
{
    bool vertical = pp_refusals_unless_vertical(opening) == NULL;
    if (vertical && light->sky.kind == PP_SKY_OVERCAST) {
        pp_worksheet_put(sheet, PP_UNIT_SHARE, pp_obstruction_factor(alpha_rad), "C",
                         "on the glass from above the horizon, from the table");
        return;
    }
    struct pp_vec3 outward = pp_vec_scale(opening->inner.normal, -1.0);
    pp_worksheet_put(sheet, PP_UNIT_SHARE, pp_sky_on_plane(&light->sky, outward),
                     "C_hv", "on glass of that slope from the open sky");
    pp_worksheet_work(sheet, &pp_entering_light_C,
                      "on the glass from above the horizon");
}

enum pp_status pp_entering_light(struct pp_worksheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    int line = opening->line;
    double alpha_rad;
    enum pp_status status =
        pp_obstruction_angle(&alpha_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_allowance_net_glass(sheet, &pp_allowance_glass_Ag, opening);
    double tau = opening->glass.diffuse;
    if (opening->glass.panes == 0)
        pp_worksheet_put(sheet, PP_UNIT_NUMBER, tau, "tau",
                         "opening on line %d: diffuse transmittance, no glass", line);
    else
        pp_worksheet_put(sheet, PP_UNIT_NUMBER, tau, "tau",
                         "opening on line %d: diffuse transmittance", line);
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, alpha_rad, "alpha",
                     "opening on line %d: angle of the obstruction", line);
    put_C(sheet, light, opening, alpha_rad);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, light->ground_reflectance, "rho_g",
                     "reflectance of the ground");
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, opening->slope_rad, "beta",
                     "opening on line %d: slope of the glass", line);
    pp_worksheet_work(sheet, &pp_entering_light_C_g, "on the glass from the ground");
    if (opening->glass.diffusing)
        pp_worksheet_work(sheet, &pp_entering_light_u,
                          "share of the diffusing pane's light that goes up");
    return PP_OK;
}
