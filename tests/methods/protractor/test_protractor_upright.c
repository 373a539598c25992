/* test_protractor_upright.c - protractors for vertical receivers. */
#include "methods/protractor/protractor_dial.h"
#include "methods/method.h"
#include "model/light/graded_sky.h"

#include <stdio.h>

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

static struct pp_protractor of(enum pp_protractor_receiver receiver, bool glazed)
{
    return (struct pp_protractor){.sky = pp_sky_overcast(),
                                  .glass = glazed ? pp_glass_clear_single()
                                                  : pp_glass_none(),
                                  .slope_rad = PP_PI / 2.0,
                                  .receiver = receiver};
}

/* Without glass: the light on a vertical plane that an infinitely long skyline at the
 * altitude gamma hides, 3/14 sin gamma + 4/(7 pi) sin^2 gamma; in total 39.62 %. */
static void straight_ahead_reads_what_a_skyline_hides(void **state)
{
    (void)state;
    struct pp_protractor protractor = of(PP_PROTRACTOR_AHEAD, false);
    struct pp_protractor_dial dial;
    pp_protractor_dial_init(&dial, &protractor);
    for (double gamma = 0.03; gamma < PP_PI / 2.0; gamma += 0.11) {
        double s = sin(gamma), hidden = 3.0 / 14.0 * s + 4.0 / (7.0 * PP_PI) * s * s;
        assert_near(pp_protractor_dial_share(&dial, gamma), hidden, 1e-6);
    }
    assert_near(pp_protractor_dial_share(&dial, PP_PI / 2.0), 0.396177, 2e-6);
}

/* A receiver perpendicular to the window receives light from one side only, half of
 * 39.62 %. Printed scales count one side, so the value is doubled: 39.62 %. Under a
 * uniform sky each side has 1/4. */
static void aside_reads_half_the_light_on_each_side(void **state)
{
    (void)state;
    struct pp_protractor_dial dial;
    struct pp_protractor protractor = of(PP_PROTRACTOR_ASIDE, false);
    pp_protractor_dial_init(&dial, &protractor);
    assert_near(pp_protractor_dial_share(&dial, PP_PI / 2.0), 0.396177, 2e-6);
    assert_near(pp_protractor_dial_factor(&dial, 30.0 * PP_RAD, PP_PI / 2.0, false),
                0.5, 1e-9);
    protractor.sky = pp_sky_uniform();
    pp_protractor_dial_init(&dial, &protractor);
    assert_near(pp_protractor_dial_share(&dial, PP_PI / 2.0), 0.5, 2e-6);
}

/* Along a strip at gamma the density is L cos gamma cos^2 theta for receivers facing
 * the window, and L sin theta cos theta for receivers at right angles to it. The
 * auxiliary scales compared with sums over theta. */
static void auxiliary_scales_are_shares_of_the_strip(void **state)
{
    (void)state;
    for (int aside = 0; aside < 2; aside++) {
        struct pp_protractor protractor =
            of(aside ? PP_PROTRACTOR_ASIDE : PP_PROTRACTOR_AHEAD, true);
        struct pp_protractor_dial dial;
        pp_protractor_dial_init(&dial, &protractor);
        double gamma = 40.0 * PP_RAD, part = 0.0, whole = 0.0, end = 33.0 * PP_RAD;
        enum { N = 20000 };
        for (int i = 0; i < N; i++) {
            double theta = (i + 0.5) / N * PP_PI / 2.0;
            double weight = aside ? sin(theta) : cos(theta) * cos(gamma);
            double light =
                (1.0 + 2.0 * cos(theta) * sin(gamma)) * weight * cos(theta)
                * pp_glass_transmittance(&protractor.glass, cos(theta) * cos(gamma));
            whole += light;
            if (theta < end)
                part += light;
        }
        double azimuth = atan(tan(end) / cos(gamma));
        assert_near(pp_protractor_dial_factor(&dial, gamma, azimuth, false),
                    part / whole / 2.0, 1e-4);
    }
}

static double at(const struct pp_world *world, const struct pp_outside_light *light,
                 const struct pp_method *method, const struct pp_receiver *receiver,
                 double *external)
{
    struct pp_part part = {0};
    void *tools = NULL;
    if (method->refuses) {
        assert_null(method->refuses_room(world, light, receiver));
        assert_null(method->refuses(world, light, world->openings, receiver));
    }
    if (method->prepare)
        assert_int_equal(method->prepare(&tools, world, light, NULL), PP_OK);
    assert_int_equal(
        method->evaluate(world, light, world->openings, receiver, tools, &part, NULL),
        PP_OK);
    method->destroy_tools(tools);
    *external = part.external;
    return part.sky;
}

/* 300 windows, glazed or unglazed, some behind a skyline, and vertical receivers at any
 * position and with any bearing: the bias is below 1 % and the spread below 3 %,
 * because one average altitude represents the window. */
static void standing_points_are_near_to_exact(void **state)
{
    (void)state;
    struct dice dice = {83};
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (int i = 0; i < 300; i++) {
        char xml[900], skyline[100] = "";
        double sill = between(&dice, 0.0, 1.5);
        if (i % 3 == 0)
            snprintf(skyline, sizeof skyline, "<skyline wall='south' angle='%.3f'/>",
                     between(&dice, 5.0, 25.0));
        snprintf(xml, sizeof xml,
                 "<room version='1'><site ground-reflectance='0'/><sky type='%s'/>"
                 "<plan width='5.3' depth='7.1' height='3.4'/>"
                 "<window wall='south' left='%.3f' sill='%.3f' width='%.3f' "
                 "height='%.3f' glazing='%s'/>%s</room>",
                 i % 4 ? "overcast" : "uniform", between(&dice, 0.1, 2.0), sill,
                 between(&dice, 0.4, 3.1), between(&dice, 0.4, 3.3 - sill),
                 i % 2 ? "clear-single" : "none", skyline);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        double turn = between(&dice, -2.4, 2.4), external[2];
        const struct pp_receiver receiver = {
            {between(&dice, 0.3, 5.0), between(&dice, 0.8, 6.8), 1.2},
            {sin(turn), -cos(turn), 0},
            0,
            0.0};
        double exact = at(world, &light, &pp_method_exact, &receiver, &external[0]);
        double read =
            at(world, &light, &pp_method_protractor_upright, &receiver, &external[1]);
        if (exact > 0.005) {
            sum += read / exact - 1.0;
            squares += (read / exact - 1.0) * (read / exact - 1.0);
            count++;
        } else {
            assert_near(read, exact, 0.001);
        }
        pp_world_destroy(world);
    }
    print_message("# %d points of 0.5 %% and more: %+.4f on average, %.4f rms\n", count,
                  sum / count, sqrt(squares / count));
    assert_true(count > 60);
    assert_near(sum / count, 0.0, 0.01);
    assert_true(sqrt(squares / count) < 0.03);
}

/* A receiver that faces away, or has the whole window behind its plane, receives
 * nothing. */
static void what_lies_behind_the_receiver_does_not_count(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='5.3' depth='7.1' height='3.4'/>"
                "<window wall='south' left='0.7' sill='0.6' width='1.7' "
                "height='2.3'/></room>");
    double external;
    const struct pp_vec3 behind[] = {{0, 1, 0}, {-1, 0, 0}};
    for (int i = 0; i < 2; i++) {
        const struct pp_receiver receiver = {
            {i ? 0.3 : 1.5, 2.2, 1.1}, behind[i], 0, 0.0};
        assert_near(
            at(world, &light, &pp_method_protractor_upright, &receiver, &external), 0.0,
            0.0);
    }
    pp_world_destroy(world);
}

static void points_that_face_up_and_other_skies_are_refused(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='5.3' depth='7.1' height='3.4'/>"
                "<rooflight x='2' y='2' width='1' depth='1'/></room>");
    const struct pp_receiver up = {{2, 2, 1}, {0, 0, 1}, 0, 0.0};
    assert_non_null(pp_method_protractor_upright.refuses_room(world, &light, &up));
    assert_non_null(
        pp_method_protractor_upright.refuses(world, &light, world->openings, NULL));
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(straight_ahead_reads_what_a_skyline_hides),
        cmocka_unit_test(aside_reads_half_the_light_on_each_side),
        cmocka_unit_test(auxiliary_scales_are_shares_of_the_strip),
        cmocka_unit_test(standing_points_are_near_to_exact),
        cmocka_unit_test(what_lies_behind_the_receiver_does_not_count),
        cmocka_unit_test(points_that_face_up_and_other_skies_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
