/* sun_path.c - the sun's direction as a rotation about the earth's axis. */
#include "model/light/sun_path.h"

#include <math.h>

#include "model/light/sun.h"

struct pp_vec3 pp_sun_path_direction(double latitude, double declination,
                                     double hour_angle)
{
    double south = cos(declination) * cos(hour_angle); /* equatorial component */
    return pp_vec(-cos(declination) * sin(hour_angle),
                  sin(declination) * cos(latitude) - south * sin(latitude),
                  sin(declination) * sin(latitude) + south * cos(latitude));
}

double pp_sun_path_sunset(double latitude, double declination)
{
    double c = -tan(latitude) * tan(declination);
    return c >= 1.0 ? 0.0 : c <= -1.0 ? PP_PI : acos(c);
}

double pp_sun_path_declination(int month, int day)
{
    return pp_sun_at(pp_sun_days_since_2000(2025, month, day, 12.0), 0.0, 0.0)
        .declination_rad;
}
