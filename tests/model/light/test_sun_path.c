/* test_sun_path.c - sun paths compared with known days, and with the calculated
 * position of the sun. */
#include "model/light/sun_path.h"

#include "model/light/sun.h"
#include "tests/lib/near.h"

static void the_sun_rises_due_east_at_the_equinox_and_stands_at_noon_where_it_must(
    void **state)
{
    (void)state;
    double phi = 51.5 * PP_RAD;
    struct pp_vec3 rise = pp_sun_path_direction(phi, 0.0, -0.5 * PP_PI);
    assert_near(rise.x, 1.0, 1e-12);
    assert_near(rise.z, 0.0, 1e-12);
    /* At noon 90 - 51.5 + 23.44 degrees high, in the south. */
    struct pp_vec3 noon = pp_sun_path_direction(phi, 23.44 * PP_RAD, 0.0);
    assert_near(asin(noon.z) / PP_RAD, 61.94, 1e-9);
    assert_true(noon.y < 0.0 && fabs(noon.x) < 1e-12);
    /* In the southern hemisphere the noon sun is in the north. */
    assert_true(pp_sun_path_direction(-phi, 0.0, 0.0).y > 0.0);
}

static void days_are_twelve_hours_at_the_equator_and_endless_beyond_the_circle(
    void **state)
{
    (void)state;
    assert_near(pp_sun_path_sunset(0.0, 23.0 * PP_RAD), 0.5 * PP_PI, 1e-12);
    assert_near(pp_sun_path_sunset(70.0 * PP_RAD, 23.0 * PP_RAD), PP_PI, 0.0);
    assert_near(pp_sun_path_sunset(70.0 * PP_RAD, -23.0 * PP_RAD), 0.0, 0.0);
    /* London's longest day lasts 16 h 24 min for a true horizon. */
    assert_near(pp_sun_path_sunset(51.5 * PP_RAD, 23.44 * PP_RAD) / PP_RAD * 2.0 / 15.0,
                16.4, 0.02);
}

static void declinations_are_those_of_the_seasons(void **state)
{
    (void)state;
    assert_near(pp_sun_path_declination(6, 21) / PP_RAD, 23.44, 0.02);
    assert_near(pp_sun_path_declination(12, 21) / PP_RAD, -23.44, 0.02);
    assert_near(pp_sun_path_declination(3, 20) / PP_RAD, 0.0, 0.3);
    /* Pairs of months share a path on overlays. */
    for (int month = 1; month < 6; month++)
        assert_near(pp_sun_path_declination(month, 21) / PP_RAD,
                    pp_sun_path_declination(12 - month, 21) / PP_RAD, 0.6);
}

/* At one moment and longitude the hour angle is the same at all latitudes; at the
 * equator it is the angle in the plane of east and zenith. The calculated sun has a
 * parallax of up to 4.3e-5, the path has none. */
static void the_path_is_the_almanacs_at_other_latitudes(void **state)
{
    (void)state;
    static const double latitudes[] = {51.5, -33.9, 68.0, 10.0};
    for (int hour = 5; hour < 20; hour += 3)
        for (int i = 0; i < 4; i++) {
            double days = pp_sun_days_since_2000(2025, 8, 9, hour), phi, h;
            struct pp_sun here = pp_sun_at(days, 0.0, 0.1);
            h = atan2(-cos(here.altitude_rad) * sin(here.bearing_rad),
                      sin(here.altitude_rad));
            phi = latitudes[i] * PP_RAD;
            struct pp_sun there = pp_sun_at(days, phi, 0.1);
            struct pp_vec3 u = pp_sun_path_direction(phi, there.declination_rad, h);
            assert_near(u.z, sin(there.altitude_rad), 5e-5);
            assert_near(u.x, cos(there.altitude_rad) * sin(there.bearing_rad), 5e-5);
            assert_near(u.y, cos(there.altitude_rad) * cos(there.bearing_rad), 5e-5);
        }
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            the_sun_rises_due_east_at_the_equinox_and_stands_at_noon_where_it_must),
        cmocka_unit_test(
            days_are_twelve_hours_at_the_equator_and_endless_beyond_the_circle),
        cmocka_unit_test(declinations_are_those_of_the_seasons),
        cmocka_unit_test(the_path_is_the_almanacs_at_other_latitudes),
    };
    add_tests(tests, NULL, NULL);
}
