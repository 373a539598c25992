/* year_terms.c - see year_terms.h. */
#include "studies/year/hand/year_terms.h"

static const struct pp_formula_quantity of_sun[] = {
    PP_YEAR_TERMS_E_N, {"h", PP_UNIT_ANGLE, "altitude of the sun"}, {0}};

const struct pp_formula pp_year_terms_sun = {.symbol = "E_s",
                                             .sum = "E_n sin(h)",
                                             .unit = PP_UNIT_LUX,
                                             .what =
                                                 "horizontal illuminance from the sun",
                                             .quantities = of_sun,
                                             .fixed = true};

void pp_year_terms_put_df(struct pp_worksheet *sheet, const struct pp_hand_case *of,
                          int point)
{
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, of->df[point], "D",
                     "daylight factor");
}

void pp_year_terms_put_sky(struct pp_worksheet *sheet, const struct pp_hand_hour *hour)
{
    pp_worksheet_put(sheet, PP_UNIT_LUX, hour->diffuse_lx, "E_d",
                     "horizontal illuminance from the sky");
}

void pp_year_terms_work_sun(struct pp_worksheet *sheet, const struct pp_hand_hour *hour)
{
    pp_worksheet_put(sheet, PP_UNIT_LUX, hour->direct_lx, "E_n",
                     "illuminance from the sun, normal to its rays");
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, hour->altitude_rad, "h",
                     "altitude of the sun");
    pp_worksheet_work(sheet, &pp_year_terms_sun, "horizontal illuminance from the sun");
}

void pp_year_terms_put_factor(struct pp_worksheet *sheet, const struct pp_hand_case *of,
                              int point, int sky, const char *symbol, const char *what)
{
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_reference_skies_factor(&of->skies, point, sky), symbol, "%s",
                     what);
}

struct pp_year_states pp_year_terms_state(double lx)
{
    return (struct pp_year_states){1, {{1.0, lx}}};
}
