/* year_rule.c - `df-rule`: the daylight factor times diffuse illuminance and illuminance
 * from the sun, each with a factor that depends on the orientation of the facade.
 *
 *     E = D (k_d E_d + k_s E_s)
 *
 * The method was developed for this program. k_d and k_s give the least mean absolute
 * error of daylight autonomy at 200, 300, 500 and 750 lx in 8 rooms in three climates
 * (bench/year_methods.sh).
 */
#include <math.h>
#include <stdlib.h>

#include "studies/year/hand/year_terms.h"

/* Facades that face the equator, east, the pole, west. */
static const double diffuse_factors[4] = {1.25, 1.05, 1.10, 1.35};
static const double sun_factors[4] = {1.15, 0.90, 0.50, 0.70};

struct rule_tools {
    double k_d, k_s;
};

static const struct pp_formula_quantity of_rule[] = {
    PP_YEAR_TERMS_D,
    PP_YEAR_TERMS_E_D,
    PP_YEAR_TERMS_E_S,
    {"k_d", PP_UNIT_NUMBER, "factor of the diffuse illuminance"},
    {"k_s", PP_UNIT_NUMBER, "factor of the illuminance from the sun"},
    {0}};
static const struct pp_formula by_rule = {.symbol = "E",
                                          .sum = "D (k_d E_d + k_s E_s) / 100",
                                          .unit = PP_UNIT_LUX,
                                          .what = "illuminance",
                                          .quantities = of_rule,
                                          .fixed = true};
static const struct pp_formula *const formulae[] = {&pp_year_terms_sun, &by_rule, NULL};

static const char *refuses_rule(const struct pp_hand_case *of)
{
    return pp_hand_case_facade(of) < 0
               ? "the factors of the rule are for windows only, but an opening slopes "
                 "less than 45 degrees, or there are none"
               : NULL;
}

static enum pp_status prepare_rule(void **tools, struct pp_hand_case *of,
                                   struct pp_error *err)
{
    struct rule_tools *t = malloc(sizeof *t);
    if (!t)
        return pp_fail_memory(err);
    t->k_d = pp_hand_case_by_facade(of, diffuse_factors);
    t->k_s = pp_hand_case_by_facade(of, sun_factors);
    *tools = t;
    return PP_OK;
}

static void evaluate_rule(const struct pp_hand_case *of, const void *tools, int point,
                          const struct pp_hand_hour *hour, struct pp_worksheet *sheet,
                          struct pp_year_states *states)
{
    const struct rule_tools *t = tools;
    pp_year_terms_put_df(sheet, of, point);
    pp_year_terms_put_sky(sheet, hour);
    pp_year_terms_work_sun(sheet, hour);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, t->k_d, "k_d",
                     "factor of the diffuse illuminance, by orientation");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, t->k_s, "k_s",
                     "factor of the illuminance from the sun, by orientation");
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &by_rule, "illuminance"));
}

const struct pp_year_method pp_year_method_df_rule = {
    .name = "df-rule",
    .summary =
        "daylight factor times diffuse illuminance and illuminance from the sun, "
        "with factors by orientation",
    .source = "ATLAS",
    .assumptions =
        "factors of this program, fitted to daylight autonomies of 8 rooms in three "
        "climates at 34 to 42 degrees north; linear between the "
        "orientations, weighted by the area of the glass",
    .formulae = formulae,
    .refuses = refuses_rule,
    .prepare = prepare_rule,
    .evaluate = evaluate_rule,
};
