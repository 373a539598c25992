/* test_radiosity_agree.c - radiosity compared with the path tracer, with which it
 * shares only the world: rooms with reveals, dados, partitions, scattering panes and a
 * court. */
#include "tests/lib/radiosity_of.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"

/* Asserts that daylight factors and their average differ by at most the stated error,
 * at most 2 %, and three standard errors; components by another 0.5 % of the daylight
 * factor. */
static void assert_engines_agree(const char *xml)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    int count = world->receiver_count;
    struct pp_tracer_options paths = {
        .error = PP_SIZED(0.004, 0.01, 0.02), .seed = 3, .average = true};
    struct pp_radiosity_options options = {.error = 0.0};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, count, &paths, NULL);
    struct pp_reading(*found)[4] =
        pp_test_elements(world, &light, world->receivers, count, &options, NULL);
    for (int i = 0; i <= count; i++)
        for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
            double df = traced[i][PP_DF].value;
            assert_near(found[i][c].value, traced[i][c].value,
                        fmin(found[i][c].std_error, 0.02 * df)
                            + 3.0 * traced[i][c].std_error
                            + (c == PP_DF ? 0.0 : 0.005 * df));
        }
    free(traced);
    free(found);
    pp_world_destroy(world);
}

#define ROOM "<room version='1'><plan width='3.2' depth='4.6' height='2.7'/>"
#define POINTS                                                                         \
    "<point x='0.9' y='0.7'/><point x='1.7' y='2.2'/><point x='2.3' y='4.1'/></room>"

static void behind_deep_reveals_and_an_overhang(void **state)
{
    (void)state;
    assert_engines_agree(
        ROOM "<window wall='south' left='0.5' sill='0.8' width='2' height='1.5' "
             "reveal='0.4' glazing='clear-double' frame-factor='0.8'/>"
             "<surface><vertex x='-1' y='-1.2' z='2.6'/>"
             "<vertex x='4' y='-1.2' z='2.6'/><vertex x='4' y='0' z='2.6'/>"
             "<vertex x='-1' y='0' z='2.6'/></surface>" POINTS);
}

static void before_a_dark_dado_and_a_bright_door(void **state)
{
    (void)state;
    assert_engines_agree(
        ROOM "<finishes floor='0.1' walls='0.5' ceiling='0.6'/>"
             "<window wall='south' left='0.5' sill='0.8' width='2' height='1.5' "
             "reveal='0.4'/><dado height='1.1' reflectance='0.1'/>"
             "<door wall='north' left='1.8' reflectance='0.9'/>"
             "<point x='2.8' y='4.3'/>" POINTS);
}

static void past_a_partition(void **state)
{
    (void)state;
    assert_engines_agree(
        ROOM "<window wall='south' left='0.5' sill='0.8' width='2' height='1.5'/>"
             "<partition from='0 1.5' to='2 1.5' height='2'/>" POINTS);
}

static void through_a_pane_that_scatters(void **state)
{
    (void)state;
    assert_engines_agree(
        ROOM "<window wall='south' left='0.5' sill='0.8' width='2' height='1.5' "
             "glazing='opal-glass'/><block x='-4' y='-8' width='12' depth='3' "
             "height='7'/>" POINTS);
}

static void at_the_foot_of_a_court(void **state)
{
    (void)state;
    assert_engines_agree(
        ROOM "<window wall='south' left='0.5' sill='0.8' width='2' height='1.5' "
             "glazing='clear-single'/>"
             "<block x='-6' y='-9' width='15' depth='4' height='9' reflectance='0.5'/>"
             "<block x='-6' y='-5' width='3' depth='5' height='9' reflectance='0.5'/>"
             "<block x='6' y='-5' width='3' depth='5' height='9' "
             "reflectance='0.5'/>" POINTS);
}

#define SOUTH                                                                          \
    "<window wall='south' left='0.5' sill='0.8' width='2' height='1.5' "               \
    "glazing='clear-double'/>"

#define CLEAR "<sky type='iso-12' sun-altitude='35' sun-bearing='200'/>"

/* At gate size only a skyline without a distance, which takes a third of the time;
 * under sanitizers this is still most of the time of this file. */
static void behind_a_skyline_under_a_clear_sky(void **state)
{
    (void)state;
    if (PP_SIZED(false, false, true))
        skip();
    static const char two[] =
        ROOM CLEAR SOUTH "<window wall='east' left='1' sill='1.5' "
                         "width='1.2' height='0.8' glazing='clear-double'/>"
                         "<skyline wall='south' angle='25' distance='14'/>"
                         "<skyline wall='east' angle='15'/>" POINTS;
    static const char one[] =
        ROOM CLEAR SOUTH "<skyline wall='south' angle='25'/>" POINTS;
    assert_engines_agree(PP_SIZED(two, one, one));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(before_a_dark_dado_and_a_bright_door),
        cmocka_unit_test(through_a_pane_that_scatters),
        cmocka_unit_test(behind_a_skyline_under_a_clear_sky),
    };
    add_tests(tests, NULL, NULL);
    const struct CMUnitTest long_tests[] = {
        cmocka_unit_test(behind_deep_reveals_and_an_overhang),
        cmocka_unit_test(past_a_partition),
        cmocka_unit_test(at_the_foot_of_a_court),
    };
    add_long_tests(long_tests, NULL, NULL);
}
