/* sunshine.h - probability of sunshine while the sun is above the horizon, by month and
 * hour of solar time, from a weather file.
 *
 * The sun shines if its irradiance on a plane normal to its direction is more than 120
 * W/m2 [WMO8]. A record has only the mean irradiance, so it counts as wholly
 * sunny or not at all.
 */
#ifndef PP_STUDIES_CLIMATE_SUNSHINE_H
#define PP_STUDIES_CLIMATE_SUNSHINE_H

#include "formats/epw/epw.h"

#define PP_SUNSHINE_W_M2 120.0 /* direct normal irradiance above which the sun shines */

enum { PP_SUNSHINE_MONTHS = 12, PP_SUNSHINE_HOURS = 24 };

struct pp_sunshine {
    bool known; /* false: the file has no direct irradiance, or no sun */
    /* Share of records with sunshine, of those with the sun up at their middle; 0 if
     * there are none. January first; hour 0 begins at solar midnight, 12 at noon. */
    double share[PP_SUNSHINE_MONTHS][PP_SUNSHINE_HOURS];
};

struct pp_sunshine pp_sunshine_of_epw(const struct pp_epw *epw);

#endif
