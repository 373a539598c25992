/* working_hours.h - the hours in which daylight is wanted.
 *
 * They are hours of the clock on the wall: local standard time, and an hour ahead of it
 * on the days of summer time.
 */
#ifndef PP_STUDIES_CLIMATE_WORKING_HOURS_H
#define PP_STUDIES_CLIMATE_WORKING_HOURS_H

#include "studies/climate/diffuse_light.h"

enum { PP_ALL_DAYS = 0x7F }; /* bit 0 Monday to bit 6 Sunday */

struct pp_working_hours {
    double from_h, to_h; /* 0 to 24, from before to */
    unsigned days;       /* bits of the days of the week */
};

/* From the first day to the last, over the new year where that is before it in the
 * year; month 0: none. */
struct pp_summer_time {
    struct pp_month_day from, to;
};

/* How much of a stretch of time, of one hour at most and within one hour of the clock,
 * is working time (h). A day of the week that is not known is any. */
double pp_working_hours_share_h(const struct pp_working_hours *hours,
                                const struct pp_summer_time *summer,
                                const struct pp_diffuse_hour *hour);

#endif
