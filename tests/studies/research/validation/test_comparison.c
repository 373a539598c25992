/* test_comparison.c - methods compared with the simulation: known differences, summed
 * over rooms. */
#include "studies/research/validation/comparison.h"

#include <stdlib.h>

#include "tests/lib/near.h"

/* A dark room, 1 % simulated at each of its 4 points, where the method is 0.2 % too
 * high, and a bright room, 5 % at 12 points, where it is 0.5 % too low: +20 % and -10
 * %. Over points this is (4 x 20 - 12 x 10)/16 = -2.5 %, with the spread sqrt((4 x 20^2
 * + 12 x 10^2)/16); the largest error is the bright room's 30 %. */
static void rooms_count_by_their_points_dark_ones_as_bright_ones(void **state)
{
    (void)state;
    struct pp_comparison dark = {.component = PP_DF,
                                 .name = "any",
                                 .points = 4,
                                 .traced = 0.01,
                                 .bias = 0.002,
                                 .spread = 0.002,
                                 .worst = 0.0025,
                                 .average = 0.012,
                                 .traced_average = 0.01};
    struct pp_comparison bright = {.component = PP_DF,
                                   .name = "any",
                                   .points = 12,
                                   .traced = 0.05,
                                   .bias = -0.005,
                                   .spread = 0.005,
                                   .worst = -0.015,
                                   .average = 0.046,
                                   .traced_average = 0.05};
    struct pp_comparison *const rooms[] = {&dark, &bright};
    static const int counts[] = {1, 1};
    struct pp_overall *list;
    int count;
    assert_int_equal(pp_comparison_overall(&list, &count, rooms, counts, 2, NULL),
                     PP_OK);
    assert_int_equal(count, 1);
    assert_int_equal(list->rooms, 2);
    assert_int_equal(list->points, 16);
    assert_near(list->bias, -0.025, 1e-15);
    assert_near(list->spread, sqrt((4.0 * 0.04 + 12.0 * 0.01) / 16.0), 1e-15);
    assert_near(list->worst, -0.3, 1e-15);
    assert_int_equal(list->worst_room, 1);
    /* +20 % and -8 %, with equal weights for both rooms. */
    assert_int_equal(list->averages, 2);
    assert_near(list->average_bias, 0.06, 1e-15);
    assert_near(list->average_spread, sqrt((0.04 + 0.0064) / 2.0), 1e-15);
    free(list);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rooms_count_by_their_points_dark_ones_as_bright_ones),
    };
    add_tests(tests, NULL, NULL);
}
