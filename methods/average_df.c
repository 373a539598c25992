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
 *   theta  angle of visible sky (degrees): in the vertical section through the middle
 *          of the opening, in the plane of the wall's inside, from the obstruction
 *          angle alpha (reflected/obstruction.h) up to the head of the reveal
 *   M      maintenance factor
 *   A      area of all inside surfaces, openings included (m2)
 *   R      their area-weighted mean reflectance, openings with 0.1
 *
 * The two are averages over different surfaces and not to be compared: before dirt, the
 * older one is (1 + R)/2 of the other. For vertical openings under the CIE overcast
 * sky. Several openings add up, with the common A and R. Both contain the opening's
 * glass and, through W, the frame; `average-df` contains dirt too. Neither is meant for
 * obstructions that one section angle does not describe; reflected/obstruction.h says
 * how blocks become such an angle.
 */
#include "methods/reflected/interior.h"
#include "methods/reflected/obstruction.h"
#include "methods/method.h"
#include "methods/refusals.h"

struct terms {
    double T, W, M;
    double head_rad; /* altitude of the reveal's head: 90 degrees without a reveal */
    double alpha_rad, theta_rad;
    struct pp_interior all; /* A and R */
};

static enum pp_status find_terms(struct terms *terms, const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    terms->T = opening->glass.diffuse;
    terms->W = pp_allowance_net_glass_m2(opening);
    terms->M = opening->maintenance;
    terms->all = pp_interior_all(world);
    enum pp_status status =
        pp_obstruction_angle(&terms->alpha_rad, world, opening, err);
    terms->head_rad = atan2(opening->height_m / 2.0, opening->reveal_m);
    terms->theta_rad = fmax(terms->head_rad - terms->alpha_rad, 0.0);
    return status;
}

static void add_angle_steps(struct pp_steps *steps, const struct terms *terms,
                            const struct pp_opening *opening)
{
    int line = opening->line;
    if (opening->reveal_m > 0.0) {
        pp_steps_add_named(steps, PP_UNIT_METRE, opening->height_m, "h",
                           "opening on line %d: height", line);
        pp_steps_add_named(steps, PP_UNIT_METRE, opening->reveal_m, "d",
                           "opening on line %d: depth of the reveal", line);
        pp_steps_add_worked(steps, PP_UNIT_ANGLE, terms->head_rad, "theta_h",
                            "atan(h / 2 / d)", "altitude of the reveal's head");
    } else {
        pp_steps_add_named(steps, PP_UNIT_ANGLE, terms->head_rad, "theta_h",
                           "opening on line %d: up to the zenith", line);
    }
    pp_steps_add_named(steps, PP_UNIT_ANGLE, terms->alpha_rad, "alpha",
                       "opening on line %d: angle of the obstruction", line);
    pp_steps_add_worked(steps, PP_UNIT_ANGLE, terms->theta_rad, "theta",
                        "max(theta_h - alpha, 0)", "angle of visible sky");
}

static void add_term_steps(struct pp_steps *steps, const struct terms *terms,
                           const struct pp_opening *opening, bool with_dirt)
{
    int line = opening->line;
    pp_steps_add_named(steps, PP_UNIT_NUMBER, terms->T, "T",
                       "opening on line %d: diffuse transmittance", line);
    pp_allowance_net_glass_step(steps, opening, "W");
    add_angle_steps(steps, terms, opening);
    if (with_dirt)
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
    double T = terms.T, W = terms.W, theta_deg = terms.theta_rad / PP_RAD;
    double M = terms.M, A = terms.all.area_m2, R = terms.all.reflectance;
    part->value = T * W * theta_deg * M / (A * (1.0 - R * R)) / 100.0;
    add_term_steps(part->steps, &terms, opening, true);
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
    double T = terms.T, W = terms.W, theta_deg = terms.theta_rad / PP_RAD;
    double A = terms.all.area_m2, R = terms.all.reflectance;
    part->value = T * W * theta_deg / (2.0 * A * (1.0 - R)) / 100.0;
    add_term_steps(part->steps, &terms, opening, false);
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
