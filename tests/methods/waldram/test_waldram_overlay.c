/* test_waldram_overlay.c - squares of an unglazed diagram with an overlay for the
 * glass. */
#include "methods/waldram/waldram_squares.h"
#include "methods/method.h"

#include <stdio.h>

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

static double at(const struct pp_world *world, const struct pp_outside_light *light,
                 const struct pp_method *method, const struct pp_receiver *receiver)
{
    struct pp_part part = {0};
    void *tools = NULL;
    if (method->prepare)
        assert_int_equal(method->prepare(&tools, world, light, NULL), PP_OK);
    for (int i = 0; i < world->opening_count; i++)
        assert_int_equal(method->evaluate(world, light, &world->openings[i], receiver,
                                          tools, &part, NULL),
                         PP_OK);
    method->destroy_tools(tools);
    return part.sky;
}

/* A roof window with a slope of up to 63 degrees or a window, with single, double or no
 * glass, at 300 random points: no bias beyond three standard errors, and errors of at
 * most half a square. */
static void squares_under_the_overlay_are_exact_and_unbiased(void **state)
{
    (void)state;
    static const char *const glazings[] = {"clear-single", "clear-double", "none"};
    struct dice dice = {5};
    double sum = 0.0, squares = 0.0;
    enum { POINTS = 300 };
    for (int i = 0; i < POINTS; i++) {
        char xml[2500];
        double rise = between(&dice, 0.0, 2.0);
        double y = between(&dice, 0.3, 1.2), up = between(&dice, 0.4, 1.4);
        double x = between(&dice, 0.3, 2.5), z = 2.2 + rise * y, top = 2.2 + 3 * rise;
        int n = snprintf(xml, sizeof xml,
                         "<room version='1'><envelope><face role='floor' name='f'>"
                         "<vertex x='0' y='0' z='0'/><vertex x='4' y='0' z='0'/>"
                         "<vertex x='4' y='3' z='0'/><vertex x='0' y='3' z='0'/></face>"
                         "<face role='ceiling' name='r'><vertex x='0' y='0' z='2.2'/>"
                         "<vertex x='0' y='3' z='%.9f'/><vertex x='4' y='3' z='%.9f'/>"
                         "<vertex x='4' y='0' z='2.2'/></face>"
                         "<face role='wall' name='s'><vertex x='0' y='0' z='0'/>"
                         "<vertex x='0' y='0' z='2.2'/><vertex x='4' y='0' z='2.2'/>"
                         "<vertex x='4' y='0' z='0'/></face>"
                         "<face role='wall' name='n'><vertex x='0' y='3' z='0'/>"
                         "<vertex x='4' y='3' z='0'/><vertex x='4' y='3' z='%.9f'/>"
                         "<vertex x='0' y='3' z='%.9f'/></face>"
                         "<face role='wall' name='w'><vertex x='0' y='0' z='0'/>"
                         "<vertex x='0' y='3' z='0'/><vertex x='0' y='3' z='%.9f'/>"
                         "<vertex x='0' y='0' z='2.2'/></face>"
                         "<face role='wall' name='e'><vertex x='4' y='0' z='0'/>"
                         "<vertex x='4' y='0' z='2.2'/><vertex x='4' y='3' z='%.9f'/>"
                         "<vertex x='4' y='3' z='0'/></face></envelope>",
                         top, top, top, top, top, top);
        if (i % 3 == 0)
            snprintf(xml + n, sizeof xml - (size_t)n,
                     "<window wall='s' left='0.7' sill='0.6' width='%.4f' "
                     "height='1.4' glazing='%s'/></room>",
                     between(&dice, 0.4, 3.0), glazings[i / 3 % 3]);
        else
            snprintf(xml + n, sizeof xml - (size_t)n,
                     "<opening glazing='%s'><vertex x='%.9f' y='%.9f' z='%.9f'/>"
                     "<vertex x='%.9f' y='%.9f' z='%.9f'/>"
                     "<vertex x='%.9f' y='%.9f' z='%.9f'/>"
                     "<vertex x='%.9f' y='%.9f' z='%.9f'/></opening></room>",
                     glazings[i / 3 % 3], x, y, z, x, y + up, z + up * rise, x + 1.2,
                     y + up, z + up * rise, x + 1.2, y, z);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        const struct pp_receiver receiver = {
            {between(&dice, 0.2, 3.8), between(&dice, 0.5, 2.8), 0.85},
            {0, 0, 1},
            0,
            0.0};
        double off = (at(world, &light, &pp_method_waldram_overlay, &receiver)
                      - at(world, &light, &pp_method_exact, &receiver))
                     / PP_WALDRAM_WORTH;
        assert_near(off, 0.0, 0.5);
        sum += off;
        squares += off * off;
        pp_world_destroy(world);
    }
    double spread = sqrt(squares / POINTS);
    assert_near(sum / POINTS, 0.0, 3.0 * spread / sqrt(POINTS) + 0.005);
}

static void diffusing_panes_and_skies_with_azimuth_are_refused(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><sky type='iso-12' sun-altitude='35' "
                "sun-bearing='160'/><plan width='7' depth='6' height='2.85'/>"
                "<rooflight x='2.1' y='1.7' width='1.6' depth='1.1' diffusing='yes' "
                "transmittance='0.5'/></room>");
    assert_non_null(pp_method_waldram_overlay.refuses_room(world, &light, NULL));
    light.sky = pp_sky_overcast();
    assert_null(pp_method_waldram_overlay.refuses_room(world, &light, NULL));
    assert_non_null(
        pp_method_waldram_overlay.refuses(world, &light, world->openings, NULL));
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(squares_under_the_overlay_are_exact_and_unbiased),
        cmocka_unit_test(diffusing_panes_and_skies_with_azimuth_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
