/* sun.c - the almanac's steps: the sun's ecliptic longitude, its right ascension and
 * declination, and from sidereal time its hour angle and position above the horizon
 * [MIC88]:
 *
 *     L  = 280.460 + 0.9856474 n                    mean longitude (degrees)
 *     g  = 357.528 + 0.9856003 n                    mean anomaly
 *     l  = L + 1.915 sin g + 0.020 sin 2g           ecliptic longitude
 *     ep = 23.439 - 0.0000004 n                     obliquity of the ecliptic
 *
 *     tan ra  = cos ep sin l / cos l
 *     sin dec = sin ep sin l
 *
 *     sin altitude = sin dec sin latitude + cos dec cos latitude cos ha
 *
 * n is in days since noon of 1 January 2000; ha is the hour angle.
 */
#include "model/light/sun.h"

#include <math.h>

#include "model/geometry/vec.h"

/* Solar parallax: 8.794 seconds of arc at the sun's mean distance. */
static const double PARALLAX = 8.794 / 3600.0 * PP_RAD;

double pp_sun_days_since_2000(int year, int month, int day, double hour_ut)
{
    /* Days since 1 March of year 0; years begin in March [MEEUS98]. */
    int y = month > 2 ? year : year - 1;
    int m = month > 2 ? month - 3 : month + 9;
    int days = 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1;
    enum { FIRST_JANUARY_2000 = 730425 };
    return days - FIRST_JANUARY_2000 + (hour_ut - 12.0) / 24.0;
}

/* Reduces a value by whole turns to 0 ... `whole`. */
static double wrapped(double value, double whole)
{
    return value - whole * floor(value / whole);
}

struct pp_sun pp_sun_at(double n, double latitude_rad, double longitude_rad)
{
    /* Position on the ecliptic: mean longitude L, mean anomaly g, longitude l,
     * obliquity ep. */
    double L = 280.460 + 0.9856474 * n;
    double g = (357.528 + 0.9856003 * n) * PP_RAD;
    double l = (L + 1.915 * sin(g) + 0.020 * sin(2.0 * g)) * PP_RAD;
    double ep = (23.439 - 0.0000004 * n) * PP_RAD;

    /* Right ascension and declination. */
    double ra = atan2(cos(ep) * sin(l), cos(l));
    double dec = asin(sin(ep) * sin(l));

    /* Hour angle from Greenwich sidereal time (hours). */
    double hour_ut = 24.0 * wrapped(n + 0.5, 1.0);
    double gmst = 6.697375 + 0.0657098242 * n + hour_ut;
    double ha = gmst * 15.0 * PP_RAD + longitude_rad - ra;

    struct pp_sun sun = {.declination_rad = dec};
    double sin_altitude =
        sin(dec) * sin(latitude_rad) + cos(dec) * cos(latitude_rad) * cos(ha);
    sun.altitude_rad = asin(fmax(-1.0, fmin(1.0, sin_altitude)));
    double north =
        sin(dec) * cos(latitude_rad) - cos(dec) * sin(latitude_rad) * cos(ha);
    double east = -cos(dec) * sin(ha);
    sun.bearing_rad = wrapped(atan2(east, north), 2.0 * PP_PI);
    sun.distance_au = 1.00014 - 0.01671 * cos(g) - 0.00014 * cos(2.0 * g);

    /* Parallax: the sun appears lower from the earth's surface than from its centre. */
    sun.altitude_rad -= PARALLAX / sun.distance_au * cos(sun.altitude_rad);
    return sun;
}
