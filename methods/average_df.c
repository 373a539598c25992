/* average_df.c - `average-df`: average daylight factor over the working plane.
 *
 *     DF = T W theta M / (A (1 - R^2))   per cent                          [CL84]
 *
 *   T      diffuse transmittance of the glass, 1 for an unglazed opening
 *   W      net glass area (m2): opening area times frame factor
 *   theta  angle of visible sky (degrees), visible_angle.h
 *   M      maintenance factor
 *   A      area of all inside surfaces, openings included (m2)
 *   R      their area-weighted mean reflectance, openings with 0.1
 *
 * For vertical openings under the CIE overcast sky. Several openings add up, with the
 * common A and R. Nothing is left to allow for but decorations. The formula is not
 * meant for obstructions that one section angle does not describe; blocks are taken by
 * obstruction_angle.h.
 */
#include "methods/bre_terms.h"
#include "methods/inside.h"
#include "methods/methods.h"
#include "methods/refusals.h"
#include "methods/visible_angle.h"

static void set_down(struct pp_steps *steps, const struct pp_visible_angle *angle,
                     const struct pp_inside *all, const struct pp_opening *opening,
                     double value)
{
    int line = opening->line;
    pp_step_named(steps, PP_UNIT_NUMBER, opening->glass.diffuse, "T",
                  "opening on line %d: diffuse transmittance", line);
    pp_step_net_area(steps, opening, "W");
    pp_visible_angle_steps(steps, angle, opening);
    pp_step_named(steps, PP_UNIT_NUMBER, opening->maintenance, "M",
                  "opening on line %d: maintenance", line);
    pp_step_named(steps, PP_UNIT_SQUARE_METRE, all->area_m2, "A",
                  "area of all inside surfaces, openings included");
    pp_step_named(steps, PP_UNIT_NUMBER, all->reflectance, "R",
                  "their mean reflectance, openings with 0.1");
    pp_step_worked(steps, PP_UNIT_SHARE, value, "df", "T W theta M / (A (1 - R^2))",
                   "opening on line %d: average daylight factor", line);
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_visible_angle angle;
    enum pp_status status = pp_visible_angle(&angle, world, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_inside all = pp_inside_all(world);

    double T = opening->glass.diffuse, M = opening->maintenance;
    double W = opening->inner.area_m2 * opening->frame_factor;
    double theta_deg = angle.theta_rad / PP_RAD;
    double A = all.area_m2, R = all.reflectance;
    part->value = T * W * theta_deg * M / (A * (1.0 - R * R)) / 100.0;
    set_down(part->steps, &angle, &all, opening, part->value);
    return PP_OK;
}

const struct pp_method pp_method_average_df = {
    .name = "average-df",
    .summary = "average daylight factor over the working plane in one formula",
    .source = "CL84",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = pp_refuse_room_of_formula,
    .refuses = pp_refuse_opening_unless_vertical,
    .evaluate = evaluate,
};
