/* year_adeline.c - `adeline` and `adeline-mean`: a clear sky with sun and an overcast sky
 * at the mean position of the sun for each month and hour, as in ADELINE's SUPERLINK
 * [SZER94].
 *
 * Each state has its own mean illuminances outside. `adeline` gives each state its
 * probability; `adeline-mean` gives the mean of the two illuminances. It is not
 * established which of the two ADELINE used.
 */
#include <stdlib.h>

#include "studies/year/hand/monthly_suns.h"
#include "studies/year/hand/year_terms.h"

struct adeline_tools {
    struct pp_monthly_suns suns;
    int clear[PP_MONTHLY_SUNS];
    int sun[PP_MONTHLY_SUNS];
};

static const struct pp_formula_quantity of_clear_state[] = {
    {"d_c", PP_UNIT_DAYLIGHT_FACTOR, "factor under the clear sky"},
    {"d_n", PP_UNIT_DAYLIGHT_FACTOR, "factor for the sun, normal to its rays"},
    {"E_dc", PP_UNIT_LUX, "mean external diffuse illuminance in sunny hours"},
    {"E_nc", PP_UNIT_LUX,
     "mean illuminance from the sun, normal to its rays, in sunny hours"},
    {0}};
static const struct pp_formula_quantity of_overcast_state[] = {
    PP_YEAR_TERMS_D,
    {"E_do", PP_UNIT_LUX, "mean external diffuse illuminance in hours without sun"},
    {0}};
static const struct pp_formula_quantity of_both_states[] = {
    {"p", PP_UNIT_NUMBER, "probability of sunshine"},
    {"E_c", PP_UNIT_LUX, "illuminance in sunny hours"},
    {"E_o", PP_UNIT_LUX, "illuminance in hours without sun"},
    {0}};

static const struct pp_formula clear_state = {.symbol = "E_c",
                                              .sum = "(d_c E_dc + d_n E_nc) / 100",
                                              .unit = PP_UNIT_LUX,
                                              .source = "SZER94",
                                              .what = "illuminance in sunny hours",
                                              .quantities = of_clear_state,
                                              .fixed = true};
static const struct pp_formula overcast_state = {.symbol = "E_o",
                                                 .sum = "D E_do / 100",
                                                 .unit = PP_UNIT_LUX,
                                                 .source = "SZER94",
                                                 .what =
                                                     "illuminance in hours without sun",
                                                 .quantities = of_overcast_state,
                                                 .fixed = true};
static const struct pp_formula mean_state = {.symbol = "E",
                                             .sum = "p E_c + (1 - p) E_o",
                                             .unit = PP_UNIT_LUX,
                                             .source = "SZER94",
                                             .what = "illuminance",
                                             .quantities = of_both_states,
                                             .fixed = true};

static const struct pp_formula *const formulae[] = {&clear_state, &overcast_state,
                                                    NULL};
static const struct pp_formula *const formulae_of_mean[] = {
    &clear_state, &overcast_state, &mean_state, NULL};

static enum pp_status prepare_adeline(void **tools, struct pp_hand_case *of,
                                      struct pp_error *err)
{
    struct adeline_tools *t = calloc(1, sizeof *t);
    if (!t)
        return pp_fail_memory(err);
    pp_monthly_suns_fill(&t->suns, of);
    for (int i = 0; i < PP_MONTHLY_SUNS; i++) {
        const struct pp_monthly_sun *sun = &t->suns.list[i];
        bool used = sun->is_up && sun->sunny_h > 0.0;
        t->clear[i] = used ? pp_reference_skies_add_standard(
                          &of->skies, PP_STANDARD_CLEAR, sun->sun)
                           : -1;
        t->sun[i] = used ? pp_reference_skies_add_sun(&of->skies, sun->sun) : -1;
    }
    *tools = t;
    return PP_OK;
}

static struct pp_year_states work_states(const struct pp_hand_case *of,
                                         const struct adeline_tools *t, int point,
                                         const struct pp_hand_hour *hour,
                                         struct pp_worksheet *sheet)
{
    int i = pp_monthly_suns_index(hour);
    const struct pp_monthly_sun *sun = &t->suns.list[i];
    double p = sun->hours > 0.0 ? sun->sunny_h / sun->hours : 0.0;
    pp_year_terms_put_df(sheet, of, point);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, p, "p",
                     "probability of sunshine in that month and hour");
    pp_year_terms_put_factor(sheet, of, point, t->clear[i], "d_c",
                             "factor under the clear sky");
    pp_year_terms_put_factor(sheet, of, point, t->sun[i], "d_n",
                             "factor for the sun, normal to its rays");
    pp_worksheet_put(sheet, PP_UNIT_LUX, sun->sunny_diffuse_lx, "E_dc",
                     "mean external diffuse illuminance in sunny hours");
    pp_worksheet_put(
        sheet, PP_UNIT_LUX, sun->sunny_direct_lx, "E_nc",
        "mean illuminance from the sun, normal to its rays, in sunny hours");
    pp_worksheet_put(sheet, PP_UNIT_LUX, sun->dull_diffuse_lx, "E_do",
                     "mean external diffuse illuminance in hours without sun");
    double clear_lx =
        pp_worksheet_work(sheet, &clear_state, "illuminance in sunny hours");
    double dull_lx =
        pp_worksheet_work(sheet, &overcast_state, "illuminance in hours without sun");
    return (struct pp_year_states){2, {{p, clear_lx}, {1.0 - p, dull_lx}}};
}

static void evaluate_adeline(const struct pp_hand_case *of, const void *tools,
                             int point, const struct pp_hand_hour *hour,
                             struct pp_worksheet *sheet, struct pp_year_states *states)
{
    *states = work_states(of, tools, point, hour, sheet);
}

static void evaluate_adeline_mean(const struct pp_hand_case *of, const void *tools,
                                  int point, const struct pp_hand_hour *hour,
                                  struct pp_worksheet *sheet,
                                  struct pp_year_states *states)
{
    work_states(of, tools, point, hour, sheet);
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &mean_state, "illuminance"));
}

#define SUNNY                                                                          \
    "hours with more than 120 W/m2 of direct normal irradiance are sunny. "            \
    "Probability of sunshine, position of the sun and external illuminances are "      \
    "means of the same month and time of day in the weather file. "

const struct pp_year_method pp_year_method_adeline = {
    .name = "adeline",
    .summary = "clear sky with sun or overcast sky, by the probability of sunshine in "
               "each month and hour",
    .source = "SZER94",
    .assumptions = (SUNNY "Each state counts with its probability"),
    .formulae = formulae,
    .prepare = prepare_adeline,
    .evaluate = evaluate_adeline,
};

const struct pp_year_method pp_year_method_adeline_mean = {
    .name = "adeline-mean",
    .summary = "the same, with the mean of both illuminances in each month and hour",
    .source = "SZER94",
    .assumptions = (SUNNY "The hour has the mean of both states"),
    .formulae = formulae_of_mean,
    .prepare = prepare_adeline,
    .evaluate = evaluate_adeline_mean,
};
