/* One moment's sky and sun against what is known on paper. */
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include <string.h>

#include "studies/year/moment.h"

static const struct pp_moment_irradiances golden = {.direct_w_m2 = 700.0,
                                                    .diffuse_w_m2 = 110.0,
                                                    .sun_altitude_rad = NAN,
                                                    .sun_bearing_rad = NAN,
                                                    .year = 2003,
                                                    .date = {10, 17},
                                                    .clock_h = 12.0 + 30.5 / 60.0,
                                                    .zone_h = -7.0,
                                                    .latitude_rad = 39.742476 * PP_RAD,
                                                    .longitude_rad =
                                                        -105.1786 * PP_RAD};

static double altitude_deg(const struct pp_moment *moment)
{
    return asin(moment->sky.sun.z) / PP_RAD;
}

static double bearing_deg(const struct pp_moment *moment)
{
    double bearing = atan2(moment->sky.sun.x, moment->sky.sun.y) / PP_RAD;
    return bearing < 0.0 ? bearing + 360.0 : bearing;
}

/* The worked case of NREL's solar position algorithm: 17 October 2003 at Golden,
 * Colorado; 39.87205 degrees without refraction, 194.34024 from north. */
static void sun_of_a_time_is_that_of_the_almanac(void **state)
{
    (void)state;
    struct pp_moment moment;
    assert_int_equal(pp_moment_of_irradiances(&moment, &golden, NULL), PP_OK);
    assert_near(altitude_deg(&moment), 39.87205, 0.01);
    assert_near(bearing_deg(&moment), 194.34024, 0.01);
}

/* 105 degrees west is 7 hours behind universal time. */
static void clock_without_a_zone_is_that_of_the_longitude(void **state)
{
    (void)state;
    struct pp_moment moment, by_zone;
    struct pp_moment_irradiances of = golden;
    of.zone_h = NAN;
    assert_int_equal(pp_moment_of_irradiances(&moment, &of, NULL), PP_OK);
    assert_int_equal(pp_moment_of_irradiances(&by_zone, &golden, NULL), PP_OK);
    assert_near(altitude_deg(&moment), altitude_deg(&by_zone), 1e-12);
    assert_non_null(strstr(moment.words, "by the longitude"));
}

static void refuses(const struct pp_moment_irradiances *of, const char *words)
{
    struct pp_moment moment;
    struct pp_error err = {0};
    assert_int_equal(pp_moment_of_irradiances(&moment, of, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, words));
}

static void sun_below_the_horizon_does_not_shine(void **state)
{
    (void)state;
    struct pp_moment_irradiances of = golden;
    of.clock_h = 1.0;
    refuses(&of, "below the horizon");
    of.direct_w_m2 = 0.0;
    struct pp_moment moment;
    assert_int_equal(pp_moment_of_irradiances(&moment, &of, NULL), PP_OK);
    assert_near(moment.sky.direct_lx, 0.0, 0.0);
    of.diffuse_w_m2 = 0.0;
    refuses(&of, "no light");
}

static void time_without_a_place_has_no_sun(void **state)
{
    (void)state;
    struct pp_moment_irradiances of = golden;
    of.longitude_rad = NAN;
    refuses(&of, "no place");
    of.date.month = 0;
    refuses(&of, "no sun");
}

/* Behind an opening without glass a level point in the sun has the direct normal
 * illuminance times the sine of its altitude; one in shade has none. The parts add up. */
static void sunlight_on_a_level_point_is_by_the_sine(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_annual_sheet sheet;
    struct pp_moment moment;
    struct pp_moment_irradiances of = golden;
    of.sun_altitude_rad = 30.0 * PP_RAD;
    of.sun_bearing_rad = 180.0 * PP_RAD;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='6' height='3'/>"
                "<window wall='south' left='0.5' sill='0.9' width='3' height='1.8' "
                "glazing='none'/><point x='2' y='1'/><point x='2' y='5'/></room>");
    assert_int_equal(pp_moment_of_irradiances(&moment, &of, NULL), PP_OK);
    const struct pp_annual_options options = {.samples = 16, .seed = 1, .threads = 1};
    assert_int_equal(pp_moment_of_room(&sheet, world, &light, world->receivers,
                                       world->receiver_count, &moment, &options, NULL),
                     PP_OK);
    assert_near(sheet.points[0].sun_lxh.value, 0.5 * moment.sky.direct_lx, 1.0);
    assert_near(sheet.points[1].sun_lxh.value, 0.0, 0.0);
    for (int i = 0; i < 2; i++) {
        const struct pp_annual_figures *f = &sheet.points[i];
        assert_true(f->sky_lxh.value > 0.0 && f->sun_reflected_lxh.value > 0.0);
        assert_near(f->year_lxh.value,
                    f->sky_lxh.value + f->sun_lxh.value + f->sun_reflected_lxh.value,
                    1e-3 * f->year_lxh.value);
    }
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sun_of_a_time_is_that_of_the_almanac),
        cmocka_unit_test(clock_without_a_zone_is_that_of_the_longitude),
        cmocka_unit_test(sun_below_the_horizon_does_not_shine),
        cmocka_unit_test(time_without_a_place_has_no_sun),
        cmocka_unit_test(sunlight_on_a_level_point_is_by_the_sine),
    };
    add_tests(tests, NULL, NULL);
}
