/* sunshine.h - probability of sunshine while the sun is above the horizon, by month and
 * hour of solar time, from a weather file.
 *
 * The sun shines if its irradiance on a plane normal to its direction is more than 120
 * W/m2 [WMO8]. A record contains only the mean irradiance, so the whole record is
 * either sunny or not sunny.
 */
#ifndef PP_STUDIES_CLIMATE_SUNSHINE_H
#define PP_STUDIES_CLIMATE_SUNSHINE_H

#include "formats/epw/epw.h"

#define PP_SUNSHINE_W_M2 120.0 /* direct normal irradiance above which the sun shines */

enum { PP_SUNSHINE_MONTHS = 12, PP_SUNSHINE_HOURS = 24 };

struct pp_sunshine {
    bool known; /* false: no record has sunshine, for example because the file has no
                 * direct irradiance */
    /* Fraction of the records with sunshine among those with the sun above the horizon
     * at their middle; 0 if there are no such records. January is first. Hour 0 begins
     * at solar midnight, hour 12 at noon. */
    double share[PP_SUNSHINE_MONTHS][PP_SUNSHINE_HOURS];
};

struct pp_sunshine pp_sunshine_of_epw(const struct pp_epw *epw);

#endif
