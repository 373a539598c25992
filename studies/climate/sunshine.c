/* sunshine.c - see sunshine.h. */
#include "studies/climate/sunshine.h"

#include <math.h>

#include "model/geometry/vec.h"
#include "model/light/sun.h"

/* Hour of solar time, from the hour angle h. At the equator the sun is at (-sin h, cos
 * h) in the plane of east and zenith, if its declination is neglected. */
static int solar_hour(double days_since_2000, double longitude_rad)
{
    struct pp_sun sun = pp_sun_at(days_since_2000, 0.0, longitude_rad);
    double h =
        atan2(-cos(sun.altitude_rad) * sin(sun.bearing_rad), sin(sun.altitude_rad));
    int hour = (int)floor(12.0 + h * 12.0 / PP_PI);
    return hour < 0 ? 0 : hour > 23 ? 23 : hour;
}

struct pp_sunshine pp_sunshine_of_epw(const struct pp_epw *epw)
{
    struct pp_sunshine sunshine = {.known = false};
    int up[PP_SUNSHINE_MONTHS][PP_SUNSHINE_HOURS] = {{0}};
    for (int i = 0; i < epw->record_count; i++) {
        const struct pp_epw_record *record = &epw->records[i];
        double middle_h = record->start_h + 0.5 * epw->record_h - epw->time_zone_h;
        double n = pp_sun_days_since_2000(record->year, record->date.month,
                                          record->date.day, middle_h);
        struct pp_sun sun = pp_sun_at(n, epw->latitude_rad, epw->longitude_rad);
        if (isnan(record->direct_w_m2) || sun.altitude_rad <= 0.0)
            continue;
        int month = record->date.month - 1, hour = solar_hour(n, epw->longitude_rad);
        bool shines = record->direct_w_m2 > PP_SUNSHINE_W_M2;
        up[month][hour]++;
        sunshine.share[month][hour] += shines;
        sunshine.known |= shines;
    }
    for (int m = 0; m < PP_SUNSHINE_MONTHS; m++)
        for (int h = 0; h < PP_SUNSHINE_HOURS; h++)
            sunshine.share[m][h] /= up[m][h] > 0 ? up[m][h] : 1;
    return sunshine;
}
