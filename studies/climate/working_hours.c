/* working_hours.c - converts standard time to clock time, and finds the overlap with
 * working hours. */
#include "studies/climate/working_hours.h"

#include <math.h>

/* A number that increases through the year, by 1 from day to day within a month. */
static int day_number(struct pp_month_day date)
{
    return 32 * date.month + date.day;
}

static bool is_summer(const struct pp_summer_time *summer, struct pp_month_day date)
{
    if (summer->from.month == 0)
        return false;
    int day = day_number(date), from = day_number(summer->from),
        to = day_number(summer->to);
    return from <= to ? day >= from && day <= to : day >= from || day <= to;
}

double pp_working_hours_share_h(const struct pp_working_hours *hours,
                                const struct pp_summer_time *summer,
                                const struct pp_diffuse_hour *hour)
{
    double start_h = hour->start_h + (is_summer(summer, hour->date) ? 1.0 : 0.0);
    int weekday = hour->weekday;
    if (start_h >= 24.0) {
        start_h -= 24.0;
        weekday = weekday == PP_WEEKDAY_UNKNOWN ? weekday : (weekday + 1) % 7;
    }
    if (weekday != PP_WEEKDAY_UNKNOWN && !(hours->days >> weekday & 1))
        return 0.0;
    double from_h = fmax(start_h, hours->from_h);
    double to_h = fmin(start_h + hour->length_h, hours->to_h);
    return fmax(0.0, to_h - from_h);
}
