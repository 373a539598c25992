/* average_df_lynes.c - `average-df-lynes`: the older form of the average daylight
 * factor.
 *
 *     DF = T W theta / (2 A (1 - R))   per cent                         [LYNES79]
 *
 * T, W, theta, A, R as of `average-df` (average_df.c), which grew out of it. It is the
 * average over all the room's surfaces, not over the working plane, and is not to be
 * compared with one: of the two forms this one gives (1 + R)/2 of the other.
 *
 * For vertical openings under the CIE overcast sky; several add up. It contains the
 * opening's glass and, through W, the frame; no dirt.
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
    pp_step_named(steps, PP_UNIT_SQUARE_METRE, all->area_m2, "A",
                  "area of all inside surfaces, openings included");
    pp_step_named(steps, PP_UNIT_NUMBER, all->reflectance, "R",
                  "their mean reflectance, openings with 0.1");
    pp_step_worked(steps, PP_UNIT_SHARE, value, "df", "T W theta / (2 A (1 - R))",
                   "opening on line %d: average over all surfaces", line);
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

    double T = opening->glass.diffuse;
    double W = opening->inner.area_m2 * opening->frame_factor;
    double theta_deg = angle.theta_rad / PP_RAD;
    double A = all.area_m2, R = all.reflectance;
    part->value = T * W * theta_deg / (2.0 * A * (1.0 - R)) / 100.0;
    set_down(part->steps, &angle, &all, opening, part->value);
    return PP_OK;
}

const struct pp_method pp_method_average_df_lynes = {
    .name = "average-df-lynes",
    .summary = "average daylight factor over all surfaces, the older form",
    .source = "LYNES79",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .of_all_surfaces = true,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refuse_room_of_formula,
    .refuses = pp_refuse_opening_unless_vertical,
    .evaluate = evaluate,
};
