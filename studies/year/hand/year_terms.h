/* year_terms.h - quantities and formulae common to several hand methods for the year. */
#ifndef PP_STUDIES_YEAR_HAND_YEAR_TERMS_H
#define PP_STUDIES_YEAR_HAND_YEAR_TERMS_H

#include "studies/year/hand/year_method.h"

/* E_d, E_n and E_s are illuminances outside, D is the daylight factor. */
#define PP_YEAR_TERMS_D                                                                \
    {                                                                                  \
        "D", PP_UNIT_DAYLIGHT_FACTOR, "daylight factor"                                \
    }
#define PP_YEAR_TERMS_E_D                                                              \
    {                                                                                  \
        "E_d", PP_UNIT_LUX, "horizontal illuminance from the sky"                      \
    }
#define PP_YEAR_TERMS_E_N                                                              \
    {                                                                                  \
        "E_n", PP_UNIT_LUX, "illuminance from the sun, normal to its rays"             \
    }
#define PP_YEAR_TERMS_E_S                                                              \
    {                                                                                  \
        "E_s", PP_UNIT_LUX, "horizontal illuminance from the sun"                      \
    }
extern const struct pp_formula pp_year_terms_sun; /* E_s = E_n sin(h) */

/* Records D of a point; E_d of an hour; E_s with E_n and h. */
void pp_year_terms_put_df(struct pp_worksheet *sheet, const struct pp_hand_case *of,
                          int point);
void pp_year_terms_put_sky(struct pp_worksheet *sheet, const struct pp_hand_hour *hour);
void pp_year_terms_work_sun(struct pp_worksheet *sheet,
                            const struct pp_hand_hour *hour);

/* Records the factor of a point under a reference sky. */
void pp_year_terms_put_factor(struct pp_worksheet *sheet, const struct pp_hand_case *of,
                              int point, int sky, const char *symbol, const char *what);

/* One state with probability 1. */
struct pp_year_states pp_year_terms_state(double lx);

#endif
