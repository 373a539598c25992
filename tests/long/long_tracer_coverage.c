/* long_tracer_coverage.c - the tracer's values lie within their standard errors as often
 * as Student's t says: over 200 rooms, and over 60 seeds of 12 rooms. */
#include "tests/lib/random_rooms.h"

static void assert_true_errors(struct pp_coverage c)
{
    print_message("# %d values: %.1f %% within 1, %.1f %% within 2, %.2f %% beyond 4\n",
                  c.count, 100.0 * c.within_1 / c.count, 100.0 * c.within_2 / c.count,
                  100.0 * c.beyond_4 / c.count);
    assert_in_range(1000 * c.within_1 / c.count, 640, 740);
    assert_in_range(1000 * c.within_2 / c.count, 935, 970);
    assert_in_range(1000 * c.beyond_4, 0, 3 * c.count);
}

static void sky_components_of_200_rooms_lie_within_their_errors(void **state)
{
    (void)state;
    assert_true_errors(pp_test_sky_coverage(1000, 200));
}

static void daylight_factors_lie_within_their_errors_over_seeds(void **state)
{
    (void)state;
    assert_true_errors(pp_test_df_coverage(2000, 12, 60));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sky_components_of_200_rooms_lie_within_their_errors),
        cmocka_unit_test(daylight_factors_lie_within_their_errors_over_seeds),
    };
    return cmocka_run_group_tests_name("long_tracer_coverage", tests, NULL, NULL);
}
