/* year_doe2.c - `doe2`: clear and overcast skies mixed by cloud cover, with factors
 * interpolated between 20 positions of the sun, as in DOE-2 [WS85].
 *
 * Positions: azimuths of -110 to 110 degrees from the direction of the equator in steps
 * of 55, altitudes of 10 degrees to the greatest of the year in three steps. For a sun
 * outside this range, the factors at the edge of the range are used. Factors are
 * illuminances divided by the horizontal illuminance from the sky, or from the sun.
 * DOE-2 itself calculated the factors by split flux; here they are simulated.
 */
#include <math.h>
#include <stdlib.h>

#include "model/geometry/min_max.h"
#include "studies/year/hand/year_terms.h"

enum { AZIMUTHS = 5, ALTITUDES = 4 };
static const double AZIMUTH_FIRST = -110.0 * PP_RAD, AZIMUTH_STEP = 55.0 * PP_RAD;
static const double ALTITUDE_FIRST = 10.0 * PP_RAD, ALTITUDE_LEAST_STEP = 1.0 * PP_RAD;

struct doe2_tools {
    double step_rad; /* step between altitudes */
    int clear[ALTITUDES][AZIMUTHS], sun[ALTITUDES][AZIMUTHS];
};

#define OF_CORNERS(c)                                                                  \
    {"u", PP_UNIT_NUMBER, "place between two azimuths"},                               \
        {"v", PP_UNIT_NUMBER, "place between two altitudes"},                          \
        {c "_1", PP_UNIT_DAYLIGHT_FACTOR, "factor at the first azimuth and altitude"}, \
        {c "_2", PP_UNIT_DAYLIGHT_FACTOR, "factor at the next azimuth"},               \
        {c "_3", PP_UNIT_DAYLIGHT_FACTOR, "factor at the next altitude"},              \
    {                                                                                  \
        c "_4", PP_UNIT_DAYLIGHT_FACTOR, "factor at both next"                         \
    }
static const struct pp_formula_quantity of_clear[] = {OF_CORNERS("c"), {0}};
static const struct pp_formula_quantity of_corners_sun[] = {OF_CORNERS("s"), {0}};
static const struct pp_formula_quantity of_mixture[] = {
    PP_YEAR_TERMS_D,
    PP_YEAR_TERMS_E_D,
    PP_YEAR_TERMS_E_S,
    {"n", PP_UNIT_NUMBER, "cloud cover"},
    {"d_c", PP_UNIT_DAYLIGHT_FACTOR, "factor under the clear sky"},
    {"d_s", PP_UNIT_DAYLIGHT_FACTOR, "factor for the sun"},
    {0}};

static const struct pp_formula clear_factor = {
    .symbol = "d_c",
    .sum = "(1 - u) (1 - v) c_1 + u (1 - v) c_2 + (1 - u) v c_3 + u v c_4",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "WS85",
    .what = "factor under the clear sky",
    .quantities = of_clear,
    .fixed = true};
static const struct pp_formula sun_factor = {
    .symbol = "d_s",
    .sum = "(1 - u) (1 - v) s_1 + u (1 - v) s_2 + (1 - u) v s_3 + u v s_4",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "WS85",
    .what = "factor for the sun",
    .quantities = of_corners_sun,
    .fixed = true};
static const struct pp_formula mixture = {
    .symbol = "E",
    .sum = "((1 - n) d_c + n D) E_d / 100 + d_s E_s / 100",
    .unit = PP_UNIT_LUX,
    .source = "WS85",
    .what = "illuminance",
    .quantities = of_mixture,
    .fixed = true};
static const struct pp_formula *const formulae[] = {&pp_year_terms_sun, &clear_factor,
                                                    &sun_factor, &mixture, NULL};

static const char *refuses_doe2(const struct pp_hand_case *of)
{
    for (int i = 0; i < of->hour_count; i++)
        if (isnan(of->hours[i].cloud_cover))
            return "the weather file has no total sky cover (field 23) in hours with "
                   "daylight";
    return NULL;
}

static enum pp_status prepare_doe2(void **tools, struct pp_hand_case *of,
                                   struct pp_error *err)
{
    struct doe2_tools *t = calloc(1, sizeof *t);
    if (!t)
        return pp_fail_memory(err);
    double greatest = 0.0, toward = of->southern ? 1.0 : -1.0;
    for (int i = 0; i < of->hour_count; i++)
        greatest = fmax(greatest, of->hours[i].altitude_rad);
    t->step_rad =
        fmax(ALTITUDE_LEAST_STEP, (greatest - ALTITUDE_FIRST) / (ALTITUDES - 1));
    for (int k = 0; k < ALTITUDES; k++)
        for (int i = 0; i < AZIMUTHS; i++) {
            double h = fmin(ALTITUDE_FIRST + k * t->step_rad, 0.5 * PP_PI);
            double az = AZIMUTH_FIRST + i * AZIMUTH_STEP;
            struct pp_vec3 sun =
                pp_vec(-sin(az) * cos(h), toward * cos(az) * cos(h), sin(h));
            t->clear[k][i] =
                pp_reference_skies_add_standard(&of->skies, PP_STANDARD_CLEAR, sun);
            t->sun[k][i] = pp_reference_skies_add_sun(&of->skies, sun);
        }
    *tools = t;
    return PP_OK;
}

/* Records the factors of the four positions around the sun. */
static void put_corners(struct pp_worksheet *sheet, const struct pp_hand_case *of,
                        int point, const struct doe2_tools *t, int k, int i)
{
    static const char *const clear[4] = {"c_1", "c_2", "c_3", "c_4"};
    static const char *const sun[4] = {"s_1", "s_2", "s_3", "s_4"};
    for (int n = 0; n < 4; n++) {
        int row = k + n / 2, column = i + n % 2;
        double h = ALTITUDE_FIRST + row * t->step_rad;
        double az = (AZIMUTH_FIRST + column * AZIMUTH_STEP) / PP_RAD;
        pp_worksheet_put(
            sheet, PP_UNIT_DAYLIGHT_FACTOR,
            pp_reference_skies_factor(&of->skies, point, t->clear[row][column]),
            clear[n], "clear sky, sun at azimuth %.0f and altitude %.1f degrees", az,
            h / PP_RAD);
        pp_worksheet_put(
            sheet, PP_UNIT_DAYLIGHT_FACTOR,
            pp_reference_skies_factor(&of->skies, point, t->sun[row][column]) / sin(h),
            sun[n], "sun at azimuth %.0f and altitude %.1f degrees", az, h / PP_RAD);
    }
}

static void evaluate_doe2(const struct pp_hand_case *of, const void *tools, int point,
                          const struct pp_hand_hour *hour, struct pp_worksheet *sheet,
                          struct pp_year_states *states)
{
    const struct doe2_tools *t = tools;
    double u = pp_clamp((hour->azimuth_rad - AZIMUTH_FIRST) / AZIMUTH_STEP, 0.0,
                        AZIMUTHS - 1.0);
    double v = pp_clamp((hour->altitude_rad - ALTITUDE_FIRST) / t->step_rad, 0.0,
                        ALTITUDES - 1.0);
    int i = u < AZIMUTHS - 1 ? (int)u : AZIMUTHS - 2;
    int k = v < ALTITUDES - 1 ? (int)v : ALTITUDES - 2;
    pp_year_terms_put_df(sheet, of, point);
    pp_year_terms_put_sky(sheet, hour);
    pp_year_terms_work_sun(sheet, hour);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, hour->cloud_cover, "n", "cloud cover");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, u - i, "u", "place between two azimuths");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, v - k, "v", "place between two altitudes");
    put_corners(sheet, of, point, t, k, i);
    pp_worksheet_work(sheet, &clear_factor, "factor under the clear sky");
    pp_worksheet_work(sheet, &sun_factor, "factor for the sun");
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &mixture, "illuminance"));
}

const struct pp_year_method pp_year_method_doe2 = {
    .name = "doe2",
    .summary = "clear and overcast sky mixed by cloud cover, factors interpolated "
               "between 20 positions of the sun",
    .source = "WS85",
    .assumptions = "the cloud cover is the total sky cover of the weather file. Both "
                   "skies have the diffuse illuminance of the hour. Azimuths extend to "
                   "110 degrees from the direction of the equator, altitudes from 10 "
                   "degrees to the greatest of the year",
    .formulae = formulae,
    .refuses = refuses_doe2,
    .prepare = prepare_doe2,
    .evaluate = evaluate_doe2,
};
