/* test_point_average.c - the mean over the working plane by points equals the mean by
 * beams: two integrals of the same light, over positions and over directions. */
#include "methods/average/plane_light.h"

#include "tests/lib/room_of.h"

/* Sky component and externally reflected component through all openings. */
struct two_averages {
    double of[2];
};

static struct two_averages averages(const struct pp_world *world,
                                    const struct pp_outside_light *light, bool plain)
{
    struct two_averages sum = {{0.0, 0.0}};
    struct pp_beams *beams;
    assert_int_equal(pp_beams_create(&beams, world, plain, NULL), PP_OK);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double mean[2];
        assert_int_equal(
            pp_plane_light_direct(mean, beams, light, opening, &opening->glass, NULL),
            PP_OK);
        sum.of[0] += mean[0];
        sum.of[1] += mean[1];
    }
    pp_beams_destroy(beams);
    return sum;
}

static void assert_same_averages(const char *body)
{
    char xml[4096];
    struct pp_outside_light light;
    snprintf(xml, sizeof xml, "<room version='1'>%s</room>", body);
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct two_averages points = averages(world, &light, true);
    struct two_averages beams = averages(world, &light, false);
    double both = beams.of[0] + beams.of[1];
    assert_true(both > 0.0);
    for (int k = 0; k < 2; k++)
        assert_near(points.of[k], beams.of[k], 1.5e-3 * both);
    pp_world_destroy(world);
}

static void average_through_windows_with_skyline_and_block(void **state)
{
    (void)state;
    assert_same_averages(
        "<plan width='3.7' depth='5.2' height='2.8'/>"
        "<window wall='south' left='0.4' sill='0.9' width='2.8' height='1.7'/>"
        "<window wall='east' left='2.1' sill='1.4' width='1.3' height='1.1' "
        "reveal='0.25'/>"
        "<skyline wall='south' angle='23'/>"
        "<block x='8' y='1' width='4' depth='5' height='9'/>");
}

static void average_through_a_slit(void **state)
{
    (void)state;
    assert_same_averages("<plan width='5' depth='5' height='3'/>"
                         "<window wall='south' left='1' sill='0.2' width='0.1' "
                         "height='2.4' reveal='0.4' glazing='none'/>");
}

static void under_a_clear_sky(void **state)
{
    (void)state;
    assert_same_averages("<sky type='iso-12' sun-altitude='35' sun-bearing='160'/>"
                         "<plan width='4' depth='6' height='3'/>"
                         "<window wall='south' left='1' sill='0.9' width='2' "
                         "height='1.4'/>");
}

/* Glass with a slope of 22 degrees lights the plane on both sides of the glass. An
 * average over the points in front of the glass only was a third too low. */
static void average_through_a_sloping_rooflight(void **state)
{
    (void)state;
    assert_same_averages(
        "<envelope><face role='floor' name='floor'><vertex x='0' y='0' z='0'/>"
        "<vertex x='7' y='0' z='0'/><vertex x='7' y='5.5' z='0'/>"
        "<vertex x='0' y='5.5' z='0'/></face>"
        "<face role='wall' name='low'><vertex x='0' y='0' z='0'/><vertex x='0' y='0' "
        "z='2.4'/>"
        "<vertex x='7' y='0' z='2.4'/><vertex x='7' y='0' z='0'/></face>"
        "<face role='wall' name='side'><vertex x='7' y='0' z='0'/><vertex x='7' y='0' "
        "z='2.4'/>"
        "<vertex x='7' y='5.5' z='4.6'/><vertex x='7' y='5.5' z='0'/></face>"
        "<face role='wall' name='high'><vertex x='7' y='5.5' z='0'/>"
        "<vertex x='7' y='5.5' z='4.6'/><vertex x='0' y='5.5' z='4.6'/>"
        "<vertex x='0' y='5.5' z='0'/></face>"
        "<face role='wall' name='party'><vertex x='0' y='5.5' z='0'/>"
        "<vertex x='0' y='5.5' z='4.6'/><vertex x='0' y='0' z='2.4'/>"
        "<vertex x='0' y='0' z='0'/></face>"
        "<face role='ceiling' name='roof'><vertex x='0' y='0' z='2.4'/>"
        "<vertex x='0' y='5.5' z='4.6'/><vertex x='7' y='5.5' z='4.6'/>"
        "<vertex x='7' y='0' z='2.4'/></face></envelope>"
        "<opening glazing='clear-double' reveal='0.25'>"
        "<vertex x='1.2' y='0.9' z='2.76'/><vertex x='1.2' y='2.7' z='3.48'/>"
        "<vertex x='3.0' y='2.7' z='3.48'/><vertex x='3.0' y='0.9' "
        "z='2.76'/></opening>");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(average_through_windows_with_skyline_and_block),
        cmocka_unit_test(average_through_a_slit),
        cmocka_unit_test(under_a_clear_sky),
        cmocka_unit_test(average_through_a_sloping_rooflight),
    };
    add_tests(tests, NULL, NULL);
}
