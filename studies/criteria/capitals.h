/* capitals.h - the median diffuse illuminance outside at a site, from the table of
 * capitals in [EN17037]. */
#ifndef PP_STUDIES_CRITERIA_CAPITALS_H
#define PP_STUDIES_CRITERIA_CAPITALS_H

#include <stdbool.h>

/* Diffuse horizontal illuminance exceeded in half of the year's daylight hours at a
 * site, E_v,d,med of [EN17037]. */
struct pp_median {
    double lux;    /* NAN: not known */
    char how[200]; /* origin ("London, 12 km away"), or the reason why it is not
                    * known, as a sentence without a full stop */
};

/* A capital of [EN17037] table A.3. */
struct pp_capital {
    const char *name;
    double latitude_deg, longitude_deg;
    double median_lux;
    double target_300_percent; /* as printed: 300 lx over median_lux */
    const char *country;       /* country code, two letters */
    bool recalled_only;        /* true: value not checked against the standard or
                                * another list */
};

int pp_capitals_count(void);
const struct pp_capital *pp_capitals_at(int index);

/* The capital of that name, in upper or lower case; NULL: none. */
const struct pp_capital *pp_capitals_find(const char *name);

/* The capital of a country, by its two letters; NULL: the table has none. */
const struct pp_capital *pp_capitals_of_country(const char *country);

/* Angle at the earth's centre between a place and the capital. All angles in
 * radians. */
double pp_capitals_apart_rad(const struct pp_capital *capital, double latitude_rad,
                             double longitude_rad);

/* The median illuminance of a site. The table is arranged by nation, so the value is
 * that of the country's capital. If the country is empty or has no capital in the
 * table, the value is that of the nearest capital within 1000 km by great circle, and
 * `how` has a warning. For a site without longitude, the value is that of the capital
 * with the nearest latitude, within 2.5 degrees. Angles in radians, NAN if unknown. lux
 * is NAN if there is no such capital, with the reason in `how`. */
struct pp_median pp_capitals_median(double latitude_rad, double longitude_rad,
                                    const char *country);

#endif
