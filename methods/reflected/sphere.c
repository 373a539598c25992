/* sphere.c - `sphere`: average internally reflected component, the room taken as an
 * integrating sphere after the first reflection.
 *
 *     IRC = tau Ag / (A (1 - R)) (rho_u C_g + rho_l C)          [GEEBELEN] eq. 15
 *
 *   tau   diffuse transmittance: 0.85 times the glass type's factor, 1 for no glass
 *   Ag    net glass area (m2): opening area times frame factor
 *   A     area of all inside surfaces, openings included (m2)
 *   R     their area-weighted mean reflectance, openings with 0.1
 *   rho_u mean reflectance of the surfaces above the middle of the opening's height,
 *         window walls included without their openings; rho_l of those below
 *   C, C_g   illuminance of the glass from above the horizon and from the ground
 *         (entering_light.h)
 *
 * This is the formula of `bre` with the room's own ground reflectance and with the
 * window's own wall, for any sky, any slope and any number of openings, which add up.
 * In print it is for clear glass; through a diffusing pane the share u of the light
 * falls on the upper part first, the rest on the lower:
 *
 *     IRC = tau Ag / (A (1 - R)) (C_g + C) (u rho_u + (1 - u) rho_l)
 *
 * The formula contains the opening's glass and, through Ag, the frame; no dirt, no
 * deterioration of decorations.
 */
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/method.h"
#include "methods/refusals.h"

static void add_steps(struct pp_steps *steps, const struct pp_entering_light *light,
                      const struct pp_interior *all,
                      const struct pp_interior_parts *parts,
                      const struct pp_opening *opening, double value)
{
    pp_entering_light_steps(steps, light, opening);
    pp_interior_steps(steps, all);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, parts->upper.reflectance, "rho_u",
                       "mean reflectance above %.2f m, the middle of the opening",
                       opening->middle_z_m);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, parts->lower.reflectance, "rho_l",
                       "mean reflectance below it");
    pp_steps_add_worked(
        steps, PP_UNIT_SHARE, value, "irc",
        light->diffusing ? "tau Ag / (A (1 - R)) (C_g + C) (u rho_u + (1 - u) rho_l)"
                         : "tau Ag / (A (1 - R)) (rho_u C_g + rho_l C)",
        "opening on line %d: average internally reflected component", opening->line);
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_entering_light light;
    enum pp_status status = pp_entering_light(&light, world, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_interior all = pp_interior_all(world);
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    double A = all.area_m2, R = all.reflectance;
    double rho_u = parts.upper.reflectance, rho_l = parts.lower.reflectance;
    part->value = light.tau * light.Ag / (A * (1.0 - R))
                  * (rho_u * light.up + rho_l * light.down);
    add_steps(part->steps, &light, &all, &parts, opening, part->value);
    return PP_OK;
}

const struct pp_method pp_method_sphere = {
    .name = "sphere",
    .summary = "average internally reflected component, the room as an integrating "
               "sphere",
    .source = "GEEBELEN",
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_luminous_room,
    .evaluate = evaluate,
};
