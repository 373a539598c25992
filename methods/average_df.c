/* average_df.c - the average daylight factor in one formula, in its two forms.
 *
 * `average-df`, over the working plane:
 *
 *     DF = T W theta M / (A (1 - R^2))   per cent                          [CL84]
 *
 * `average-df-lynes`, the older form it grew out of, over all surfaces of the room:
 *
 *     DF = T W theta / (2 A (1 - R))     per cent                        [LYNES79]
 *
 *   T      diffuse transmittance of the glass, 1 for an unglazed opening
 *   W      net glass area (m2): opening area times frame factor
 *   theta  angle of visible sky (degrees), visible_angle.h
 *   M      maintenance factor
 *   A      area of all inside surfaces, openings included (m2)
 *   R      their area-weighted mean reflectance, openings with 0.1
 *
 * They are averages of different things, and not to be compared: the older is (1 + R)/2
 * of the other, before dirt. For vertical openings under the CIE overcast sky. Several
 * openings add up, with the common A and R. Both contain the opening's glass and,
 * through W, the frame; `average-df` dirt too. Neither is meant for obstructions that
 * one section angle does not describe; blocks are taken by obstruction_angle.h.
 */
#include "methods/reflected/bre_terms.h"
#include "methods/reflected/interior.h"
#include "methods/method_entries.h"
#include "methods/refusals.h"
#include "methods/visible_angle.h"

struct terms {
    double T, W, M;
    struct pp_visible_angle angle;
    struct pp_interior all; /* A and R */
};

static enum pp_status find_terms(struct terms *terms, const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    terms->T = opening->glass.diffuse;
    terms->W = opening->inner.area_m2 * opening->frame_factor;
    terms->M = opening->maintenance;
    terms->all = pp_interior_all(world);
    return pp_visible_angle(&terms->angle, world, opening, err);
}

/* dirt: M, too. */
static void set_down(struct pp_steps *steps, const struct terms *terms,
                     const struct pp_opening *opening, bool dirt)
{
    int line = opening->line;
    pp_steps_add_named(steps, PP_UNIT_NUMBER, terms->T, "T",
                       "opening on line %d: diffuse transmittance", line);
    pp_bre_terms_net_area_step(steps, opening, "W");
    pp_visible_angle_steps(steps, &terms->angle, opening);
    if (dirt)
        pp_steps_add_named(steps, PP_UNIT_NUMBER, terms->M, "M",
                           "opening on line %d: maintenance", line);
    pp_interior_steps(steps, &terms->all);
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct terms terms;
    enum pp_status status = find_terms(&terms, world, opening, err);
    if (status != PP_OK)
        return status;
    double T = terms.T, W = terms.W, theta_deg = terms.angle.theta_rad / PP_RAD;
    double M = terms.M, A = terms.all.area_m2, R = terms.all.reflectance;
    part->value = T * W * theta_deg * M / (A * (1.0 - R * R)) / 100.0;
    set_down(part->steps, &terms, opening, true);
    pp_steps_add_worked(part->steps, PP_UNIT_SHARE, part->value, "df",
                        "T W theta M / (A (1 - R^2))",
                        "opening on line %d: average daylight factor", opening->line);
    return PP_OK;
}

static enum pp_status evaluate_lynes(const struct pp_world *world,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     const void *tools, struct pp_part *part,
                                     struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct terms terms;
    enum pp_status status = find_terms(&terms, world, opening, err);
    if (status != PP_OK)
        return status;
    double T = terms.T, W = terms.W, theta_deg = terms.angle.theta_rad / PP_RAD;
    double A = terms.all.area_m2, R = terms.all.reflectance;
    part->value = T * W * theta_deg / (2.0 * A * (1.0 - R)) / 100.0;
    set_down(part->steps, &terms, opening, false);
    pp_steps_add_worked(part->steps, PP_UNIT_SHARE, part->value, "df",
                        "T W theta / (2 A (1 - R))",
                        "opening on line %d: average over all surfaces", opening->line);
    return PP_OK;
}

const struct pp_method pp_method_average_df = {
    .name = "average-df",
    .summary = "average daylight factor over the working plane in one formula",
    .source = "CL84",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate,
};

const struct pp_method pp_method_average_df_lynes = {
    .name = "average-df-lynes",
    .summary = "average daylight factor over all surfaces, the older form",
    .source = "LYNES79",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .of_all_surfaces = true,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate_lynes,
};
