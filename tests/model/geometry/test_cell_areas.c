/* test_cell_areas.c - the areas that the cells of a grid represent. */
#include "tests/lib/near.h"

#include "model/geometry/cell_areas.h"

/* A plane of 4 x 3 m with a margin of 0.5 m, in six cells of 1 x 1 m. */
static const struct pp_cell_grid grid = {
    .low = {0.5, 0.5}, .step = {1.0, 1.0}, .columns = 3, .rows = 2, .margin = 0.5};

static void find_areas(double areas[6], const bool is_point[6], double (*xy)[2],
                       int count)
{
    struct pp_ring ring = {.count = count, .xy = xy};
    struct pp_region region = {.count = 1, .rings = &ring};
    pp_cell_areas_find(areas, is_point, &region, &grid);
}

/* The fifth corner, in the middle of a side, makes the function divide the cells. */
static void a_rectangle_has_whole_cells_with_or_without_a_fifth_corner(void **state)
{
    (void)state;
    double four[][2] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    double five[][2] = {{0, 0}, {2, 0}, {4, 0}, {4, 3}, {0, 3}};
    const bool is_point[6] = {true, true, true, true, false, true};
    double areas[6], divided[6];
    find_areas(areas, is_point, four, 4);
    find_areas(divided, is_point, five, 5);
    for (int i = 0; i < 6; i++) {
        assert_near(areas[i], is_point[i] ? 1.0 : 0.0, 0.0);
        assert_near(divided[i], areas[i], 0.0);
    }
}

/* The corner x > 2.5, y > 1.5 is cut out. Less the margin the plane reaches x = 3.5
 * below y = 1, and x = 2 above; round the inner corner, a quarter of a circle is missing
 * from a square of 0.5 m. */
static void in_an_l_shape_the_areas_add_up_to_the_plane(void **state)
{
    (void)state;
    double xy[][2] = {{0, 0}, {4, 0}, {4, 1.5}, {2.5, 1.5}, {2.5, 3}, {0, 3}};
    const bool is_point[6] = {true, true, true, true, true, false};
    double areas[6], sum = 0.0;
    find_areas(areas, is_point, xy, 6);
    for (int i = 0; i < 6; i++)
        sum += areas[i];
    assert_near(areas[0], 1.0, 0.0);
    assert_near(areas[2], 0.5, 1.0 / 32.0);
    assert_near(areas[4], 0.5, 1.0 / 32.0);
    assert_near(sum, 3.0 * 0.5 + 1.5 * 1.5 + 0.25 * (1.0 - 0.25 * PP_PI), 0.01);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rectangle_has_whole_cells_with_or_without_a_fifth_corner),
        cmocka_unit_test(in_an_l_shape_the_areas_add_up_to_the_plane),
    };
    add_tests(tests, NULL, NULL);
}
