/* test_room_cases.c - hand figures compared with the simulation as cases: the limit is
 * the band of the atlas, and both parts of a difference add up. */
#include "studies/research/validation/room_cases.h"

#include <stdlib.h>
#include <string.h>

#include "model/room/room.h"
#include "model/room/room_light.h"
#include "studies/study_report.h"
#include "studies/research/validation/suite.h"
#include "tests/lib/near.h"

static const char hall[] =
    "<room version='1' name='Hall'><plan width='4.3' depth='6.1' height='2.9'/>"
    "<window wall='south' left='0.7' sill='0.9' width='2.3' height='1.7'/>"
    "<point x='2.1' y='1.7'/><point x='2.1' y='4.7'/></room>";

/* The room, its report and the worlds of its methods, simulated. */
struct traced {
    struct pp_building *building;
    struct pp_study_room room;
    struct pp_study_options options;
    struct pp_report report;
    struct pp_own_worlds *worlds;
    struct pp_known_cases cases;
};

static void trace(struct traced *t, const char *methods)
{
    *t = (struct traced){.options = PP_STUDY_OPTIONS_NONE};
    struct pp_mistakes mistakes;
    struct pp_world *world;
    struct pp_outside_light light;
    bool finished = true, by_clock = false;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(
        pp_building_parse(&t->building, hall, strlen(hall), &mistakes, NULL), PP_OK);
    struct pp_room *description = pp_building_room(t->building, 0);
    assert_int_equal(pp_world_create(&world, description, &mistakes, NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    assert_int_equal(pp_room_light(&light, description, NULL), PP_OK);
    pp_study_room_init(&t->room, "test", t->building, 0, description, world, &light);
    t->options.methods = methods;
    t->options.samples = 16;
    t->options.threads = 1;
    t->cases = pp_known_case_none();
    assert_int_equal(pp_study_report_methods(&t->report, &t->room, &t->options, NULL),
                     PP_OK);
    assert_int_equal(pp_own_world_list(&t->worlds, description, &t->report, NULL),
                     PP_OK);
    assert_int_equal(pp_study_report_traced(&t->report, &t->options, &by_clock, NULL),
                     PP_OK);
    assert_int_equal(
        pp_own_world_trace(t->worlds, &t->options, &finished, &by_clock, NULL), PP_OK);
}

static void clear(struct traced *t)
{
    pp_known_case_clear(&t->cases);
    pp_own_world_destroy(t->worlds);
    pp_report_clear(&t->report);
    pp_study_room_clear(&t->room);
    pp_building_destroy(t->building);
}

static struct pp_column *column_of(struct traced *t, enum pp_component component,
                                   const char *name)
{
    struct pp_column *column =
        (struct pp_column *)pp_report_find(&t->report, component, name);
    assert_non_null(column);
    return column;
}

static const struct pp_known_case *case_of(const struct traced *t, const char *what,
                                           const char *by)
{
    for (int i = 0; i < t->cases.count; i++)
        if (strcmp(t->cases.list[i].what, what) == 0
            && strcmp(t->cases.list[i].by, by) == 0)
            return &t->cases.list[i];
    fail_msg("there is no case %s by %s", what, by);
    return NULL;
}

/* A band whose upper limit is 2.9 standard errors below the simulated value contains
 * it, one that is 3.1 below does not; the same for its lower limit. */
static void three_standard_errors_widen_a_band(void **state)
{
    (void)state;
    static const double beyond[] = {2.9, 3.1};
    struct traced t;
    trace(&t, "exact+bre");
    struct pp_column *column = column_of(&t, PP_DF, "exact+bre");
    const struct pp_column *traced = column_of(&t, PP_DF, "traced");
    free(column->bands);
    column->bands = malloc(2 * sizeof *column->bands);
    assert_non_null(column->bands);
    for (int i = 0; i < 2; i++) {
        double truth = traced->points[0].value, se = traced->points[0].std_error;
        column->bands[0] = (struct pp_band_ends){truth - 0.01, truth - beyond[i] * se};
        truth = traced->points[1].value, se = traced->points[1].std_error;
        column->bands[1] = (struct pp_band_ends){truth + beyond[i] * se, truth + 0.01};
        pp_known_case_clear(&t.cases);
        pp_room_cases_of_methods(&t.cases, "test", &t.report, t.worlds);
        for (int k = 0; k < 2; k++) {
            const struct pp_known_case *one = case_of(
                &t, k == 0 ? "df at 2.10, 1.70" : "df at 2.10, 4.70", "exact+bre");
            assert_true(pp_known_case_is_judged(one));
            assert_int_equal(pp_known_case_is_right(one), i == 0);
            assert_int_equal(fabs(pp_known_case_share(one)) <= 1.0, i == 0);
        }
    }
    clear(&t);
}

/* The difference of bre consists of the parts of its ground and its formula; exact uses
 * the room's own sky. */
static void both_parts_of_a_case_add_up_to_its_difference(void **state)
{
    (void)state;
    struct traced t;
    trace(&t, "exact+bre");
    pp_room_cases_of_methods(&t.cases, "test", &t.report, t.worlds);
    int points = 0;
    for (int i = 0; i < t.cases.count; i++) {
        const struct pp_known_case *one = &t.cases.list[i];
        assert_near(one->assumption + one->formula, one->answer - one->expected, 1e-12);
        assert_string_equal(one->room, "Hall");
        assert_string_equal(one->group, one->by);
        points += strstr(one->what, "at 2.10, 1.70") != NULL;
    }
    assert_int_equal(points, 4); /* exact's SC and ERC, bre's IRC, the pair's DF */
    assert_true(case_of(&t, "irc at 2.10, 1.70", "bre")->assumption < 0.0);
    assert_near(case_of(&t, "sc at 2.10, 1.70", "exact")->assumption, 0.0, 0.0);
    clear(&t);
}

/* Without a band a case is neither correct nor wrong and is not counted, but the reason
 * is given. */
static void without_a_band_there_is_no_verdict(void **state)
{
    (void)state;
    struct traced t;
    int count;
    trace(&t, "bre");
    t.report.no_bands = "no bands: a reason";
    pp_room_cases_of_methods(&t.cases, "test", &t.report, t.worlds);
    struct pp_suite_score score = pp_suite_score(&pp_suite_rooms, &t.cases);
    assert_true(t.cases.count > 0);
    assert_int_equal(score.unjudged, t.cases.count);
    assert_int_equal(score.count + score.traced + score.wrong + score.traced_wrong, 0);
    assert_true(score.passes);
    assert_string_equal(pp_known_case_reason(&t.cases, 0, &count),
                        "no bands: a reason");
    assert_int_equal(count, t.cases.count);
    assert_null(pp_known_case_reason(&t.cases, 1, &count));
    clear(&t);
}

static const struct pp_known_case *of_radiance(struct pp_known_cases *cases,
                                               double traced, double error,
                                               double radiance, double its_error)
{
    static const struct pp_world world = {.name = (char *)"Hall"};
    pp_room_cases_of_radiance(
        cases, "test", &world, (struct pp_vec3){2.1, 1.7, 0.85},
        (struct pp_reading){.value = traced, .std_error = error},
        (struct pp_reading){.value = radiance, .std_error = its_error});
    return &cases->list[cases->count - 1];
}

/* 3 sqrt(3^2 + 4^2) = 15 for two sampled values; otherwise 1 %. */
static void another_program_may_differ_by_chance_or_one_per_cent(void **state)
{
    (void)state;
    struct pp_known_cases cases = pp_known_case_none();
    assert_true(pp_known_case_is_right(of_radiance(&cases, 0.0314, 3e-4, 0.03, 4e-4)));
    assert_false(pp_known_case_is_right(of_radiance(&cases, 0.0316, 3e-4, 0.03, 4e-4)));
    assert_true(pp_known_case_is_right(of_radiance(&cases, 0.03029, 3e-6, 0.03, 4e-6)));
    assert_false(
        pp_known_case_is_right(of_radiance(&cases, 0.03031, 3e-6, 0.03, 4e-6)));
    assert_string_equal(cases.list[0].what, "df at 2.100, 1.700, 0.850");
    assert_near(cases.list[0].std_error, 5e-4, 1e-15);
    pp_known_case_clear(&cases);
}

/* The share of a limit is calculated on the side of the difference, for any limit on
 * the other side. */
static void a_share_is_of_the_limit_on_its_side(void **state)
{
    (void)state;
    struct pp_known_case one = {
        .answer = 1.2, .expected = 1.0, .limit = 0.4, .least = -0.1};
    assert_near(pp_known_case_share(&one), 0.5, 1e-12);
    one.answer = 0.95;
    assert_near(pp_known_case_share(&one), -0.5, 1e-12);
    one.least = 0.1; /* the band does not contain the figure itself */
    one.answer = 1.25;
    assert_near(pp_known_case_share(&one), 0.0, 1e-12);
    one.answer = 1.4;
    assert_near(pp_known_case_share(&one), 1.0, 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_standard_errors_widen_a_band),
        cmocka_unit_test(both_parts_of_a_case_add_up_to_its_difference),
        cmocka_unit_test(without_a_band_there_is_no_verdict),
        cmocka_unit_test(another_program_may_differ_by_chance_or_one_per_cent),
        cmocka_unit_test(a_share_is_of_the_limit_on_its_side),
    };
    add_tests(tests, NULL, NULL);
}
