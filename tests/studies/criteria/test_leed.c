/* test_leed.c - LEED points for a year whose areas are known. */
#include "studies/criteria/criteria.h"
#include <stdio.h>
#include <string.h>

#include "model/results/sheets/lm83_grid.h"
#include "studies/criteria/rules/rule_set.h"
#include "tests/lib/room_of.h"

static struct pp_annual_hour sunny = {.direct_lx = 80000.0};

/* A completed year on a grid with blinds and LM-83's hours. */
static struct pp_annual_sheet year_of(double sda, double sda_error, double ase)
{
    return (struct pp_annual_sheet){
        .receiver_count = 100,
        .is_grid = true,
        .has_blinds = true,
        .blinds_of_lm83 = true,
        .standard_hours = true,
        .finished = true,
        .hour_count = 1,
        .hours = &sunny,
        .plane = {.sda = {sda, sda_error}, .ase = {ase, 0.0}}};
}

static struct pp_finding_list judged(const struct pp_annual_sheet *year)
{
    const struct pp_inquiry inquiry = {.year = year};
    struct pp_finding_list findings = {0};
    assert_int_equal(pp_criterion_leed.evaluate(&inquiry, &findings, NULL), PP_OK);
    return findings;
}

/* 60 % exceeds the thresholds of 40 and 55, but not 75. */
static void each_threshold_that_is_reached_is_a_point(void **state)
{
    (void)state;
    const struct pp_annual_sheet year = year_of(0.6, 0.0, 0.1);
    struct pp_finding_list findings = judged(&year);
    assert_int_equal(findings.count, 4);
    assert_int_equal(findings.list[0].verdict, PP_MET);
    assert_int_equal(findings.list[1].verdict, PP_MET);
    assert_int_equal(findings.list[2].verdict, PP_NOT_MET);
    assert_int_equal(findings.list[3].verdict, PP_MET); /* 10 % is not above 10 % */
    assert_false(findings.list[0].is_optional);
    assert_true(findings.list[1].is_optional && findings.list[3].is_optional);
    pp_finding_list_clear(&findings);
}

/* With too much sun on 15 % of its area, a room fails version 4 of the credit. Version 4.1
 * keeps its area, and requires an explanation. */
static void sun_on_15_percent_fails_version_4_alone(void **state)
{
    (void)state;
    const struct pp_annual_sheet year = year_of(0.6, 0.0, 0.15);
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='3.7' depth='5.3' height='2.9'/></room>");
    struct pp_rule_set version_4;
    const struct pp_inquiry inquiry = {
        .year = &year, .world = world, .rules = &version_4};
    struct pp_finding_list findings = {0};
    assert_true(pp_rule_set_init(&version_4, "leed-v4"));
    assert_int_equal(version_4.criterion.evaluate(&inquiry, &findings, NULL), PP_OK);
    assert_int_equal(findings.count, 3);
    assert_int_equal(findings.list[0].verdict, PP_MET);
    assert_int_equal(findings.list[2].verdict, PP_NOT_MET);
    assert_false(findings.list[2].is_optional);
    pp_finding_list_clear(&findings);
    pp_world_destroy(world);

    findings = judged(&year);
    assert_int_equal(findings.list[0].verdict, PP_MET);
    assert_int_equal(findings.list[3].verdict, PP_NOT_MET);
    assert_true(findings.list[3].is_optional);
    assert_non_null(strstr(findings.list[3].note, "explain"));
    pp_finding_list_clear(&findings);
}

/* An ASE of 0 says nothing if the weather has no direct sun. */
static void without_direct_sun_no_points_are_given(void **state)
{
    (void)state;
    struct pp_annual_sheet year = year_of(0.9, 0.0, 0.0);
    year.hour_count = 0;
    struct pp_finding_list findings = judged(&year);
    assert_int_equal(findings.count, 1);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    assert_non_null(strstr(findings.list[0].note, "no direct sun"));
    pp_finding_list_clear(&findings);
}

/* One standard error from the threshold: 84 % probability, which is not enough. */
static void area_near_a_threshold_is_undecided(void **state)
{
    (void)state;
    const struct pp_annual_sheet year = year_of(0.41, 0.01, 0.101);
    struct pp_finding_list findings = judged(&year);
    assert_int_equal(findings.list[0].verdict, PP_UNDECIDED);
    assert_near(findings.list[0].confidence, 0.8413, 1e-4);
    assert_int_equal(findings.list[3].verdict, PP_NOT_MET);
    pp_finding_list_clear(&findings);
}

static void no_points_without_grid_blinds_or_year(void **state)
{
    (void)state;
    struct pp_annual_sheet year = year_of(0.9, 0.0, 0.0);
    year.is_grid = false;
    struct pp_finding_list findings = judged(&year);
    assert_int_equal(findings.count, 1);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    pp_finding_list_clear(&findings);
    year = year_of(0.9, 0.0, 0.0);
    year.blinds_of_lm83 = false; /* blinds that are always closed */
    findings = judged(&year);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    pp_finding_list_clear(&findings);
    findings = judged(NULL);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    assert_non_null(strstr(findings.list[0].note, "--weather"));
    pp_finding_list_clear(&findings);
}

/* Words on the grid of a room of 3.6 x 4.8 m with these elements. */
static void words_of_grid(char words[PP_LM83_GRID_WORDS], const char *elements)
{
    char xml[400];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='3.6' depth='4.8' height='2.6'/>%s</room>",
             elements);
    struct pp_world *world = pp_test_world(xml);
    const struct pp_annual_sheet sheet = {.world = world,
                                          .receivers = world->receivers,
                                          .receiver_count = world->receiver_count,
                                          .is_grid = true};
    pp_lm83_grid_words(words, &sheet);
    pp_world_destroy(world);
}

/* The default grid leaves out 0.5 m along the walls: 2.6 x 3.8 = 9.88 of 3.6 x 4.8 =
 * 17.28 m2. */
static void a_grid_that_is_not_that_of_lm83_is_named(void **state)
{
    (void)state;
    char words[PP_LM83_GRID_WORDS];
    words_of_grid(words, "");
    assert_non_null(strstr(words, ": 0.85 m above the floor instead of 0.76 m"));
    assert_non_null(strstr(words, ", only 9.88 of the 17.3 m2 of the plane;"));
    assert_null(strstr(words, "apart"));
    words_of_grid(words,
                  "<working-plane height='0.76'/><grid spacing='0.9' margin='0'/>");
    assert_non_null(strstr(words, "LM-83: points 0.90 m apart, not 0.6 m;"));
    words_of_grid(words,
                  "<working-plane height='0.76'/><grid spacing='0.6' margin='0'/>");
    assert_string_equal(words, "");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_grid_that_is_not_that_of_lm83_is_named),
        cmocka_unit_test(each_threshold_that_is_reached_is_a_point),
        cmocka_unit_test(sun_on_15_percent_fails_version_4_alone),
        cmocka_unit_test(without_direct_sun_no_points_are_given),
        cmocka_unit_test(area_near_a_threshold_is_undecided),
        cmocka_unit_test(no_points_without_grid_blinds_or_year),
    };
    add_tests(tests, NULL, NULL);
}
