/* year_four_skies.c - `four-skies`: mixtures of overcast, intermediate, turbid and clear
 * sky by the clearness of the hour, with the sun of a representative day of each month, as
 * in EnergyPlus [EPLUS].
 *
 * s is the fraction of the clearer of two skies in a mixture of luminances, for equal
 * zenith luminances. f is the corresponding fraction of the horizontal illuminance. eps
 * is the clearness, delta the brightness (light/perez_sky.h).
 */
#include <stdlib.h>

#include "studies/year/hand/monthly_suns.h"
#include "studies/year/hand/year_terms.h"

enum { FOUR_SKIES = PP_STANDARD_CLEAR + 1 };
static const double EPS_INTERMEDIATE = 1.2, EPS_TURBID = 3.0;

struct four_skies_tools {
    struct pp_monthly_suns suns;
    int sky[PP_MONTHLY_SUNS][FOUR_SKIES], sun[PP_MONTHLY_SUNS];
    double per_zenith[PP_MONTHLY_SUNS][FOUR_SKIES];
};

static const char *const sky_names[FOUR_SKIES] = {[PP_STANDARD_OVERCAST] = "overcast",
                                                  [PP_STANDARD_INTERMEDIATE] =
                                                      "intermediate",
                                                  [PP_STANDARD_TURBID] = "turbid",
                                                  [PP_STANDARD_CLEAR] = "clear"};

static const struct pp_formula_quantity of_weather[] = {
    {"eps", PP_UNIT_NUMBER, "clearness of the sky"},
    {"delta", PP_UNIT_NUMBER, "brightness of the sky"},
    {0}};
static const struct pp_formula_quantity of_mixture[] = {
    {"s", PP_UNIT_NUMBER, "share of the clearer sky in the luminance"},
    {"Z_a", PP_UNIT_NUMBER,
     "horizontal illuminance over zenith luminance, clearer sky"},
    {"Z_b", PP_UNIT_NUMBER, "horizontal illuminance over zenith luminance, other sky"},
    {0}};
static const struct pp_formula_quantity of_illuminance[] = {
    PP_YEAR_TERMS_E_D,
    PP_YEAR_TERMS_E_S,
    {"f", PP_UNIT_NUMBER, "share of the clearer sky in the illuminance"},
    {"d_a", PP_UNIT_DAYLIGHT_FACTOR, "factor under the clearer sky"},
    {"d_b", PP_UNIT_DAYLIGHT_FACTOR, "factor under the other sky"},
    {"d_s", PP_UNIT_DAYLIGHT_FACTOR, "factor for the sun"},
    {0}};

#define SHARE(text)                                                                    \
    {                                                                                  \
        .symbol = "s", .sum = text, .unit = PP_UNIT_NUMBER, .source = "EPLUS",         \
        .what = "share of the clearer sky in the luminance", .quantities = of_weather, \
        .fixed = true                                                                  \
    }
/* By the pair of skies; the index is that of the less clear one. */
static const struct pp_formula shares[FOUR_SKIES - 1] = {
    [PP_STANDARD_OVERCAST] =
        SHARE("min(1, max(0, (eps - 1) / 0.2, (delta - 0.05) / 0.4))"),
    [PP_STANDARD_INTERMEDIATE] = SHARE("(eps - 1.2) / 1.8"),
    [PP_STANDARD_TURBID] = SHARE("min(1, (eps - 3) / 3)")};
static const struct pp_formula fraction = {
    .symbol = "f",
    .sum = "s Z_a / (s Z_a + (1 - s) Z_b)",
    .unit = PP_UNIT_NUMBER,
    .source = "EPLUS",
    .what = "share of the clearer sky in the illuminance",
    .quantities = of_mixture,
    .fixed = true};
static const struct pp_formula illuminance = {
    .symbol = "E",
    .sum = "(f d_a + (1 - f) d_b) E_d / 100 + d_s E_s / 100",
    .unit = PP_UNIT_LUX,
    .source = "EPLUS",
    .what = "illuminance",
    .quantities = of_illuminance,
    .fixed = true};
static const struct pp_formula *const formulae[] = {
    &pp_year_terms_sun, &shares[0],   &shares[1], &shares[2],
    &fraction,          &illuminance, NULL};

static enum pp_status prepare_four_skies(void **tools, struct pp_hand_case *of,
                                         struct pp_error *err)
{
    struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct four_skies_tools *t = calloc(1, sizeof *t);
    if (!t)
        return pp_fail_memory(err);
    pp_monthly_suns_fill(&t->suns, of);
    for (int i = 0; i < PP_MONTHLY_SUNS; i++) {
        const struct pp_monthly_sun *sun = &t->suns.list[i];
        t->sun[i] = sun->is_up ? pp_reference_skies_add_sun(&of->skies, sun->sun) : -1;
        for (int k = 0; k < FOUR_SKIES; k++) {
            /* Without a sun above the horizon all skies are overcast. */
            enum pp_standard_sky kind =
                sun->is_up ? (enum pp_standard_sky)k : PP_STANDARD_OVERCAST;
            struct pp_perez_sky sky =
                pp_standard_sky_of(kind, sun->is_up ? sun->sun : zenith);
            if (!(sun->hours > 0.0))
                continue;
            t->sky[i][k] = pp_reference_skies_add_standard(&of->skies, kind, sky.sun);
            t->per_zenith[i][k] = pp_standard_sky_per_zenith(&sky);
        }
    }
    *tools = t;
    return PP_OK;
}

static void evaluate_four_skies(const struct pp_hand_case *of, const void *tools,
                                int point, const struct pp_hand_hour *hour,
                                struct pp_worksheet *sheet,
                                struct pp_year_states *states)
{
    const struct four_skies_tools *t = tools;
    int cell = pp_monthly_suns_index(hour);
    const struct pp_monthly_sun *sun = &t->suns.list[cell];
    int b = hour->clearness <= EPS_INTERMEDIATE ? PP_STANDARD_OVERCAST
            : hour->clearness <= EPS_TURBID     ? PP_STANDARD_INTERMEDIATE
                                                : PP_STANDARD_TURBID;
    int a = b + 1;
    double sun_factor = pp_reference_skies_factor(&of->skies, point, t->sun[cell]);
    pp_year_terms_put_sky(sheet, hour);
    pp_year_terms_work_sun(sheet, hour);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, hour->clearness, "eps",
                     "clearness of the sky");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, hour->brightness, "delta",
                     "brightness of the sky");
    pp_worksheet_work(sheet, &shares[b], "share of the %s sky in the luminance",
                      sky_names[a]);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, t->per_zenith[cell][a], "Z_a",
                     "horizontal illuminance over zenith luminance, %s sky",
                     sky_names[a]);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, t->per_zenith[cell][b], "Z_b",
                     "horizontal illuminance over zenith luminance, %s sky",
                     sky_names[b]);
    pp_worksheet_work(sheet, &fraction, "share of the %s sky in the illuminance",
                      sky_names[a]);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_reference_skies_factor(&of->skies, point, t->sky[cell][a]),
                     "d_a", "factor under the %s sky", sky_names[a]);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_reference_skies_factor(&of->skies, point, t->sky[cell][b]),
                     "d_b", "factor under the %s sky", sky_names[b]);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     sun->is_up ? sun_factor / sun->sun.z : 0.0, "d_s",
                     "factor for the sun");
    *states =
        pp_year_terms_state(pp_worksheet_work(sheet, &illuminance, "illuminance"));
}

const struct pp_year_method pp_year_method_four_skies = {
    .name = "four-skies",
    .summary = "mixture of two of four standard skies by clearness, as in EnergyPlus",
    .source = "EPLUS",
    .assumptions =
        "the representative day of each month has the mean position of the "
        "sun at each time of day, from the hours of the weather file. Without "
        "a sun above the horizon the sky is overcast",
    .formulae = formulae,
    .prepare = prepare_four_skies,
    .evaluate = evaluate_four_skies,
};
