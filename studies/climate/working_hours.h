/* working_hours.h - the hours of the day and days of the week that a study counts.
 *
 * Hours are in clock time: local standard time or, in summer time, one hour ahead of
 * standard time. */
#ifndef PP_STUDIES_CLIMATE_WORKING_HOURS_H
#define PP_STUDIES_CLIMATE_WORKING_HOURS_H

#include "studies/climate/diffuse_light.h"

enum { PP_ALL_DAYS = 0x7F }; /* bit 0 Monday to bit 6 Sunday */

struct pp_working_hours {
    double from_h, to_h; /* 0 to 24, from_h < to_h */
    unsigned days;       /* bit mask of the days of the week */
};

/* First and last day of summer time, both included. If the last day is earlier in the
 * year than the first, summer time extends over the new year. from.month 0: no summer
 * time. */
struct pp_summer_time {
    struct pp_month_day from, to;
};

/* Working time in a period (h). The period is at most one hour long and lies within one
 * hour of the clock. A day whose weekday is unknown counts as a working day. */
double pp_working_hours_share_h(const struct pp_working_hours *hours,
                                const struct pp_summer_time *summer,
                                const struct pp_diffuse_hour *hour);

#endif
