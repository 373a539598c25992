/* test_limits.c - limits printed in codes, tested just above and just below. */
#include <stdio.h>

#include "tests/lib/opened.h"

static struct pp_test_opened judged(const char *criteria, const char *outside)
{
    char xml[900];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='4.1' depth='6.3' height='2.9'/>"
             "<window wall='south' left='0.7' sill='0.95' width='2.6' height='1.3'/>"
             "%s</room>",
             outside);
    struct pp_test_opened opened = pp_test_open(xml);
    assert_int_equal(pp_study_judge(opened.study, criteria, 0.0, NULL), PP_OK);
    return opened;
}

/* 1 % in bedrooms, 1.5 % in living rooms, 2 % in kitchens [BS8206], for one average. */
static void dwellings_ask_for_one_to_two_per_cent(void **state)
{
    (void)state;
    static const double wanted[] = {0.01, 0.015, 0.02};
    struct pp_test_opened opened = judged("average", "");
    assert_int_equal(pp_study_judgement_count(opened.study), 3);
    double average = pp_study_judgement(opened.study, 0).figure;
    assert_true(average > 0.0);
    for (int i = 0; i < 3; i++) {
        struct pp_judgement one = pp_study_judgement(opened.study, i);
        assert_near(one.wanted, wanted[i], 0.0);
        assert_near(one.figure, average, 0.0);
        assert_int_equal(one.verdict, average >= wanted[i] ? PP_MET : PP_NOT_MET);
    }
    pp_test_close(&opened);
}

/* 25 degrees [BR209]: a skyline at infinite distance of 24.8 degrees meets the rule,
 * one of 25.2 does not. */
static void obstructions_may_rise_to_25_degrees(void **state)
{
    (void)state;
    static const double degrees[] = {24.8, 25.2};
    for (int i = 0; i < 2; i++) {
        char skyline[80];
        snprintf(skyline, sizeof skyline, "<skyline wall='south' angle='%g'/>",
                 degrees[i]);
        struct pp_test_opened opened = judged("obstruction", skyline);
        struct pp_judgement one = pp_study_judgement(opened.study, 0);
        assert_int_equal(one.verdict, i ? PP_STATED : PP_MET);
        assert_near(one.figure / one.wanted, degrees[i] / 25.0, 1e-9);
        pp_test_close(&opened);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dwellings_ask_for_one_to_two_per_cent),
        cmocka_unit_test(obstructions_may_rise_to_25_degrees),
    };
    add_tests(tests, NULL, NULL);
}
