/* test_grid_error.c - the error caused by the spacing of a grid, for functions whose
 * area shares are known. */
#include <stdlib.h>

#include "studies/criteria/grid/grid_error.h"
#include "studies/criteria/grid/plane_share.h"
#include "tests/lib/near.h"

enum { COLUMNS = 7, ROWS = 5, MOST = COLUMNS * ROWS };

/* A complete grid over a plane of 1 by 1, with the values of a function. */
static struct pp_plane_grid grid_of(struct pp_reading points[MOST],
                                    double (*field)(double x, double y))
{
    struct pp_plane_grid grid = {.count = MOST, .columns = COLUMNS, .rows = ROWS};
    grid.cells = calloc(MOST, sizeof *grid.cells);
    grid.receivers = calloc(MOST, sizeof *grid.receivers);
    assert_non_null(grid.cells);
    assert_non_null(grid.receivers);
    for (int i = 0; i < MOST; i++) {
        grid.cells[i][0] = i % COLUMNS;
        grid.cells[i][1] = i / COLUMNS;
        points[i] = pp_reading_of(
            field((i % COLUMNS + 0.5) / COLUMNS, (i / COLUMNS + 0.5) / ROWS));
    }
    return grid;
}

static double falls_along_y(double x, double y)
{
    (void)x;
    return 0.03 - 0.02 * y;
}

static double even(double x, double y)
{
    (void)x, (void)y;
    return 0.017;
}

static void an_even_plane_has_no_error(void **state)
{
    (void)state;
    struct pp_reading points[MOST];
    struct pp_grid_error error;
    struct pp_plane_grid grid = grid_of(points, even);
    assert_int_equal(pp_grid_error(&error, &grid, points, 0.5, 0.02, NULL), PP_OK);
    assert_near(error.level, 0.0, 1e-17);
    assert_near(error.over, 0.0, 1e-15);
    pp_plane_grid_clear(&grid);
}

/* 0.0225 is reached where y is at most 0.375. Two of five rows at 0.1, 0.3, ... reach
 * it: 0.4 of the plane instead of 0.375. Of 20 finer rows at 0.025, 0.075, ... seven
 * (0.35) or, because 0.375 is rounded, eight (0.4) reach it. The level of 95 % of the
 * points is that of the last row, 0.012; for the finer rows that of the nineteenth, at
 * y = 0.925. */
static void a_contour_along_the_rows_is_off_by_part_of_a_row(void **state)
{
    (void)state;
    struct pp_reading points[MOST];
    struct pp_grid_error error;
    struct pp_plane_grid grid = grid_of(points, falls_along_y);
    assert_int_equal(pp_grid_error(&error, &grid, points, 0.95, 0.0224, NULL), PP_OK);
    assert_near(error.level, 0.012 - (0.03 - 0.02 * 0.925), 1e-15);
    /* 0.0224 is at y = 0.38, between the finer rows at 0.375 and 0.425: 8 of 20. */
    assert_near(error.over, 0.0, 1e-15);
    assert_int_equal(pp_grid_error(&error, &grid, points, 0.95, 0.0234, NULL), PP_OK);
    /* At y = 0.33: two of five rows, seven of twenty. */
    assert_near(error.over, 0.4 - 0.35, 1e-15);
    pp_plane_grid_clear(&grid);
}

/* The slopes of a linear function are estimated exactly, and so is its median. */
static void the_median_of_a_linear_field_has_no_error(void **state)
{
    (void)state;
    struct pp_reading points[MOST];
    struct pp_grid_error error;
    struct pp_plane_grid grid = grid_of(points, falls_along_y);
    assert_int_equal(pp_grid_error(&error, &grid, points, 0.5, 0.02, NULL), PP_OK);
    assert_near(error.level, 0.0, 1e-15);
    pp_plane_grid_clear(&grid);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_even_plane_has_no_error),
        cmocka_unit_test(a_contour_along_the_rows_is_off_by_part_of_a_row),
        cmocka_unit_test(the_median_of_a_linear_field_has_no_error),
    };
    add_tests(tests, NULL, NULL);
}
