/* sun.h - position of the sun.
 *
 * Low-precision formulae of the Astronomical Almanac, from [MIC88]: within 0.01 degrees
 * from 1950 to 2050, and 0.02 from 1800 to 2200. Refraction is not included; it raises
 * the sun by half a degree at the horizon and by less than 0.1 degrees above 10
 * degrees.
 */
#ifndef PP_MODEL_LIGHT_SUN_H
#define PP_MODEL_LIGHT_SUN_H

struct pp_sun {
    double altitude_rad; /* altitude of the sun's centre; negative: below the horizon */
    double bearing_rad;  /* clockwise from north, 0 to 2 pi */
    double declination_rad;
    double distance_au; /* distance from the earth in astronomical units */
};

/* Days since noon of 1 January 2000 for a day of the Gregorian calendar and an hour,
 * both in universal time; the hour may be outside 0 to 24. */
double pp_sun_days_since_2000(int year, int month, int day, double hour_ut);

/* Position of the sun; latitude north and longitude east are positive (rad). */
struct pp_sun pp_sun_at(double days_since_2000, double latitude_rad,
                        double longitude_rad);

#endif
