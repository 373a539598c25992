/* capitals.h - the median diffuse illuminance of a place, by the table of capitals in
 * EN 17037.
 */
#ifndef PP_STUDIES_CRITERIA_CAPITALS_H
#define PP_STUDIES_CRITERIA_CAPITALS_H

#include "studies/criteria/criterion.h"

/* A capital of [EN17037] table A.3. */
struct pp_capital {
    const char *name;
    double latitude_deg, longitude_deg;
    double median_lux;
    double target_300_percent; /* as printed: 300 lx over median_lux */
};

int pp_capitals_count(void);
const struct pp_capital *pp_capitals_at(int index);

/* The capital of that name, whatever its capitals; NULL where there is none. */
const struct pp_capital *pp_capitals_find(const char *name);

/* The median illuminance of a site: that of the nearest capital by great circle, if it
 * is within 1000 km; of a site with a latitude only, of the capital whose latitude is
 * nearest, if that is within 2.5 degrees. Angles in radians, NAN where not known. lux
 * is NAN where nothing is near, and `how` says why. */
struct pp_median pp_capitals_median(double latitude_rad, double longitude_rad);

#endif
