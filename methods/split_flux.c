/* split_flux.c - `split-flux`: internally reflected component by splitting the light
 * that enters into what falls on the upper and on the lower half of the room.
 *
 * Clear glass: light from above the horizon falls on the lower part first, light from
 * the ground on the upper one. The lower part's illuminance from the upper, over Eh:
 *
 *     IRC = tau Ag / (1 - rho_u rho_l)
 *         . [rho_u G / A_u + rho_u rho_l C / A_l]                [GEEBELEN] eq. 9
 *
 * A diffusing pane sends all that it lets through to both:
 *
 *     IRC = tau Ag / (1 - rho_u rho_l)
 *         . (G + C) [u rho_u / A_u + (1 - u) rho_u rho_l / A_l]  [GEEBELEN] eq. 12
 *
 *   tau   diffuse transmittance: 0.85 times the glass type's factor, 1 for no glass
 *   Ag    net glass area (m2): opening area times frame factor
 *   A_u, rho_u   area (m2) and mean reflectance of what lies above the middle of the
 *         opening's height, window walls less their openings included; A_l, rho_l below
 *   C     illuminance of the glass from above the horizon, over Eh
 *   G     the same from the ground: rho_ground (1 - cos slope)/2, rho_ground/2 in print
 *   u     share of a diffusing pane's light that goes up: (1 - cos slope)/2, 1/2 in
 * print
 *
 * C of a vertical opening under the overcast sky is that of the BRE table
 * (obstruction_factor.h). Elsewhere it is C_hv (1 - alpha/90), as printed, with the
 * sky's exact ratio C_hv of the open sky on the glass's slope, in place of 0.39.
 *
 * For any sky, any slope, several openings (their sum). It contains the opening's glass
 * and, through Ag, the frame; no dirt, no deterioration of decorations.
 */
#include <stddef.h>

#include "methods/inside.h"
#include "methods/methods.h"
#include "methods/obstruction_angle.h"
#include "methods/obstruction_factor.h"
#include "methods/refusals.h"

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    (void)receiver;
    return pp_refuse_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)receiver;
    struct pp_inside_parts parts = pp_inside_split(world, opening->middle_z_m);
    if (!(parts.upper.reflectance * parts.lower.reflectance < 1.0))
        return "lights parts of the room that reflect all light, without end";
    return NULL;
}

/* C: what comes to the glass from above the horizon, over Eh. */
static double from_above(const struct pp_world *world, const struct pp_opening *opening,
                         double alpha_rad)
{
    bool vertical = pp_refuse_unless_vertical(opening) == NULL;
    if (vertical && world->sky.kind == PP_SKY_OVERCAST)
        return pp_obstruction_factor(alpha_rad);
    struct pp_vec3 outward = pp_scale(opening->inner.normal, -1.0);
    return pp_sky_on_plane(&world->sky, outward) * (1.0 - alpha_rad / (PP_PI / 2.0));
}

/* x/y, and 0 where there is nothing to light. */
static double over(double x, double y)
{
    return y > 0.0 ? x / y : 0.0;
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)receiver, (void)tools;
    double alpha_rad;
    enum pp_status status = pp_obstruction_angle(&alpha_rad, world, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_inside_parts parts = pp_inside_split(world, opening->middle_z_m);

    double tau = pp_allowance_reflected_glass(opening);
    double Ag = opening->inner.area_m2 * opening->frame_factor;
    double rho_u = parts.upper.reflectance, rho_l = parts.lower.reflectance;
    double C = from_above(world, opening, alpha_rad);
    double upward = (1.0 - cos(opening->slope_rad)) / 2.0;
    double G = world->ground_reflectance * upward;

    double to_upper = G, to_lower = C;
    if (opening->glass.diffusing) {
        to_upper = (G + C) * upward;
        to_lower = (G + C) * (1.0 - upward);
    }
    part->value = tau * Ag / (1.0 - rho_u * rho_l)
                  * (over(rho_u * to_upper, parts.upper.area_m2)
                     + over(rho_u * rho_l * to_lower, parts.lower.area_m2));
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
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
