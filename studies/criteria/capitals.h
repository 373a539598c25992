/* capitals.h - the median diffuse illuminance outside at a site, by the table of
 * capitals in [EN17037].
 */
#ifndef PP_STUDIES_CRITERIA_CAPITALS_H
#define PP_STUDIES_CRITERIA_CAPITALS_H

#include <stdbool.h>

/* Diffuse horizontal illuminance exceeded in half of the year's daylight hours at a
 * site, E_v,d,med of [EN17037]. */
struct pp_median {
    double lux;    /* NAN: not known */
    char how[200]; /* where it comes from ("London, 12 km away"), or why it is not
                    * known, as a sentence without a full stop */
};

/* A capital of [EN17037] table A.3. */
struct pp_capital {
    const char *name;
    double latitude_deg, longitude_deg;
    double median_lux;
    double target_300_percent; /* as printed: 300 lx over median_lux */
    const char *country;       /* two letters */
    bool recalled_only;        /* from memory: no second list was available */
};

int pp_capitals_count(void);
const struct pp_capital *pp_capitals_at(int index);

/* The capital of that name, upper and lower case alike; NULL where there is none. */
const struct pp_capital *pp_capitals_find(const char *name);

/* The capital of a country, by its two letters; NULL: the table has none. */
const struct pp_capital *pp_capitals_of_country(const char *country);

/* Angle at the earth's centre between a place and the capital; radians, all of them. */
double pp_capitals_apart_rad(const struct pp_capital *capital, double latitude_rad,
                             double longitude_rad);

/* The median illuminance of a site: that of its country's capital, as the table goes by
 * nation. Where country is empty or has no capital in the table, that of the nearest
 * capital by great circle, and `how` warns of it, if it is within 1000 km; for a site
 * without longitude that of the capital whose latitude is nearest, if it is within 2.5
 * degrees. Angles in radians, NAN where not known. lux is
 * NAN where no capital is near, and `how` says why. */
struct pp_median pp_capitals_median(double latitude_rad, double longitude_rad,
                                    const char *country);

#endif
