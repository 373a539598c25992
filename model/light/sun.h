/* sun.h - position of the sun.
 *
 * The Astronomical Almanac's low-precision formulae, from [MIC88]: within 0.01 degrees
 * from 1950 to 2050, and 0.02 from 1800 to 2200. Refraction, which lifts the sun by
 * half a degree at the horizon and by less than 0.1 above 10 degrees, is left out.
 */
#ifndef PP_MODEL_LIGHT_SUN_H
#define PP_MODEL_LIGHT_SUN_H

struct pp_sun {
    double altitude_rad; /* of its centre above the horizon; negative: below */
    double bearing_rad;  /* clockwise from north, 0 to 2 pi */
    double declination_rad;
    double distance_au; /* from the earth, in mean distances */
};

/* Days since noon of 1 January 2000, of a day of the Gregorian calendar and an hour of
 * it, both in universal time; the hour may lie outside 0 to 24. */
double pp_sun_days_since_2000(int year, int month, int day, double hour_ut);

/* Latitude north and longitude east positive (radians). */
struct pp_sun pp_sun_at(double days_since_2000, double latitude_rad,
                        double longitude_rad);

#endif
