/* test_hand_range.c - likely ranges of hand figures for the year. */
#include "tests/lib/near.h"

#include "studies/year/hand/hand_range.h"
#include "studies/year/hand/year_method.h"

static double width_of(struct pp_hand_interval range)
{
    return range.high - range.low;
}

/* All methods have a range for every orientation at the middle of the scale. */
static void every_method_has_ranges_between_none_and_all_hours(void **state)
{
    (void)state;
    for (int i = 0; pp_year_methods[i]; i++)
        for (int facade = 0; facade < 4; facade++)
            for (double autonomy = 0.02; autonomy < 1.0; autonomy += 0.07) {
                struct pp_hand_interval range =
                    pp_hand_range_of(pp_year_methods[i]->name, facade, autonomy);
                if (isnan(range.low) && autonomy > 0.3 && autonomy < 0.9)
                    fail_msg("%s has no range at %g, facade %d",
                             pp_year_methods[i]->name, autonomy, facade);
                assert_false(range.low < 0.0 || range.high > 1.0
                             || range.low > range.high);
            }
}

/* Classes with the light of each hour are close to the simulation; the daylight factor
 * times diffuse light is far below it. */
static void ranges_are_wider_for_rougher_methods(void **state)
{
    (void)state;
    struct pp_hand_interval fine = pp_hand_range_of("classes-scaled", 0, 0.55);
    struct pp_hand_interval rough = pp_hand_range_of("df-diffuse", 0, 0.55);
    assert_true(3.0 * width_of(fine) < width_of(rough));
    assert_true(rough.high - 0.55 > 2.0 * (0.55 - rough.low));
}

static void other_openings_and_methods_have_no_range(void **state)
{
    (void)state;
    assert_true(isnan(pp_hand_range_of("df-diffuse", -1, 0.55).low));
    assert_true(isnan(pp_hand_range_of("exact", 0, 0.55).high));
    /* East and west share their ranges. */
    assert_near(pp_hand_range_of("doe2", 1, 0.55).low,
                pp_hand_range_of("doe2", 3, 0.55).low, 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_has_ranges_between_none_and_all_hours),
        cmocka_unit_test(ranges_are_wider_for_rougher_methods),
        cmocka_unit_test(other_openings_and_methods_have_no_range),
    };
    add_tests(tests, NULL, NULL);
}
