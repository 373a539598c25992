/* entering_light.c - C, C_g and u of an opening, and their steps. */
#include "methods/reflected/entering_light.h"

#include <stddef.h>

#include "methods/reflected/obstruction.h"
#include "methods/refusals.h"
#include "methods/allowance.h"

enum pp_status pp_entering_light(struct pp_entering_light *light,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    double alpha_rad;
    enum pp_status status = pp_obstruction_angle(&alpha_rad, world, opening, err);
    if (status != PP_OK)
        return status;
    *light = (struct pp_entering_light){.tau = pp_allowance_reflected_glass(opening),
                                        .Ag = pp_allowance_net_glass_m2(opening),
                                        .alpha_rad = alpha_rad,
                                        .C_hv = NAN,
                                        .u = (1.0 - cos(opening->slope_rad)) / 2.0,
                                        .diffusing = opening->glass.diffusing,
                                        .rho_g = world->ground_reflectance,
                                        .beta_rad = opening->slope_rad};

    bool vertical = pp_refusals_unless_vertical(opening) == NULL;
    if (vertical && world->sky.kind == PP_SKY_OVERCAST) {
        light->C = pp_obstruction_factor(alpha_rad);
    } else {
        struct pp_vec3 outward = pp_vec_scale(opening->inner.normal, -1.0);
        light->C_hv = pp_sky_on_plane(&world->sky, outward);
        light->C = light->C_hv * (1.0 - alpha_rad / (PP_PI / 2.0));
    }
    light->C_g = light->rho_g * light->u;

    light->up = light->C_g;
    light->down = light->C;
    if (light->diffusing) {
        light->up = (light->C_g + light->C) * light->u;
        light->down = (light->C_g + light->C) * (1.0 - light->u);
    }
    return PP_OK;
}

void pp_entering_light_steps(struct pp_steps *steps,
                             const struct pp_entering_light *light,
                             const struct pp_opening *opening)
{
    int line = opening->line;
    pp_allowance_net_glass_step(steps, opening, "Ag");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, light->tau, "tau",
                       opening->glass.panes == 0
                           ? "opening on line %d: diffuse transmittance, no glass"
                           : "opening on line %d: diffuse transmittance (clear 0.85)",
                       line);
    pp_steps_add_named(steps, PP_UNIT_ANGLE, light->alpha_rad, "alpha",
                       "opening on line %d: angle of the obstruction", line);
    if (isnan(light->C_hv)) {
        pp_steps_add_named(steps, PP_UNIT_SHARE, light->C, "C",
                           "on the glass from above the horizon, from the table");
    } else {
        pp_steps_add_named(steps, PP_UNIT_SHARE, light->C_hv, "C_hv",
                           "on glass of that slope from the open sky");
        pp_steps_add_worked(steps, PP_UNIT_SHARE, light->C, "C",
                            "C_hv (1 - alpha / 90)",
                            "on the glass from above the horizon");
    }
    pp_steps_add_named(steps, PP_UNIT_NUMBER, light->rho_g, "rho_g",
                       "reflectance of the ground");
    pp_steps_add_named(steps, PP_UNIT_ANGLE, light->beta_rad, "beta",
                       "opening on line %d: slope of the glass", line);
    pp_steps_add_worked(steps, PP_UNIT_SHARE, light->C_g, "C_g",
                        "100 rho_g (1 - cos(beta)) / 2",
                        "on the glass from the ground");
    if (light->diffusing)
        pp_steps_add_worked(steps, PP_UNIT_NUMBER, light->u, "u", "(1 - cos(beta)) / 2",
                            "share of the diffusing pane's light that goes up");
}
