/* test_light_bound.c - hand figures that require more light than enters the room are
 * rejected. */
#include "methods/reflected/light_bound.h"

#include "methods/evaluate.h"
#include "tests/lib/random_rooms.h"
#include "tests/lib/sized.h"

/* An unglazed horizontal opening of 2 x 3 m under the open sky admits 6 m2 times 1, on
 * a plane of 20 m2. A black room reflects only by the opening's 0.1. */
static void the_bound_is_what_a_sum_by_hand_gives(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='5' height='3'/>"
                "<finishes floor='0' walls='0' ceiling='0'/>"
                "<rooflight x='1' y='1' width='2' depth='3' glazing='none'/></room>");
    struct pp_light_bound bound = pp_light_bound(world, &light);
    double reflectance = 0.1 * 6.0 / (2 * 20 + 18 * 3);
    assert_near(bound.direct, 1.1 * 6.0 / 20.0, 1e-9);
    assert_near(bound.any, bound.direct / (1.0 - reflectance), 1e-9);
    pp_world_destroy(world);
}

static struct pp_report report_of(const struct pp_world *world,
                                  const struct pp_outside_light *light)
{
    struct pp_report report = {.world = world,
                               .light = *light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count,
                               .finished = true};
    assert_int_equal(
        pp_methods_evaluate(&report, "all,exact+split-flux,exact+sphere", NULL), PP_OK);
    return report;
}

/* split-flux gives 1,046 %, since it omits openings from its areas and mean
 * reflectances; the path tracer gives 26 %. `sphere` includes openings and is not
 * rejected. */
static void split_flux_in_a_white_glass_box_is_refused(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='4' height='3'/>"
                "<finishes floor='0.95' walls='0.99' ceiling='0.99'/>"
                "<window wall='south' left='0' sill='0.5' width='4' height='2.5'/>"
                "<window wall='north' left='0' sill='0.5' width='4' height='2.5'/>"
                "<window wall='east' left='0' sill='0.5' width='4' height='2.5'/>"
                "<point x='2' y='2'/></room>");
    struct pp_report report = report_of(world, &light);
    const struct pp_column *split = pp_report_find(&report, PP_IRC, "split-flux");
    assert_true(isnan(split->average.value) && isnan(split->points[0].value));
    assert_non_null(strstr(split->average.why,
                           "the result of 1046 % exceeds the upper limit set by"));
    const struct pp_column *pair = pp_report_find(&report, PP_DF, "exact+split-flux");
    assert_true(isnan(pair->points[0].value));
    assert_non_null(strstr(pair->points[0].why, "split-flux: the result"));
    assert_near(pp_report_find(&report, PP_IRC, "sphere")->average.value, 0.42, 0.005);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void no_figure_of_random_rooms_is_refused(void **state)
{
    (void)state;
    for (int room = 0; room < PP_SIZED(60, 20, 6); room++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, (uint64_t)room, 2);
        struct pp_report report = report_of(world, &light);
        for (int i = 0; i < report.column_count; i++) {
            const char *why = report.columns[i].average.why;
            if (why && strstr(why, "exceeds the upper limit set by"))
                fail_msg("room %d, %s: %s", room, report.columns[i].name, why);
        }
        pp_report_clear(&report);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bound_is_what_a_sum_by_hand_gives),
        cmocka_unit_test(split_flux_in_a_white_glass_box_is_refused),
        cmocka_unit_test(no_figure_of_random_rooms_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
