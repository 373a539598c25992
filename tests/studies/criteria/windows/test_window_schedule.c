/* test_window_schedule.c - the schedule of windows: losses, and the names and order of
 * windows. */
#include "studies/criteria/windows/window_schedule.h"

#include <math.h>

#include "studies/criteria/criteria.h"
#include "tests/lib/room_of.h"

static void a_loss_is_what_the_ratio_leaves(void **state)
{
    (void)state;
    const struct pp_schedule_change half = {0.31, 0.155, NAN}, gain = {0.2, 0.25, NAN},
                                    unknown = {NAN, 0.3, NAN}, dark = {0.0, 0.1, NAN};
    assert_near(pp_schedule_loss(half), 0.5, 1e-12);
    assert_near(pp_schedule_ratio(half), 0.5, 1e-12);
    assert_near(pp_schedule_loss(gain), -0.25, 1e-12);
    assert_true(isnan(pp_schedule_loss(unknown)) && isnan(pp_schedule_loss(dark)));
}

/* One room with two windows: the sky of both and the sunlight of the first, now and
 * before. */
static void each_window_has_one_line_with_all_its_figures(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='6' depth='5' height='2.7'/>\n"
        "<window name='A' wall='south' left='1' sill='1' width='1' height='1'/>\n"
        "<window wall='south' left='3' sill='1' width='1' height='1'/></room>");
    struct pp_study_room room = {.world = world, .file = "test.xml"};
    struct pp_finding sky[2] = {
        pp_finding_of(PP_FIGURE_SHARE, 0.7, 0.8, false, "A, south"),
        pp_finding_of(PP_FIGURE_SHARE, 0.9, 0.8, false, "W1, south")};
    struct pp_finding sun[2] = {
        pp_finding_of(PP_FIGURE_SHARE, 0.3, NAN, false, "A, south, year"),
        pp_finding_of(PP_FIGURE_SHARE, 0.1, NAN, false, "A, south, winter")};
    for (int i = 0; i < 2; i++) {
        sky[i].line = 2 + i;
        sun[i].line = 2;
    }
    sun[0].season = "year";
    sun[1].season = "winter";
    sky[0].now_unshaded = 0.25;
    pp_finding_compares(&sky[0], PP_FIGURE_FACTOR, 0.21, 0.3);
    pp_finding_compares(&sky[1], PP_FIGURE_FACTOR, 0.27, 0.3);
    pp_finding_compares(&sun[0], PP_FIGURE_SHARE, 0.3, 0.4);
    pp_finding_compares(&sun[1], PP_FIGURE_SHARE, 0.1, 0.2);
    struct pp_answer answers[] = {
        {.criterion = &pp_criterion_former_sky, .findings = {.list = sky, .count = 2}},
        {.criterion = &pp_criterion_sunlight, .findings = {.list = sun, .count = 2}}};
    struct pp_assessment assessment = {.room = &room, .answers = {answers, 2}};
    struct pp_window_schedule schedule;
    struct pp_error err;
    assert_int_equal(pp_window_schedule_of(&schedule, &assessment, 1, &err), PP_OK);
    assert_int_equal(schedule.count, 2);
    assert_false(schedule.probable);
    const struct pp_schedule_row *a = &schedule.rows[0], *second = &schedule.rows[1];
    assert_string_equal(a->window, "A");
    assert_string_equal(second->window, "W1");
    assert_near(pp_schedule_ratio(a->changes[PP_SCHEDULE_SKY]), 0.7, 1e-12);
    assert_near(a->changes[PP_SCHEDULE_YEAR].proposed, 0.3, 1e-12);
    assert_near(a->changes[PP_SCHEDULE_WINTER].existing, 0.2, 1e-12);
    assert_near(a->changes[PP_SCHEDULE_BARE].proposed, 0.25, 1e-12);
    assert_true(isnan(second->changes[PP_SCHEDULE_BARE].proposed));
    assert_false(schedule.has_cumulative);
    assert_true(isnan(second->changes[PP_SCHEDULE_YEAR].proposed));
    assert_true(isnan(a->changes[PP_SCHEDULE_AREA].proposed));
    assert_true(a->verdict == PP_NOT_MET && second->verdict == PP_MET);
    pp_window_schedule_clear(&schedule);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_loss_is_what_the_ratio_leaves),
        cmocka_unit_test(each_window_has_one_line_with_all_its_figures),
    };
    add_tests(tests, NULL, NULL);
}
