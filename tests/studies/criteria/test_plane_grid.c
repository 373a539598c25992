/* The spacing of grids by which criteria judge. */
#include "tests/lib/near.h"

#include "studies/criteria/grid/plane_grid.h"

/* 5^log10(10) is 5, 5^log10(100) is 25 and half of that above the most. */
static void the_spacing_grows_slower_than_the_room(void **state)
{
    (void)state;
    assert_near(pp_plane_grid_largest_spacing(1.0, 0.7), 0.5, 1e-15);
    assert_near(pp_plane_grid_largest_spacing(10.0, 7.0), 2.5, 1e-14);
    assert_near(pp_plane_grid_largest_spacing(7.0, 10.0), 2.5, 1e-14);
    assert_near(pp_plane_grid_largest_spacing(100.0, 70.0), 10.0, 0.0);
}

/* log10 of 3.7 is 0.568202, times ln 5 0.914486, e to that 2.495491. */
static void the_shorter_side_counts_in_long_rooms(void **state)
{
    (void)state;
    assert_near(pp_plane_grid_largest_spacing(3.7, 7.4), 0.5 * 2.495491, 1e-6);
    assert_near(pp_plane_grid_largest_spacing(7.4, 3.7), 0.5 * 2.495491, 1e-6);
    assert_true(pp_plane_grid_largest_spacing(3.7, 7.3) > 0.5 * 2.495491 + 0.5);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_spacing_grows_slower_than_the_room),
        cmocka_unit_test(the_shorter_side_counts_in_long_rooms),
    };
    add_tests(tests, NULL, NULL);
}
