/* test_finding.c - verdicts on hand figures with a likely range. */
#include "studies/criteria/finding.h"

#include "tests/lib/near.h"

/* Verdict for a hand figure of 0.69 % with this likely range and target (per cent). */
static enum pp_verdict verdict_for(double low, double high, double wanted)
{
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_FACTOR, 0.0069, wanted / 100.0, false, "minimum");
    pp_finding_by_hand(&finding, (struct pp_band_ends){low / 100.0, high / 100.0});
    return finding.verdict;
}

/* Met or not met only if the figure and its whole range are on one side of the
 * target. */
static void a_target_in_the_range_is_undecided(void **state)
{
    (void)state;
    assert_int_equal(verdict_for(0.40, 0.74, 0.71), PP_UNDECIDED);
    assert_int_equal(verdict_for(0.40, 0.74, 0.45), PP_UNDECIDED);
    assert_int_equal(verdict_for(0.40, 0.74, 0.35), PP_MET);
    assert_int_equal(verdict_for(0.40, 0.74, 0.80), PP_NOT_MET);
}

/* A figure above its range is probably too high, so a target between them is not
 * certainly met. */
static void a_target_between_figure_and_range_is_undecided(void **state)
{
    (void)state;
    assert_int_equal(verdict_for(0.30, 0.60, 0.65), PP_UNDECIDED);
    assert_int_equal(verdict_for(0.80, 1.20, 0.75), PP_UNDECIDED);
    assert_int_equal(verdict_for(0.30, 0.60, 0.25), PP_MET);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_target_in_the_range_is_undecided),
        cmocka_unit_test(a_target_between_figure_and_range_is_undecided),
    };
    add_tests(tests, NULL, NULL);
}
