/* sunshine.h - how likely the sun is to shine while it is above the horizon, by the month
 * and the hour of solar time, as a weather file has it.
 *
 * The sun shines where its irradiance of a plane square to it is more than 120 W/m2
 * [WMO8]; of a record that is its mean, so that a record counts in whole or not.
 */
#ifndef PP_STUDIES_CLIMATE_SUNSHINE_H
#define PP_STUDIES_CLIMATE_SUNSHINE_H

#include "formats/epw/epw.h"

enum { PP_SUNSHINE_MONTHS = 12, PP_SUNSHINE_HOURS = 24 };

struct pp_sunshine {
    bool known; /* false: the file has no direct irradiance, or no sun */
    /* January first; hour 0 begins at solar midnight, 12 at noon. Of the records in the
     * middle of which the sun is up, the share with sunshine; 0 where there are none. */
    double share[PP_SUNSHINE_MONTHS][PP_SUNSHINE_HOURS];
};

struct pp_sunshine pp_sunshine_of_epw(const struct pp_epw *epw);

#endif
