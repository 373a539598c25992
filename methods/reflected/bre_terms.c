/* bre_terms.c - the terms of the BRE formula from the world, the formula, and its
 * steps. */
#include "methods/reflected/bre_terms.h"

#include "methods/reflected/obstruction.h"

enum pp_status pp_bre_terms(struct pp_bre_terms *terms, const struct pp_world *world,
                            const struct pp_opening *opening, struct pp_error *err)
{
    enum pp_status status =
        pp_obstruction_angle(&terms->alpha_rad, world, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_interior_parts parts =
        pp_interior_split_without(world, opening->middle_z_m, opening->face);
    terms->all = pp_interior_all(world);
    terms->W = pp_allowance_net_glass_m2(opening);
    terms->R_fw = parts.lower.reflectance;
    terms->R_cw = parts.upper.reflectance;
    terms->C = pp_obstruction_factor(terms->alpha_rad);
    return PP_OK;
}

double pp_bre_terms_reflected(const struct pp_bre_terms *terms, double C)
{
    return C * terms->R_fw + PP_BRE_GROUND * terms->R_cw;
}

double pp_bre_terms_average(const struct pp_bre_terms *terms)
{
    double W = terms->W, A = terms->all.area_m2, R = terms->all.reflectance;
    return PP_ALLOWANCE_CLEAR_DIFFUSE * W / (A * (1.0 - R))
           * pp_bre_terms_reflected(terms, terms->C);
}

void pp_bre_terms_reflected_steps(struct pp_steps *steps,
                                  const struct pp_bre_terms *terms,
                                  const struct pp_opening *opening)
{
    pp_steps_add_named(steps, PP_UNIT_NUMBER, terms->R_fw, "R_fw",
                       "reflectance of floor and walls below %.2f m, own wall left out",
                       opening->middle_z_m);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, terms->R_cw, "R_cw",
                       "reflectance of ceiling and walls above, own wall left out");
    pp_steps_add_named(steps, PP_UNIT_ANGLE, terms->alpha_rad, "alpha",
                       "opening on line %d: angle of the obstruction", opening->line);
    pp_steps_add_named(steps, PP_UNIT_SHARE, terms->C, "C",
                       "factor of an obstruction of that angle, from the table");
}

void pp_bre_terms_steps(struct pp_steps *steps, const struct pp_bre_terms *terms,
                        const struct pp_opening *opening, const char *symbol)
{
    pp_allowance_net_glass_step(steps, opening, "W");
    pp_interior_steps(steps, &terms->all);
    pp_bre_terms_reflected_steps(steps, terms, opening);
    pp_steps_add_worked(steps, PP_UNIT_SHARE, pp_bre_terms_average(terms), symbol,
                        "0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)",
                        "opening on line %d: average internally reflected component",
                        opening->line);
}
