/* test_sun.c - the position of the sun. */
#include "tests/lib/near.h"

#include "model/light/sun.h"
#include "model/geometry/vec.h"

/* Accuracy stated in sun.h. */
static const double almanac = 0.01 * PP_RAD;

/* Example of the solar position algorithm of Reda and Andreas [RA04], table A5.1: 17
 * October 2003, 12:30:30, zone -7, 39.742476 N, 105.1786 W; azimuth 194.34024, altitude
 * without refraction 39.872046 and declination -9.31434 degrees. The example includes
 * parallax, 0.002 degrees. */
static void the_sun_agrees_with_a_far_longer_series(void **state)
{
    (void)state;
    double n = pp_sun_days_since_2000(2003, 10, 17, 12.0 + 30.5 / 60.0 + 7.0);
    struct pp_sun sun = pp_sun_at(n, 39.742476 * PP_RAD, -105.1786 * PP_RAD);
    assert_near(sun.altitude_rad, 39.872046 * PP_RAD, almanac);
    assert_near(sun.bearing_rad, 194.34024 * PP_RAD, almanac);
    assert_near(sun.declination_rad, -9.31434 * PP_RAD, almanac);
    assert_near(sun.distance_au, 0.9965422974,
                1e-4); /* accuracy stated by the Almanac */
}

/* Julian day 2451545.0 is noon of 1 January 2000; 2436116.31 the launch of Sputnik, 4
 * October 1957, 19:26:24 [MEEUS98]. */
static void days_are_counted_from_noon_of_2000(void **state)
{
    (void)state;
    assert_near(pp_sun_days_since_2000(2000, 1, 1, 12.0), 0.0, 0.0);
    assert_near(pp_sun_days_since_2000(1957, 10, 4, 19.44), 2436116.31 - 2451545.0,
                1e-9);
    assert_near(pp_sun_days_since_2000(1900, 3, 1, 0.0)
                    - pp_sun_days_since_2000(1900, 2, 28, 0.0),
                1.0, 0.0);
    assert_near(pp_sun_days_since_2000(2000, 3, 1, 0.0)
                    - pp_sun_days_since_2000(2000, 2, 28, 0.0),
                2.0, 0.0);
}

/* The sun at its highest within half an hour of 12:00 UT, at the longitude of
 * Greenwich. */
static struct pp_sun at_noon(int month, int day, double latitude_rad)
{
    struct pp_sun noon = {.altitude_rad = -PP_PI};
    for (double hour = 11.5; hour < 12.5; hour += 1.0 / 360.0) {
        struct pp_sun sun = pp_sun_at(pp_sun_days_since_2000(2026, month, day, hour),
                                      latitude_rad, 0.0);
        if (sun.altitude_rad > noon.altitude_rad)
            noon = sun;
    }
    return noon;
}

/* The equinox of March 2026 is on the 20th, 14:46 UT: at noon, 2.7 hours earlier, the
 * declination is 2.7 minutes of arc below 0. */
static void at_the_equinox_noon_is_a_right_angle_less_the_latitude(void **state)
{
    (void)state;
    static const double latitudes[] = {51.3, 35.7, 7.9, -33.2, 64.1};
    for (int i = 0; i < 5; i++) {
        double latitude = latitudes[i] * PP_RAD;
        double altitude = PP_PI / 2.0 - fabs(latitude);
        struct pp_sun sun = at_noon(3, 20, latitude);
        assert_near(sun.altitude_rad, altitude, 0.046 * PP_RAD + almanac);
        /* The sun is south of the zenith in the northern hemisphere, north of it in the
         * southern. */
        assert_near(cos(sun.bearing_rad), latitude > 0.0 ? -1.0 : 1.0, 1e-3);
    }
}

/* 23.44 degrees is the obliquity of this century. */
static void at_the_solstices_the_sun_is_above_the_tropics(void **state)
{
    (void)state;
    assert_near(at_noon(6, 21, 0.9).declination_rad, 23.436 * PP_RAD, almanac);
    assert_near(at_noon(12, 21, 0.9).declination_rad, -23.436 * PP_RAD, almanac);
    assert_near(at_noon(6, 21, 23.436 * PP_RAD).altitude_rad, PP_PI / 2.0,
                2.0 * almanac);
}

/* True noon at Greenwich is 14.2 minutes after 12:00 on 11 February and 16.4 minutes
 * before it on 3 November: the extremes of the equation of time, as printed in
 * almanacs. */
static void noon_runs_before_and_behind_the_clock(void **state)
{
    (void)state;
    static const struct {
        int month, day;
        double noon_h;
    } days[] = {{2, 11, 12.0 + 14.2 / 60.0}, {11, 3, 12.0 - 16.4 / 60.0}};
    for (int i = 0; i < 2; i++) {
        double n =
            pp_sun_days_since_2000(2026, days[i].month, days[i].day, days[i].noon_h);
        struct pp_sun sun = pp_sun_at(n, 51.5 * PP_RAD, 0.0);
        /* 0.1 minutes as printed are 0.025 degrees of hour angle, and a larger change
         * of bearing. */
        assert_near(sun.bearing_rad, PP_PI, 0.06 * PP_RAD);
    }
}

/* Positions by ERFA (IAU 2006/2000A) at UTC instants, seen from the surface of the
 * earth, without refraction. */
static void the_sun_agrees_with_erfa_from_1950_to_2050(void **state)
{
    (void)state;
    static const struct {
        double latitude, longitude;
        int year, month, day;
        double hour, azimuth, altitude;
    } erfa[] = {
        {-18.14, 178.44, 1953, 3, 8, 20 + 9 / 60.0 + 45 / 3600.0, 85.59684, 28.22547},
        {69.65, 18.96, 1967, 7, 21, 19 + 22 / 60.0 + 24 / 3600.0, 311.89466, 7.34470},
        {-33.92, 18.42, 1974, 4, 11, 7 + 40 / 60.0 + 3 / 3600.0, 55.51207, 28.80371},
        {41.98, -87.92, 1999, 10, 22, 18 + 4 / 60.0 + 52 / 3600.0, 188.76958, 36.53107},
        {78.22, 15.65, 2009, 7, 22, 7 + 20 / 60.0 + 49 / 3600.0, 119.91046, 26.50159},
        {50.85, 4.35, 2042, 6, 12, 7 + 43 / 60.0 + 41 / 3600.0, 97.98453, 36.71609},
        {-0.18, -78.47, 2047, 2, 20, 19 + 53 / 60.0 + 46 / 3600.0, 252.58047, 52.15165},
    };
    for (int i = 0; i < (int)(sizeof erfa / sizeof *erfa); i++) {
        double n = pp_sun_days_since_2000(erfa[i].year, erfa[i].month, erfa[i].day,
                                          erfa[i].hour);
        struct pp_sun sun =
            pp_sun_at(n, erfa[i].latitude * PP_RAD, erfa[i].longitude * PP_RAD);
        double h = erfa[i].altitude * PP_RAD;
        double turn = sun.bearing_rad - erfa[i].azimuth * PP_RAD;
        double apart =
            sin(h) * sin(sun.altitude_rad) + cos(h) * cos(sun.altitude_rad) * cos(turn);
        assert_true(acos(fmin(1.0, apart)) < almanac);
    }
}

/* A change of longitude by 15 degrees or of the clock by an hour is the same, except
 * for the sun's own motion in that hour, a degree a day. */
static void an_hour_is_fifteen_degrees(void **state)
{
    (void)state;
    for (int month = 1; month <= 12; month++) {
        double n = pp_sun_days_since_2000(2019, month, 13, 9.3);
        struct pp_sun a = pp_sun_at(n, 0.83, 0.31);
        struct pp_sun b = pp_sun_at(n + 1.0 / 24.0, 0.83, 0.31 - 15.0 * PP_RAD);
        assert_near(a.altitude_rad, b.altitude_rad, 0.03 * PP_RAD);
        assert_near(a.bearing_rad, b.bearing_rad, 0.06 * PP_RAD);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sun_agrees_with_a_far_longer_series),
        cmocka_unit_test(days_are_counted_from_noon_of_2000),
        cmocka_unit_test(at_the_equinox_noon_is_a_right_angle_less_the_latitude),
        cmocka_unit_test(at_the_solstices_the_sun_is_above_the_tropics),
        cmocka_unit_test(noon_runs_before_and_behind_the_clock),
        cmocka_unit_test(the_sun_agrees_with_erfa_from_1950_to_2050),
        cmocka_unit_test(an_hour_is_fifteen_degrees),
    };
    add_tests(tests, NULL, NULL);
}
