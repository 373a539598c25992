/* moment.h - the illuminances of a room's points in one hour of a weather file. */
#ifndef PP_STUDIES_YEAR_MOMENT_H
#define PP_STUDIES_YEAR_MOMENT_H

#include "studies/year/annual.h"

/* Fills the sheet of a year that has this hour alone: illuminances are its year_lxh, and
 * sky_lxh, sun_lxh, sun_reflected_lxh its parts. clock_h: local standard time. The caller
 * clears *sheet, after a failure too. PP_BAD_INPUT where the hour is dark or not known. */
enum pp_status pp_moment_of_room(
    struct pp_annual_sheet *sheet, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_receiver *receivers,
    int receiver_count, const struct pp_weather_year *year, struct pp_month_day date,
    double clock_h, const struct pp_annual_options *options, struct pp_error *err);

#endif
