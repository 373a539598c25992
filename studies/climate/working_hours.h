/* working_hours.h - the hours of the day and the days of the week in which daylight is
 * needed.
 *
 * Hours are clock time: local standard time, and on the days of summer time an hour
 * ahead of standard time. */
#ifndef PP_STUDIES_CLIMATE_WORKING_HOURS_H
#define PP_STUDIES_CLIMATE_WORKING_HOURS_H

#include "studies/climate/diffuse_light.h"

enum { PP_ALL_DAYS = 0x7F }; /* bit 0 Monday to bit 6 Sunday */

struct pp_working_hours {
    double from_h, to_h; /* 0 to 24, from before to */
    unsigned days;       /* bits of the days of the week */
};

/* The days of summer time, from the first to the last, both included. If the last is
 * earlier in the year than the first, the period extends over the new year. from.month
 * 0: there is no summer time. */
struct pp_summer_time {
    struct pp_month_day from, to;
};

/* The working time in a stretch of time (h); the stretch is an hour long at most and
 * lies within one hour of the clock. A weekday that is not known counts as one of
 * `hours`. */
double pp_working_hours_share_h(const struct pp_working_hours *hours,
                                const struct pp_summer_time *summer,
                                const struct pp_diffuse_hour *hour);

#endif
