/* test_cut_off.c - slats that follow the sun, during a year and hour by hour. */
#include <stdlib.h>

#include "model/light/slats/blind_follow.h"
#include "model/room/build/device_states.h"
#include "studies/year/annual.h"
#include "tests/lib/made_year.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"

#define ROOM                                                                           \
    "<room version='1'><site ground='open'/><plan width='4' depth='5' height='2.8'/>"  \
    "<finishes floor='0.25' walls='0.55' ceiling='0.75'/>"                             \
    "<window wall='south' left='0.9' sill='0.8' width='2.2' height='1.5' "             \
    "glazing='none'>%s</window>%s<point x='1.7' y='1.6'/><point x='2' y='2.6'/>"       \
    "<point x='2.6' y='3.9'/></room>"
#define SLATS                                                                          \
    "<blind slat-width='0.03' spacing='0.025' cut-off='yes' reflectance='0.6'/>"

enum { XML = 60000, POINTS = 3 };

static struct pp_perez_sky sky_of(double direct_w_m2, double diffuse_w_m2,
                                  double altitude_deg, double bearing_deg)
{
    return pp_perez_sky_of(
        &(struct pp_perez_conditions){.direct_w_m2 = direct_w_m2,
                                      .diffuse_w_m2 = diffuse_w_m2,
                                      .sun = pp_test_toward(altitude_deg, bearing_deg),
                                      .sun_distance_au = 1.0,
                                      .dew_point_c = 9.0});
}

static struct pp_world *world_of(struct pp_outside_light *light, const char *blind,
                                 const char *slats)
{
    char *xml = malloc(XML);
    snprintf(xml, XML, ROOM, blind, slats);
    struct pp_world *world = pp_test_lit_world(light, xml);
    free(xml);
    return world;
}

/* If w = s the cut-off is at an angle of 2 p - 90 degrees, where p is the altitude of a
 * sun perpendicular to the window. Slats remain at 0 degrees without sun, or if the sun
 * is behind the window. Vertical slats turn away from the sun. */
static void slats_turn_for_the_sun_in_front_of_their_window(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "<blind slat-width='0.03' spacing='0.03' cut-off='yes'/>", "");
    const struct pp_opening *opening = &world->openings[0];
    assert_near(pp_device_states_tilt(opening, pp_test_toward(31.0, 180.0)),
                -28.0 * PP_RAD, 1e-6);
    assert_true(pp_device_states_tilt(opening, pp_test_toward(31.0, 20.0)) == 0.0);
    assert_true(pp_device_states_tilt(opening, pp_test_toward(-1.0, 180.0)) == 0.0);
    assert_int_equal(
        pp_device_states_turn(world, true, pp_test_toward(31.0, 180.0), NULL), PP_OK);
    assert_near(opening->device.slats.tilt_rad, -28.0 * PP_RAD, 1e-6);
    assert_int_equal(
        pp_device_states_turn(world, false, pp_test_toward(31.0, 180.0), NULL), PP_OK);
    assert_true(opening->device.slats.tilt_rad == 0.0);
    pp_world_destroy(world);

    world = world_of(&light,
                     "<blind slat-width='0.03' spacing='0.03' cut-off='yes' "
                     "direction='vertical'/>",
                     "");
    double east =
        pp_device_states_tilt(&world->openings[0], pp_test_toward(5.0, 150.0));
    double west =
        pp_device_states_tilt(&world->openings[0], pp_test_toward(5.0, 210.0));
    assert_near(fabs(east), 30.0 * PP_RAD, 1e-6);
    assert_near(west, -east, 1e-9);
    pp_world_destroy(world);
}

/* Light of one hour at the points, with the slats turned for its sun. */
static void hour_of(float lx[POINTS], const char *blind, const struct pp_perez_sky *sky,
                    int samples)
{
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, blind, "");
    struct pp_annual_options options = pp_test_whole_day(samples);
    struct pp_annual_sheet sheet;
    struct pp_test_year made;
    pp_test_make_year(&made);
    pp_test_add_hour(&made, sky);
    options.blinds = PP_BLINDS_AS_DRAWN;
    assert_int_equal(pp_device_states_turn(world, sky->direct_lx > 0.0, sky->sun, NULL),
                     PP_OK);
    pp_test_year_of(&sheet, world, &light, &made, &options);
    memcpy(lx, sheet.lx, POINTS * sizeof *lx);
    for (int x = 0; x < POINTS; x++)
        assert_true(sheet.sun_lx[x] == 0.0f);
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

/* In a year, skylight is interpolated between slat angles 5 degrees apart, and sunlight
 * between profile angles 2.5 degrees apart. A blind at a fixed angle also interpolates
 * where its slats begin to cut off the sun, and has 1 % less light there. */
static void a_year_has_the_light_of_slats_turned_hour_by_hour(void **state)
{
    (void)state;
    static const struct {
        double direct_w_m2, diffuse_w_m2, altitude_deg, bearing_deg;
    } hours[] = {{610.0, 110.0, 12.0, 151.0}, {730.0, 90.0, 27.0, 172.0},
                 {540.0, 190.0, 44.0, 203.0}, {820.0, 80.0, 63.0, 190.0},
                 {390.0, 70.0, 9.0, 236.0},   {0.0, 160.0, 31.0, 180.0},
                 {450.0, 60.0, 21.0, 302.0}};
    static const char *const blinds[] = {
        SLATS, "<blind slat-width='0.08' spacing='0.07' cut-off='yes' "
               "direction='vertical' position='outside' reflectance='0.4'/>"};
    enum { HOURS = sizeof hours / sizeof *hours };
    for (int k = 0; k < 2; k++) {
        const char *blind = blinds[k];
        struct pp_test_year made;
        pp_test_make_year(&made);
        for (int i = 0; i < HOURS; i++) {
            struct pp_perez_sky sky =
                sky_of(hours[i].direct_w_m2, hours[i].diffuse_w_m2,
                       hours[i].altitude_deg, hours[i].bearing_deg);
            pp_test_add_hour(&made, &sky);
        }
        struct pp_outside_light light;
        struct pp_world *world = world_of(&light, blind, "");
        struct pp_annual_options options = pp_test_whole_day(16);
        struct pp_annual_sheet sheet;
        options.blinds = PP_BLINDS_ALWAYS;
        pp_test_year_of(&sheet, world, &light, &made, &options);
        assert_near(sheet.groups[0].unmet_h, 0.0, 1e-9);
        for (int i = 0; i < HOURS; i++) {
            float lx[POINTS];
            hour_of(lx, blind, &made.skies[i], 16);
            for (int x = 0; x < POINTS; x++)
                assert_near(sheet.lx[x * HOURS + i], lx[x], 0.02 * lx[x]);
        }
        pp_annual_sheet_clear(&sheet);
        pp_world_destroy(world);
    }
}

/* Slats as surfaces, at one angle. They extend beyond the window, so that no light
 * passes beside their ends, which would be a twentieth of the light. */
static void write_slats(char *text, double tilt_rad)
{
    double a = 0.015 * cos(tilt_rad), b = -0.015 * sin(tilt_rad);
    int length = 0;
    for (int i = -8; i < 68; i++) {
        double y = 0.016, z = 0.8125 + 0.025 * i;
        length += snprintf(
            text + length, XML / 2 - (size_t)length,
            "<surface reflectance='0.6'><vertex x='0.7' y='%.6f' z='%.6f'/>"
            "<vertex x='3.3' y='%.6f' z='%.6f'/><vertex x='3.3' y='%.6f' z='%.6f'/>"
            "<vertex x='0.7' y='%.6f' z='%.6f'/></surface>",
            y - a, z - b, y - a, z - b, y + a, z + b, y + a, z + b);
    }
}

/* Light at the points with slats as surfaces, and its standard errors, by the plain
 * year, which tests the sun at every point of a path. */
static void hour_of_slats(float lx[POINTS], double error[POINTS],
                          const struct pp_test_year *made, int samples)
{
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, SLATS, "");
    char *text = malloc(XML / 2);
    struct pp_annual_options options = pp_test_whole_day(samples);
    struct pp_annual_sheet sheet;
    write_slats(text, pp_device_states_tilt(&world->openings[0], made->skies[0].sun));
    pp_world_destroy(world);
    world = world_of(&light, "", text);
    options.blinds = PP_BLINDS_AS_DRAWN;
    options.exact_sky = true;
    pp_test_year_of(&sheet, world, &light, made, &options);
    memcpy(lx, sheet.lx, POINTS * sizeof *lx);
    for (int x = 0; x < POINTS; x++)
        error[x] = sheet.points[x].year_lxh.std_error;
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
    free(text);
}

static void slats_that_follow_the_sun_are_those_slats(void **state)
{
    (void)state;
    static const double suns[][2] = {{33.0, 195.0}, {18.0, 160.0}, {49.0, 148.0}};
    int count = PP_SIZED(3, 1, 1);
    for (int i = 0; i < count; i++) {
        struct pp_perez_sky sky = sky_of(700.0, 100.0, suns[i][0], suns[i][1]);
        struct pp_outside_light light;
        struct pp_world *world = world_of(&light, SLATS, "");
        struct pp_annual_options options = pp_test_whole_day(128);
        struct pp_annual_sheet sheet;
        struct pp_test_year made;
        float lx[POINTS];
        double error[POINTS];
        pp_test_make_year(&made);
        pp_test_add_hour(&made, &sky);
        options.blinds = PP_BLINDS_ALWAYS;
        pp_test_year_of(&sheet, world, &light, &made, &options);
        hour_of_slats(lx, error, &made, PP_SIZED(16384, 2048, 512));
        for (int x = 0; x < POINTS; x++)
            assert_near(sheet.lx[x], lx[x], 0.03 * lx[x] + 3.0 * error[x]);
        pp_annual_sheet_clear(&sheet);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(slats_turn_for_the_sun_in_front_of_their_window),
        cmocka_unit_test(a_year_has_the_light_of_slats_turned_hour_by_hour),
        cmocka_unit_test(slats_that_follow_the_sun_are_those_slats),
    };
    add_tests(tests, NULL, NULL);
}
