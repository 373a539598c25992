/* moment.c - see moment.h. */
#include "studies/year/moment.h"

#include <math.h>

enum pp_status pp_moment_of_room(
    struct pp_annual_sheet *sheet, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_receiver *receivers,
    int receiver_count, const struct pp_weather_year *year, struct pp_month_day date,
    double clock_h, const struct pp_annual_options *options, struct pp_error *err)
{
    struct pp_perez_sky sky;
    *sheet = (struct pp_annual_sheet){.points = NULL};
    enum pp_status status = pp_weather_year_moment(&sky, year, date, clock_h, err);
    if (status != PP_OK)
        return status;
    struct pp_weather_hour hour = {.date = date,
                                   .weekday = PP_WEEKDAY_UNKNOWN,
                                   .start_h = floor(clock_h),
                                   .length_h = 1.0,
                                   .known = true,
                                   .lit = true,
                                   .sky = 0};
    struct pp_weather_year one = *year;
    one.hours = &hour;
    one.skies = &sky;
    one.count = one.sky_count = 1;
    struct pp_annual_options whole = *options;
    whole.hours = (struct pp_working_hours){0.0, 24.0, PP_ALL_DAYS};
    whole.summer = (struct pp_summer_time){{0, 0}, {0, 0}};
    whole.illuminance_count = 1;
    whole.illuminances_lx[0] = 300.0;
    whole.patches = 2305;
    whole.blinds = false;
    return pp_annual_of_room(sheet, world, light, receivers, receiver_count, false,
                             &one, &whole, err);
}
