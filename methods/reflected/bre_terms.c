/* bre_terms.c - the BRE formula as data, and its terms from the world. */
#include "methods/reflected/bre_terms.h"

#include "methods/reflected/obstruction.h"

static const struct pp_formula_quantity terms_of_average[] = {
    PP_BRE_TERMS_OPENING,
    PP_INTERIOR_QUANTITIES,
    {0},
};

#define AVERAGE                                                                        \
    .sum = PP_BRE_TERMS_AVERAGE, .unit = PP_UNIT_DAYLIGHT_FACTOR, .source = "BRE310",  \
    .what = "average internally reflected component", .quantities = terms_of_average

const struct pp_formula pp_bre_terms_irc = {.symbol = "irc", AVERAGE};
const struct pp_formula pp_bre_terms_IRC_av = {.symbol = "IRC_av", AVERAGE};

enum pp_status pp_bre_terms(struct pp_bre_terms *terms, const struct pp_world *world,
                            const struct pp_outside_light *light,
                            const struct pp_opening *opening, struct pp_error *err)
{
    enum pp_status status =
        pp_obstruction_angle(&terms->alpha_rad, world, light, opening, err);
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

void pp_bre_terms_put_reflected(struct pp_worksheet *sheet,
                                const struct pp_bre_terms *terms,
                                const struct pp_opening *opening)
{
    pp_worksheet_put(
        sheet, PP_UNIT_NUMBER, terms->R_fw, "R_fw",
        "mean reflectance of the floor and of the walls below %.2f m, without the "
        "window wall",
        opening->middle_z_m);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, terms->R_cw, "R_cw",
                     "mean reflectance of the ceiling and of the walls above, without "
                     "the window wall");
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, terms->alpha_rad, "alpha",
                     "angle of the obstruction");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, terms->C, "C",
                     "factor C for this obstruction angle, from the table");
}

double pp_bre_terms_work(struct pp_worksheet *sheet, const struct pp_formula *formula,
                         const struct pp_bre_terms *terms,
                         const struct pp_opening *opening)
{
    pp_allowance_net_glass(sheet, &pp_allowance_glass_W, opening);
    pp_interior_put(sheet, &terms->all);
    pp_bre_terms_put_reflected(sheet, terms, opening);
    return pp_worksheet_work(sheet, formula, "average internally reflected component");
}

double pp_bre_terms_average(const struct pp_bre_terms *terms)
{
    const double values[] = {
        terms->W, terms->R_fw,        terms->R_cw,           terms->alpha_rad,
        terms->C, terms->all.area_m2, terms->all.reflectance};
    return pp_formula_value(&pp_bre_terms_irc, values);
}
