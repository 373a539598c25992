/* test_en17037_hours.c - method 2 of EN 17037 with points whose illuminances are known,
 * and the level that is met. */
#include "studies/criteria/criteria.h"
#include "studies/criteria/en17037/en17037_level.h"
#include "tests/lib/room_of.h"

/* Findings on 20 points that have lowest_lx, 30 lx more, and so on, in half of the
 * daylight hours. rooflight: the room has a rooflight instead of a window. */
static struct pp_finding_list judged_hours(double lowest_lx, bool rooflight)
{
    static const char window[] = "<window wall=\"south\" left=\"1\" sill=\"1\" "
                                 "width=\"2\" height=\"1.2\"/>";
    static const char roof[] =
        "<rooflight x=\"1\" y=\"2\" width=\"1.2\" depth=\"1.5\"/>";
    struct pp_annual_figures points[20] = {{.median_lx = {0.0, 0.0}}};
    char text[512];
    for (int i = 0; i < 20; i++)
        points[i].median_lx.value = lowest_lx + 30.0 * i;
    snprintf(
        text, sizeof text,
        "<room version=\"1\"><plan width=\"4\" depth=\"6\" height=\"3\"/>%s</room>",
        rooflight ? roof : window);
    struct pp_world *world = pp_test_world(text);
    const struct pp_annual_sheet year = {.receiver_count = 20,
                                         .is_grid = true,
                                         .finished = true,
                                         .weather = "Nowhere; 8760 records",
                                         .points = points};
    const struct pp_inquiry inquiry = {.world = world, .year = &year};
    struct pp_finding_list findings = {0};
    assert_int_equal(pp_criterion_en17037_hours.evaluate(&inquiry, &findings, NULL),
                     PP_OK);
    pp_world_destroy(world);
    return findings;
}

/* The median is midway between the 10th and the 11th point: 385 lx. 95 % of 20 points
 * are 19, the lowest of which has 130 lx. */
static void half_of_the_points_reach_the_median_of_their_illuminances(void **state)
{
    (void)state;
    struct pp_finding_list findings = judged_hours(100.0, false);
    assert_int_equal(findings.count, 6);
    assert_near(findings.list[0].figure, 385.0, 1e-9);
    assert_near(findings.list[0].reached_over, 13.0 / 20.0, 1e-9); /* 310 lx and more */
    assert_int_equal(findings.list[0].verdict, PP_MET);
    assert_near(findings.list[1].figure, 130.0, 1e-9);
    assert_int_equal(findings.list[1].verdict, PP_MET);
    assert_int_equal(findings.list[2].verdict, PP_NOT_MET);
    struct pp_en17037_level level = pp_en17037_level_of(&findings);
    assert_true(level.judged);
    assert_int_equal(level.reached, PP_EN17037_MINIMUM);
    assert_int_equal(level.perhaps, PP_EN17037_MINIMUM);
    assert_non_null(strstr(findings.basis, "hour of Nowhere, in"));
    assert_non_null(strstr(findings.basis, "Level reached: minimum"));
    pp_finding_list_clear(&findings);
}

/* With rooflights 300 lx are required over 95 % of the plane. */
static void rooflights_need_the_target_nearly_everywhere(void **state)
{
    (void)state;
    struct pp_finding_list findings = judged_hours(100.0, true);
    assert_int_equal(findings.count, 3);
    assert_near(findings.list[0].figure, 130.0, 1e-9);
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_NONE);
    pp_finding_list_clear(&findings);
    findings = judged_hours(480.0, true); /* 19 points have 510 lx or more */
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_MEDIUM);
    pp_finding_list_clear(&findings);
}

/* An undecided finding makes its level undecided, and the levels above it that would be
 * met. */
static void undecided_levels_are_perhaps_reached(void **state)
{
    (void)state;
    char words[PP_EN17037_LEVEL_WORDS];
    struct pp_finding_list findings = judged_hours(300.0, false);
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_MEDIUM);
    findings.list[0].verdict = PP_UNDECIDED;
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_NONE);
    pp_en17037_level_words(words, &findings);
    assert_string_equal(words, "none, perhaps medium");
    pp_finding_list_clear(&findings);
}

/* The worst view decides. */
static void levels_of_several_views_are_joined(void **state)
{
    (void)state;
    struct pp_finding list[] = {
        pp_finding_of(PP_FIGURE_SHARE, 0.01, 0.05, true, "desk, minimum: DGP"),
        pp_finding_of(PP_FIGURE_SHARE, 0.03, 0.05, true, "desk, medium: DGP"),
        pp_finding_of(PP_FIGURE_SHARE, 0.02, 0.05, true, "view 2, minimum: DGP"),
        pp_finding_of(PP_FIGURE_SHARE, 0.07, 0.05, true, "view 2, medium: DGP")};
    struct pp_finding_list findings = {.list = list, .count = 4};
    for (int i = 0; i < 4; i++)
        list[i].level = i % 2 == 0 ? PP_EN17037_MINIMUM : PP_EN17037_MEDIUM;
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_MINIMUM);
}

/* A view may have the name of a level. */
static void the_name_of_a_view_determines_no_level(void **state)
{
    (void)state;
    struct pp_finding list[] = {
        pp_finding_of(PP_FIGURE_SHARE, 0.01, 0.05, true, "high: desk, minimum: DGP")};
    struct pp_finding_list findings = {.list = list, .count = 1};
    list[0].level = PP_EN17037_MINIMUM;
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_MINIMUM);
}

static void a_level_without_findings_is_not_reached(void **state)
{
    (void)state;
    struct pp_finding list[] = {
        pp_finding_of(PP_FIGURE_SHARE, 0.01, 0.05, true, "medium: DGP")};
    struct pp_finding_list findings = {.list = list, .count = 1};
    list[0].level = PP_EN17037_MEDIUM;
    assert_int_equal(pp_en17037_level_of(&findings).reached, PP_EN17037_NONE);
}

static void without_a_year_nothing_is_judged(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version=\"1\"><plan width=\"4\" depth=\"6\" height=\"3\"/></room>");
    const struct pp_inquiry inquiry = {.world = world};
    struct pp_finding_list findings = {0};
    pp_criterion_en17037_hours.evaluate(&inquiry, &findings, NULL);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    assert_false(pp_en17037_level_of(&findings).judged);
    pp_finding_list_clear(&findings);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(half_of_the_points_reach_the_median_of_their_illuminances),
        cmocka_unit_test(rooflights_need_the_target_nearly_everywhere),
        cmocka_unit_test(undecided_levels_are_perhaps_reached),
        cmocka_unit_test(levels_of_several_views_are_joined),
        cmocka_unit_test(the_name_of_a_view_determines_no_level),
        cmocka_unit_test(a_level_without_findings_is_not_reached),
        cmocka_unit_test(without_a_year_nothing_is_judged),
    };
    add_tests(tests, NULL, NULL);
}
