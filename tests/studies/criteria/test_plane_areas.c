/* test_plane_areas.c - areas of the plane that points of a grid represent, and shares of
 * an L-shaped plan. */
#include "tests/lib/made_year.h"
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include <stdlib.h>

#include "model/results/sheets/point_areas.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/criteria/grid/plane_share.h"
#include "studies/criteria/grid/share_finding.h"
#include "studies/year/annual_plane.h"

/* A rectangle of 6.1 x 2.36 m in front and an arm of 1.9 x 3.54 m behind it. The cells
 * are 0.5545 m wide, so that 3.43 of them fit into the arm, and 0.59 m deep. */
static const char ell[] =
    "<room version='1'><plan height='2.9'><vertex x='0' y='0'/><vertex x='6.1' y='0'/>"
    "<vertex x='6.1' y='2.36'/><vertex x='1.9' y='2.36'/><vertex x='1.9' y='5.9'/>"
    "<vertex x='0' y='5.9'/></plan><window wall='1' left='1' sill='0.9' width='2' "
    "height='1.5'/><grid spacing='0.6' margin='0'/></room>";
static const double front_m2 = 6.1 * 2.36, arm_m2 = 1.9 * 3.54;

static double area_where(const struct pp_receiver *points, int count, bool arm)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += (points[i].position.y > 2.36) == arm ? points[i].area_m2 : 0.0;
    return sum;
}

/* Counted by points the arm would have 18 of 62, or 29.0 %, of a plan of which it is
 * 31.8 %. An edge is accurate to 1/32 of a cell. */
static void points_of_an_l_shaped_plan_represent_its_two_rectangles(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ell);
    const struct pp_grid_choice choice = {.spacing_m = 0.6};
    struct pp_plane_grid grid;
    assert_int_equal(pp_plane_grid_make(&grid, world, NULL, &choice, 0, NULL), PP_OK);
    const struct {
        const struct pp_receiver *points;
        int count;
    } grids[] = {{world->receivers, world->receiver_count},
                 {grid.receivers, grid.count}};
    for (int k = 0; k < 2; k++) {
        double slack = 0.5545 / 32.0 * 3.54;
        assert_near(area_where(grids[k].points, grids[k].count, true), arm_m2, slack);
        assert_near(area_where(grids[k].points, grids[k].count, false), front_m2,
                    slack);
        assert_true(pp_point_areas_differ(grids[k].points, grids[k].count));
    }
    pp_plane_grid_clear(&grid);
    pp_world_destroy(world);
}

/* The strip along the walls is left out. */
static void cells_of_a_rectangle_have_equal_areas(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world("<room version='1'><plan width='4.1' depth='3.7' height='2.9'/>"
                      "<grid spacing='0.5' margin='0.3'/></room>");
    int count = world->receiver_count;
    assert_int_equal(count, 7 * 7);
    assert_false(pp_point_areas_differ(world->receivers, count));
    assert_near(pp_point_areas_sum(world->receivers, count), 3.5 * 3.1, 1e-12);
    pp_world_destroy(world);
}

/* 8 x 7 cells and 5 x 4 cells over 4.1 x 3.7 m. */
static void two_grids_share_the_area_of_the_plane(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world("<room version='1'><plan width='4.1' depth='3.7' height='2.9'/>"
                      "<grid spacing='0.55' margin='0'/><grid spacing='1' margin='0'/>"
                      "</room>");
    int count = world->receiver_count;
    assert_int_equal(count, 8 * 7 + 5 * 4);
    assert_near(pp_point_areas_sum(world->receivers, count), 4.1 * 3.7, 1e-12);
    assert_near(pp_point_areas_sum(world->receivers, 8 * 7), 4.1 * 3.7 / 2.0, 1e-12);
    pp_world_destroy(world);
}

/* sDA of a plan of two rectangles is not the share of the points: here the front reaches
 * 300 lx at every point and the arm at none. */
static void sda_of_an_l_shaped_plan_is_that_of_its_areas(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ell);
    int count = world->receiver_count;
    struct pp_annual_figures *points = calloc((size_t)count, sizeof *points);
    double *without = calloc((size_t)count * 2 * PP_ANNUAL_FIGURES, sizeof *without);
    struct pp_annual_sheet sheet = {.world = world,
                                    .receivers = world->receivers,
                                    .receiver_count = count,
                                    .is_grid = true,
                                    .has_blinds = true,
                                    .points = points};
    double front = area_where(world->receivers, count, false),
           arm = area_where(world->receivers, count, true);
    int lit = 0;
    for (int x = 0; x < count; x++) {
        bool is_lit = world->receivers[x].position.y < 2.36;
        points[x].blinds_autonomy.value = is_lit ? 0.8 : 0.2;
        points[x].sun_h.value = is_lit ? 100.0 : 700.0;
        lit += is_lit;
    }
    pp_annual_plane_fill(&sheet, without, 2);
    assert_near(sheet.plane.sda.value, front / (front + arm), 1e-12);
    assert_near(sheet.plane.sda.value, front_m2 / (front_m2 + arm_m2), 0.004);
    assert_true(fabs(sheet.plane.sda.value - (double)lit / count) > 0.005);
    /* The mean of the hours of sun is one by area; times the area it is their sum. */
    assert_near(sheet.mean.sun_h.value * (front + arm), 100.0 * front + 700.0 * arm,
                1e-9);
    free(without);
    free(points);
    pp_world_destroy(world);
}

/* Daylight factors of 3 % in front and 1 % in the arm. The front is 68.2 % of the
 * plane, but 71.0 % of the points: the level over 70 % of the plane is that of the arm. */
static void a_level_of_an_l_shaped_plan_is_that_over_its_areas(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ell);
    const struct pp_grid_choice choice = {.spacing_m = 0.6};
    struct pp_plane_grid grid;
    assert_int_equal(pp_plane_grid_make(&grid, world, NULL, &choice, 0, NULL), PP_OK);
    struct pp_column column = {
        .points = calloc((size_t)grid.count, sizeof(struct pp_reading))};
    int lit = 0;
    for (int i = 0; i < grid.count; i++) {
        bool in_front = grid.receivers[i].position.y < 2.36;
        column.points[i] = pp_reading_of(in_front ? 0.03 : 0.01);
        lit += in_front;
    }
    double front = front_m2 / (front_m2 + arm_m2);
    assert_true(front < 0.7 && (double)lit / grid.count > 0.7);
    struct pp_finding finding;
    struct pp_share_target target = {PP_FIGURE_FACTOR, 0.02, 0.7};
    assert_int_equal(pp_share_finding(&finding, &target, &column, grid.receivers,
                                      grid.count, &grid, "level", NULL),
                     PP_OK);
    assert_near(finding.reached_over, front, 0.004);
    assert_near(finding.figure, 0.01, 0.0);
    target.part = 0.66;
    assert_int_equal(pp_share_finding(&finding, &target, &column, grid.receivers,
                                      grid.count, &grid, "level", NULL),
                     PP_OK);
    assert_near(finding.figure, 0.03, 0.0);
    struct pp_reading mean =
        pp_plane_share_mean(column.points, grid.receivers, grid.count, 0.0);
    assert_near(mean.value, 0.01 + 0.02 * finding.reached_over, 1e-15);
    free(column.points);
    pp_plane_grid_clear(&grid);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_of_an_l_shaped_plan_represent_its_two_rectangles),
        cmocka_unit_test(cells_of_a_rectangle_have_equal_areas),
        cmocka_unit_test(two_grids_share_the_area_of_the_plane),
        cmocka_unit_test(a_level_of_an_l_shaped_plan_is_that_over_its_areas),
        cmocka_unit_test(sda_of_an_l_shaped_plan_is_that_of_its_areas),
    };
    add_tests(tests, NULL, NULL);
}
