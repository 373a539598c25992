/* test_plane_grid.c - the spacing of grids for criteria. */
#include "tests/lib/near.h"

#include "studies/criteria/grid/plane_grid.h"
#include "tests/lib/room_of.h"

/* 5^log10(10) is 5; 5^log10(100) is 25, and half of that exceeds the maximum. */
static void the_spacing_grows_slower_than_the_room(void **state)
{
    (void)state;
    assert_near(pp_plane_grid_largest_spacing(1.0, 0.7), 0.5, 1e-15);
    assert_near(pp_plane_grid_largest_spacing(10.0, 7.0), 2.5, 1e-14);
    assert_near(pp_plane_grid_largest_spacing(7.0, 10.0), 2.5, 1e-14);
    assert_near(pp_plane_grid_largest_spacing(100.0, 70.0), 10.0, 0.0);
}

/* log10 of 3.7 is 0.568202; times ln 5 it is 0.914486; e to this power is 2.495491. */
static void the_shorter_side_counts_in_long_rooms(void **state)
{
    (void)state;
    assert_near(pp_plane_grid_largest_spacing(3.7, 7.4), 0.5 * 2.495491, 1e-6);
    assert_near(pp_plane_grid_largest_spacing(7.4, 3.7), 0.5 * 2.495491, 1e-6);
    assert_true(pp_plane_grid_largest_spacing(3.7, 7.3) > 0.5 * 2.495491 + 0.5);
}

/* 14.1 x 14.1 m with 0.1 m has 19,881 cells, 14.2 x 14.2 m has 20,164. */
static void a_grid_of_too_many_cells_has_no_points_and_a_reason(void **state)
{
    (void)state;
    const struct pp_grid_choice choice = {.spacing_m = 0.1};
    for (int is_too_fine = 0; is_too_fine < 2; is_too_fine++) {
        struct pp_world *world = pp_test_world(
            is_too_fine ? "<room version='1'><plan width='14.2' depth='14.2' "
                          "height='3'/></room>"
                        : "<room version='1'><plan width='14.1' depth='14.1' "
                          "height='3'/></room>");
        struct pp_plane_grid grid;
        assert_int_equal(pp_plane_grid_make(&grid, world, NULL, &choice, 0, NULL),
                         PP_OK);
        assert_int_equal(grid.is_too_fine, is_too_fine);
        assert_int_equal(grid.count, is_too_fine ? 0 : 19881);
        pp_plane_grid_clear(&grid);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_spacing_grows_slower_than_the_room),
        cmocka_unit_test(the_shorter_side_counts_in_long_rooms),
        cmocka_unit_test(a_grid_of_too_many_cells_has_no_points_and_a_reason),
    };
    add_tests(tests, NULL, NULL);
}
