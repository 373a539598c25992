/* year_by_df.c - `df-diffuse`, `df-global` and `df-orientation`: the daylight factor times
 * an illuminance outside [GEEBELEN].
 *
 * The orientation factors are those of Hunt, as quoted in the daylighting literature: for
 * diffuse light in the United Kingdom with the sun shaded. Sources give 1.20 to 1.67 for a
 * facade that faces the equator, 1.04 to 1.25 for east, 1.00 to 1.25 for west, 0.77 to
 * 0.97 for one that faces the pole.
 */
#include <math.h>
#include <stdlib.h>

#include "studies/year/hand/year_terms.h"

static const double orientation_factors[4] = {1.20, 1.00, 0.77, 1.00};

static const struct pp_formula_quantity of_diffuse[] = {
    PP_YEAR_TERMS_D, PP_YEAR_TERMS_E_D, {0}};
static const struct pp_formula_quantity of_global[] = {
    PP_YEAR_TERMS_D, PP_YEAR_TERMS_E_D, PP_YEAR_TERMS_E_S, {0}};
static const struct pp_formula_quantity of_orientation[] = {
    PP_YEAR_TERMS_D,
    PP_YEAR_TERMS_E_D,
    {"f", PP_UNIT_NUMBER, "orientation factor"},
    {0}};

#define BY_DF(text, of)                                                                \
    {                                                                                  \
        .symbol = "E", .sum = text, .unit = PP_UNIT_LUX, .what = "illuminance",        \
        .quantities = of, .fixed = true                                                \
    }
static const struct pp_formula by_diffuse = BY_DF("D E_d / 100", of_diffuse);
static const struct pp_formula by_global = BY_DF("D (E_d + E_s) / 100", of_global);
static const struct pp_formula by_orientation = BY_DF("D f E_d / 100", of_orientation);

static const struct pp_formula *const formulae_of_diffuse[] = {&by_diffuse, NULL};
static const struct pp_formula *const formulae_of_global[] = {&pp_year_terms_sun,
                                                              &by_global, NULL};
static const struct pp_formula *const formulae_of_orientation[] = {&by_orientation,
                                                                   NULL};

static void evaluate_df_diffuse(const struct pp_hand_case *of, const void *tools,
                                int point, const struct pp_hand_hour *hour,
                                struct pp_worksheet *sheet,
                                struct pp_year_states *states)
{
    (void)tools;
    pp_year_terms_put_df(sheet, of, point);
    pp_year_terms_put_sky(sheet, hour);
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &by_diffuse, "illuminance"));
}

static void evaluate_df_global(const struct pp_hand_case *of, const void *tools,
                               int point, const struct pp_hand_hour *hour,
                               struct pp_worksheet *sheet,
                               struct pp_year_states *states)
{
    (void)tools;
    pp_year_terms_put_df(sheet, of, point);
    pp_year_terms_put_sky(sheet, hour);
    pp_year_terms_work_sun(sheet, hour);
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &by_global, "illuminance"));
}

static const char *refuses_orientation(const struct pp_hand_case *of)
{
    return isnan(pp_hand_case_by_facade(of, orientation_factors))
               ? "orientation factors are for windows only, but an opening slopes less "
                 "than 45 degrees, or there are none"
               : NULL;
}

static enum pp_status prepare_orientation(void **tools, struct pp_hand_case *of,
                                          struct pp_error *err)
{
    double *factor = malloc(sizeof *factor);
    if (!factor)
        return pp_fail_memory(err);
    *factor = pp_hand_case_by_facade(of, orientation_factors);
    *tools = factor;
    return PP_OK;
}

static void evaluate_df_orientation(const struct pp_hand_case *of, const void *tools,
                                    int point, const struct pp_hand_hour *hour,
                                    struct pp_worksheet *sheet,
                                    struct pp_year_states *states)
{
    pp_year_terms_put_df(sheet, of, point);
    pp_year_terms_put_sky(sheet, hour);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, *(const double *)tools, "f",
                     "orientation factor of the facade");
    *states =
        pp_year_terms_state(pp_worksheet_work(sheet, &by_orientation, "illuminance"));
}

const struct pp_year_method pp_year_method_df_diffuse = {
    .name = "df-diffuse",
    .summary = "daylight factor times the diffuse horizontal illuminance",
    .source = "GEEBELEN",
    .assumptions = "sunlight is ignored",
    .formulae = formulae_of_diffuse,
    .evaluate = evaluate_df_diffuse,
};

const struct pp_year_method pp_year_method_df_global = {
    .name = "df-global",
    .summary = "daylight factor times the global horizontal illuminance",
    .source = "GEEBELEN",
    .assumptions = "sunlight counts as light from an overcast sky",
    .formulae = formulae_of_global,
    .evaluate = evaluate_df_global,
};

const struct pp_year_method pp_year_method_df_orientation = {
    .name = "df-orientation",
    .summary = "daylight factor times diffuse illuminance times an orientation factor",
    .source = "HUNT79",
    .assumptions =
        "factors 1.2 facing the equator, 1.0 east and west, 0.77 facing the "
        "pole, for diffuse light in the United Kingdom; linear between these "
        "orientations, weighted by the area of the glass. Other sources give "
        "1.20 to 1.67, 1.00 to 1.25 and 0.77 to 0.97",
    .formulae = formulae_of_orientation,
    .refuses = refuses_orientation,
    .prepare = prepare_orientation,
    .evaluate = evaluate_df_orientation,
};
