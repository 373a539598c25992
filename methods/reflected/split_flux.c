/* split_flux.c - `split-flux`: internally reflected component by splitting the light
 * that enters into what falls on the upper and on the lower part of the room first.
 *
 * Through clear glass (entering_light.h), the lower part's illuminance from the upper,
 * over Eh:
 *
 *     IRC = tau Ag / (1 - rho_u rho_l)
 *         . [rho_u C_g / A_u + rho_u rho_l C / A_l]              [GEEBELEN] eq. 9
 *
 * Through a diffusing pane:
 *
 *     IRC = tau Ag / (1 - rho_u rho_l)
 *         . (C_g + C) [u rho_u / A_u + (1 - u) rho_u rho_l / A_l]  [GEEBELEN] eq. 12
 *
 *   tau   diffuse transmittance: 0.85 times the glass type's factor, 1 for no glass
 *   Ag    net glass area (m2): opening area times frame factor
 *   A_u, rho_u   area (m2) and mean reflectance of the surfaces above the middle of the
 *         opening's height, window walls included without their openings; A_l, rho_l of
 *         those below
 *   C, C_g   illuminance of the glass from above the horizon and from the ground
 *   u     share of a diffusing pane's light that goes up, 1/2 in print
 *
 * For any sky, any slope, and several openings, each with its own parts, which add up.
 * The formula contains the opening's glass and, through Ag, the frame; no dirt, no
 * deterioration of decorations.
 */
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)receiver;
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    if (!(parts.upper.reflectance * parts.lower.reflectance < 1.0))
        return "lights parts of the room that reflect all light, without end";
    return NULL;
}

/* x/y, and 0 where the part of the room has no area. */
static double over(double x, double y)
{
    return y > 0.0 ? x / y : 0.0;
}

static void add_steps(struct pp_steps *steps, const struct pp_entering_light *light,
                      const struct pp_interior_parts *parts,
                      const struct pp_opening *opening, double value)
{
    static const char clear[] =
        "tau Ag / (1 - rho_u rho_l) (rho_u C_g / A_u + rho_u rho_l C / A_l)";
    static const char diffusing[] =
        "tau Ag / (1 - rho_u rho_l) (C_g + C) (u rho_u / A_u + (1 - u) rho_u rho_l / "
        "A_l)";
    pp_entering_light_steps(steps, light, opening);
    pp_steps_add_named(steps, PP_UNIT_SQUARE_METRE, parts->upper.area_m2, "A_u",
                       "area of all above %.2f m, the middle of the opening",
                       opening->middle_z_m);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, parts->upper.reflectance, "rho_u",
                       "its mean reflectance");
    pp_steps_add_named(steps, PP_UNIT_SQUARE_METRE, parts->lower.area_m2, "A_l",
                       "area of all below it");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, parts->lower.reflectance, "rho_l",
                       "its mean reflectance");
    bool both = parts->upper.area_m2 > 0.0 && parts->lower.area_m2 > 0.0;
    pp_steps_add_worked(steps, PP_UNIT_SHARE, value, "irc",
                        !both              ? "0"
                        : light->diffusing ? diffusing
                                           : clear,
                        "opening on line %d: average internally reflected component",
                        opening->line);
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
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    double A_u = parts.upper.area_m2, rho_u = parts.upper.reflectance;
    double A_l = parts.lower.area_m2, rho_l = parts.lower.reflectance;
    part->value =
        light.tau * light.Ag / (1.0 - rho_u * rho_l)
        * (over(rho_u * light.up, A_u) + over(rho_u * rho_l * light.down, A_l));
    add_steps(part->steps, &light, &parts, opening, part->value);
    return PP_OK;
}

const struct pp_method pp_method_split_flux = {
    .name = "split-flux",
    .summary = "average internally reflected component, light split by upper and lower "
               "half",
    .source = "GEEBELEN",
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_luminous_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
