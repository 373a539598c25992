/* test_moment.c - sky and sun of one moment compared with known values. */
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include <string.h>

#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/sensors.h"
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

/* Example of NREL's solar position algorithm: 17 October 2003 at Golden, Colorado;
 * 39.87205 degrees without refraction, 194.34024 from north. */
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
    assert_non_null(strstr(moment.words, "from the longitude"));
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
    refuses(&of, "no location");
    of.date.month = 0;
    refuses(&of, "no position of the sun");
}

/* Behind an unglazed opening a horizontal point in the sun receives the direct normal
 * illuminance times the sine of the sun's altitude; a point in shade receives none. The
 * parts add up. */
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

/* Below an opening of 120 x 120 m, 0.05 m above the point, the whole sky is visible:
 * the light is diffuse plus direct times the sine of the sun's altitude. A public answer
 * adds direct times the cosine to the global illuminance, more than 1.5 times as much. */
static void open_plane_has_diffuse_light_and_direct_by_the_sine(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_annual_sheet sheet;
    struct pp_moment moment;
    struct pp_moment_irradiances of = golden;
    of.sun_altitude_rad = 30.0 * PP_RAD;
    of.sun_bearing_rad = 160.0 * PP_RAD;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='121' depth='121' height='0.5'/>"
                "<finishes floor='0' walls='0' ceiling='0'/>"
                "<rooflight x='0.5' y='0.5' width='120' depth='120' glazing='none'/>"
                "<working-plane height='0.45'/><point x='60' y='60'/></room>");
    assert_int_equal(pp_moment_of_irradiances(&moment, &of, NULL), PP_OK);
    const struct pp_annual_options options = {.samples = 64, .seed = 1, .threads = 1};
    assert_int_equal(pp_moment_of_room(&sheet, world, &light, world->receivers, 1,
                                       &moment, &options, NULL),
                     PP_OK);
    double diffuse = moment.sky.diffuse_lx, direct = moment.sky.direct_lx;
    double lx = sheet.points[0].year_lxh.value;
    assert_near(lx, diffuse + direct * sin(30.0 * PP_RAD),
                3.0 * sheet.points[0].year_lxh.std_error + 2e-3 * lx);
    assert_true(diffuse + direct * (sin(30.0 * PP_RAD) + cos(30.0 * PP_RAD))
                > 1.5 * lx);
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

/* Compares a moment at three points of a room with another engine: the path tracer of
 * pictures, in which the sun is a distant source. */
static void compare_with_pictures(const char *window_and_outside)
{
    char text[1024];
    struct pp_outside_light light;
    struct pp_annual_sheet sheet;
    struct pp_moment moment;
    struct pp_moment_irradiances of = golden;
    of.sun_altitude_rad = 40.0 * PP_RAD;
    of.sun_bearing_rad = 205.0 * PP_RAD;
    snprintf(text, sizeof text,
             "<room version='1' north='20'><site ground-reflectance='0.3'/>"
             "<plan width='4' depth='6' height='3'/>%s<point x='2' y='1'/>"
             "<point x='1' y='3'/><point x='3' y='5'/></room>",
             window_and_outside);
    struct pp_world *world = pp_test_lit_world(&light, text);
    assert_int_equal(pp_moment_of_irradiances(&moment, &of, NULL), PP_OK);
    const struct pp_annual_options options = {.samples = 256, .seed = 1};
    assert_int_equal(pp_moment_of_room(&sheet, world, &light, world->receivers,
                                       world->receiver_count, &moment, &options, NULL),
                     PP_OK);

    struct pp_light_scene *scene = NULL;
    struct pp_environment *environment = NULL;
    struct pp_sensors *sensors = NULL;
    struct pp_sensor list[3];
    for (int i = 0; i < 3; i++)
        list[i] = (struct pp_sensor){world->receivers[i].position,
                                     world->receivers[i].normal, 0};
    assert_int_equal(pp_moment_light(&light, &moment, world->north_rad, NULL), PP_OK);
    assert_int_equal(pp_light_scene_of_world_sunlit(&scene, world, &light.sun, NULL),
                     PP_OK);
    assert_int_equal(pp_light_scene_under(&environment, scene, &light, NULL), PP_OK);
    const struct pp_sensors_options by_paths = {.error = 0.005, .seed = 5};
    assert_int_equal(
        pp_sensors_create(&sensors, scene, environment, list, 3, &by_paths, NULL),
        PP_OK);
    while (!pp_sensors_done(sensors))
        assert_int_equal(pp_sensors_advance(sensors, 1.0, NULL), PP_OK);
    for (int i = 0; i < 3; i++) {
        struct pp_sensor_reading reading = pp_sensors_read(sensors, i);
        double lx = reading.grey * moment.sky.diffuse_lx;
        const struct pp_annual_value *value = &sheet.points[i].year_lxh;
        assert_near(lx, value->value,
                    0.005 * lx
                        + 3.0
                              * hypot(value->std_error,
                                      reading.grey_error * moment.sky.diffuse_lx));
    }
    pp_sensors_destroy(sensors);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

#define WINDOW "<window wall='south' left='0.5' sill='0.9' width='3' height='1.8' "

static void pictures_have_the_same_light_of_ground_and_block(void **state)
{
    (void)state;
    compare_with_pictures(WINDOW
                          "glazing='clear-double'/><block x='-4' y='-12' width='6' "
                          "depth='4' height='4' reflectance='0.4'/>");
}

/* The sun shines on the pane, which scatters half of its light in all directions. */
static void pictures_have_the_sun_that_a_diffusing_pane_scatters(void **state)
{
    (void)state;
    compare_with_pictures(WINDOW "transmittance='0.5' diffusing='yes'/>");
}

/* The slats keep out the direct sun and scatter a part of it. */
static void pictures_have_the_sun_that_a_blind_scatters(void **state)
{
    (void)state;
    compare_with_pictures(WINDOW "glazing='none'><blind angle='-45'/></window>");
}

/* Open ground reflects its reflectance times the light of sky and sun. */
static void sunlit_ground_gives_back_its_share(void **state)
{
    (void)state;
    const struct pp_outside_light light = {.sky = pp_sky_uniform(),
                                           .ground_reflectance = 0.2,
                                           .sun = {{0.0, 0.6, 0.8}, 2.5}};
    assert_near(pp_outside_light_sunlit_ground(&light), 0.2 * (1.0 + 2.0), 1e-12);
    assert_near(pp_outside_light_sun_on_plane(&light, pp_vec(0.0, 1.0, 0.0)), 1.5,
                1e-12);
    assert_near(pp_outside_light_sun_on_plane(&light, pp_vec(0.0, -1.0, 0.0)), 0.0,
                0.0);
    /* A wall that faces the sun receives half of the sky, the sun, and half of the
     * ground. */
    assert_near(pp_outside_light_exitance(&light, 0.5, pp_vec(0.0, 1.0, 0.0)),
                0.5 * (0.5 + 1.5 + 0.3), 1e-9);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sun_of_a_time_is_that_of_the_almanac),
        cmocka_unit_test(clock_without_a_zone_is_that_of_the_longitude),
        cmocka_unit_test(sun_below_the_horizon_does_not_shine),
        cmocka_unit_test(time_without_a_place_has_no_sun),
        cmocka_unit_test(pictures_have_the_same_light_of_ground_and_block),
        cmocka_unit_test(pictures_have_the_sun_that_a_diffusing_pane_scatters),
        cmocka_unit_test(pictures_have_the_sun_that_a_blind_scatters),
        cmocka_unit_test(sunlit_ground_gives_back_its_share),
        cmocka_unit_test(sunlight_on_a_level_point_is_by_the_sine),
        cmocka_unit_test(open_plane_has_diffuse_light_and_direct_by_the_sine),
    };
    add_tests(tests, NULL, NULL);
}
