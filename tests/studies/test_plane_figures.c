/* test_plane_figures.c - figures of a plane, from readings whose sums are calculated by
 * hand. */
#include "studies/plane_figures.h"

#include "tests/lib/near.h"

static struct pp_reading sampled(double value, double std_error)
{
    struct pp_reading reading = pp_reading_of(value);
    reading.std_error = std_error;
    return reading;
}

/* 0.8, 6, 1.5 and 3.7 %: mean 3 %, minimum 0.8 %, uniformity 0.8/3. The median is the
 * mean of 1.5 and 3.7 %. Three of four reach 1 %, two 2 %, one 5 %. With independent
 * errors of 1, 2, 2 and 4 hundredths of a per cent, the error of the mean is the square
 * root of 25 divided by 4. */
static void figures_of_four_points_are_as_worked_by_hand(void **state)
{
    (void)state;
    const struct pp_reading points[] = {sampled(0.008, 1e-4), sampled(0.060, 2e-4),
                                        sampled(0.015, 2e-4), sampled(0.037, 4e-4)};
    struct pp_column column = {.component = PP_DF};
    assert_int_equal(pp_plane_figures_sum_up(&column, points, NULL, 4, NULL), PP_OK);
    assert_true(column.has_plane);
    const struct pp_plane_reading *plane = &column.plane;
    assert_near(plane->average.value, 0.030, 1e-15);
    assert_near(plane->average.std_error, 5e-4 / 4.0, 1e-15);
    assert_near(plane->minimum.value, 0.008, 1e-15);
    assert_near(plane->median.value, 0.026, 1e-15);
    assert_near(plane->uniformity, 0.8 / 3.0, 1e-12);
    static const double over[] = {0.75, 0.5, 0.25};
    for (int i = 0; i < 3; i++)
        assert_near(plane->over[i], over[i], 1e-15);
}

static void a_point_without_a_value_leaves_the_plane_without_figures(void **state)
{
    (void)state;
    const struct pp_reading points[] = {pp_reading_of(0.01), pp_reading_none("why")};
    struct pp_column column = {.component = PP_DF, .has_plane = true};
    assert_int_equal(pp_plane_figures_sum_up(&column, points, NULL, 2, NULL), PP_OK);
    assert_false(column.has_plane);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figures_of_four_points_are_as_worked_by_hand),
        cmocka_unit_test(a_point_without_a_value_leaves_the_plane_without_figures),
    };
    add_tests(tests, NULL, NULL);
}
