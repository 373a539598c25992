/* test_irc_minimum.c - the minimum internally reflected component, by formula and by
 * table. */
#include "methods/reflected/bre_terms.h"
#include "methods/reflected/irc_minimum.h"
#include "methods/method.h"

#include <stdio.h>

#include "model/results/report.h"
#include "methods/evaluate.h"
#include "tests/methods/box_method.h"
#include "tests/lib/room_of.h"

static const double foot = 0.3048;

/* The printed table, per cent: rows by glass area over floor area; floors of 10, 20, 40
 * %, each with walls of 20, 40, 60, 80 %. */
static const double printed[][13] = {
#include "tables/irc_minimum.inc"
};

static const double floors[3] = {0.1, 0.2, 0.4};
static const double walls[4] = {0.2, 0.4, 0.6, 0.8};

/* The room that the printed table fits best: 20 x 20 x 10 ft, sill at 3 ft, window up
 * to the ceiling, obstruction 20 degrees. The window is as wide as its area requires,
 * even wider than the wall, since the formula only uses areas. */
static void build_printed_room(struct box_room *box, double percent, double floor,
                               double wall)
{
    double side = 20 * foot, height = 10 * foot, sill = 3 * foot;
    box_room_build(box, side, side, height, floor, wall, 0.7);
    double window_m2 = percent / 100.0 * side * side;
    box_room_south(box, 0.0, sill, window_m2 / (height - sill), height - sill);
    box_room_skyline(box, 20.0 * PP_RAD, 6.5 * foot, INFINITY);
}

/* All 156 cells. The table has one decimal, of values calculated by hand. 0.25 is the
 * limit stated by our source, with a reflectance of 0.15 for openings. */
static void formula_over_its_ratio_is_near_every_printed_cell(void **state)
{
    (void)state;
    double squares = 0.0;
    int count = 0;
    for (size_t r = 0; r < sizeof printed / sizeof *printed; r++)
        for (int f = 0; f < 3; f++)
            for (int w = 0; w < 4; w++) {
                struct box_room box;
                build_printed_room(&box, printed[r][0], floors[f], walls[w]);
                double minimum = 100.0 * box_method_value(&pp_method_bre_min, &box, 0);
                double cell = printed[r][1 + 4 * f + w];
                assert_near(minimum, cell, 0.25);
                squares += (minimum - cell) * (minimum - cell);
                count++;
            }
    assert_int_equal(count, 156);
    assert_true(sqrt(squares / count) < 0.09);
}

static void ratios_are_the_published_ones(void **state)
{
    (void)state;
    static const double published[4] = {1.8, 1.4, 1.3, 1.2};
    for (int w = 0; w < 4; w++)
        assert_near(pp_irc_minimum_average_ratio(walls[w]), published[w], 1e-14);
    assert_near(pp_irc_minimum_average_ratio(0.3), 1.6, 1e-14);
    assert_near(pp_irc_minimum_average_ratio(0.65), 1.275, 1e-14);
    /* constant beyond the ends */
    assert_near(pp_irc_minimum_average_ratio(0.05), 1.8, 0.0);
    assert_near(pp_irc_minimum_average_ratio(0.95), 1.2, 0.0);
}

/* The worked room: 1.3289 per cent on average; for walls of 0.5 the ratio is midway
 * between 1.4 and 1.3. */
static void worked_room_has_its_average_over_1_35(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 0.2, 0.9, 3.6, 1.5);
    assert_near(100.0 * box_method_value(&pp_method_bre_min, &box, 0), 1.3289 / 1.35,
                4e-5);
}

static struct pp_irc_minimum_entry printed_entry(double percent, double floor,
                                                 double wall)
{
    return (struct pp_irc_minimum_entry){.glass_m2 = 0.4 * percent,
                                         .floor_m2 = 40.0,
                                         .floor = floor,
                                         .walls = wall,
                                         .ceiling = 0.7};
}

static void table_reads_as_printed_in_every_cell(void **state)
{
    (void)state;
    for (size_t r = 0; r < sizeof printed / sizeof *printed; r++)
        for (int f = 0; f < 3; f++)
            for (int w = 0; w < 4; w++) {
                struct pp_irc_minimum_entry entry =
                    printed_entry(printed[r][0], floors[f], walls[w]);
                assert_null(pp_irc_minimum_lacks(&entry));
                struct pp_irc_minimum read = pp_irc_minimum_read(&entry);
                assert_near(100.0 * read.printed, printed[r][1 + 4 * f + w], 1e-12);
                assert_near(read.floor_factor, 1.0, 1e-12);
                assert_near(read.ceiling_factor, 1.0, 1e-12);
            }
}

/* Calculated by hand: glass 11 % of the floor, floor 0.3, walls 0.5. At 10 % the mean
 * of 0.3 0.6 and 0.5 0.8 is 0.55, at 15 % the mean of 0.5 0.8 and 0.7 1.1 is 0.775; a
 * fifth of the way between them is 0.595. */
static void table_is_taken_in_proportion_between_its_cells(void **state)
{
    (void)state;
    struct pp_irc_minimum_entry entry = printed_entry(11.0, 0.3, 0.5);
    assert_near(100.0 * pp_irc_minimum_read(&entry).printed, 0.595, 1e-12);
    /* 1 % of glass: half of the value for 2 %, floor 0.4 and walls 0.8 */
    entry = printed_entry(1.0, 0.4, 0.8);
    assert_near(100.0 * pp_irc_minimum_read(&entry).printed, 0.1, 1e-12);
    entry = printed_entry(0.0, 0.4, 0.8);
    assert_near(pp_irc_minimum_read(&entry).printed, 0.0, 0.0);
}

static void factors_are_the_published_ones(void **state)
{
    (void)state;
    static const double small[4] = {0.6, 0.7, 0.8, 0.9},
                        large[4] = {1.4, 1.2, 1.0, 0.9};
    for (int w = 0; w < 4; w++) {
        struct pp_irc_minimum_entry entry = printed_entry(20.0, 0.2, walls[w]);
        entry.floor_m2 = 10.0;
        assert_near(pp_irc_minimum_read(&entry).floor_factor, small[w], 1e-12);
        entry.floor_m2 = 90.0;
        assert_near(pp_irc_minimum_read(&entry).floor_factor, large[w], 1e-12);
        /* halfway between the sides of 10 and 40 m2 */
        entry.floor_m2 = 22.5;
        assert_near(pp_irc_minimum_read(&entry).floor_factor, (1.0 + small[w]) / 2,
                    1e-12);
    }
    for (int c = 4; c <= 8; c++) {
        struct pp_irc_minimum_entry entry = printed_entry(20.0, 0.2, 0.4);
        entry.ceiling = c / 10.0;
        assert_near(pp_irc_minimum_read(&entry).ceiling_factor, 0.3 + c / 10.0, 1e-12);
    }
}

static void nothing_is_read_outside_the_printed_figures(void **state)
{
    (void)state;
    struct pp_irc_minimum_entry good = printed_entry(20.0, 0.2, 0.4), bad;
    assert_null(pp_irc_minimum_lacks(&good));
    bad = good, bad.floor_m2 = 9.9;
    assert_non_null(strstr(pp_irc_minimum_lacks(&bad), "10 to 90 m2"));
    bad = good, bad.floor_m2 = 90.1;
    assert_non_null(pp_irc_minimum_lacks(&bad));
    bad = good, bad.floor = 0.09;
    assert_non_null(strstr(pp_irc_minimum_lacks(&bad), "0.1 to 0.4"));
    bad = good, bad.walls = 0.81;
    assert_non_null(strstr(pp_irc_minimum_lacks(&bad), "0.2 to 0.8"));
    bad = good, bad.ceiling = 0.85;
    assert_non_null(strstr(pp_irc_minimum_lacks(&bad), "0.4 to 0.8"));
    bad = good, bad.glass_m2 = 20.1;
    assert_non_null(strstr(pp_irc_minimum_lacks(&bad), "half the floor area"));
}

/* In the printed room another obstruction angle scales the table by the same ratio as
 * the formula, and the frame counts as part of the glass area. */
static void obstruction_scales_the_table_as_the_formula(void **state)
{
    (void)state;
    struct box_room box;
    build_printed_room(&box, 20.0, 0.2, 0.4);
    double at_20 = box_method_value(&pp_method_bre_table, &box, 0);
    double side_m2 = 400 * foot * foot;
    double factor = 0.7 + 0.3 * (sqrt(side_m2) - sqrt(10)) / (sqrt(40) - sqrt(10));
    assert_near(100.0 * at_20, 0.6 * factor, 1e-12);
    double formula_at_20 = box_method_value(&pp_method_bre_min, &box, 0);
    for (double deg = 0.0; deg < 90.0; deg += 13.0) {
        box_room_skyline(&box, deg * PP_RAD, 6.5 * foot, INFINITY);
        assert_relative(box_method_value(&pp_method_bre_table, &box, 0) / at_20,
                        box_method_value(&pp_method_bre_min, &box, 0) / formula_at_20,
                        1e-13);
    }
    box_room_skyline(&box, 20.0 * PP_RAD, 6.5 * foot, INFINITY);
    box.openings[0].frame_factor = 0.75; /* 15 % of the floor: 0.5 */
    assert_near(100.0 * box_method_value(&pp_method_bre_table, &box, 0), 0.5 * factor,
                1e-12);
    box.openings[0].frame_factor = 0.0;
    assert_near(box_method_value(&pp_method_bre_table, &box, 0), 0.0, 0.0);
}

/* Two windows have the value of one window of their total area, although the table is
 * not linear. */
static void windows_share_one_reading_of_the_table(void **state)
{
    (void)state;
    struct box_room one, two;
    box_room_build(&one, 5.0, 6.0, 2.9, 0.3, 0.5, 0.75);
    box_room_south(&one, 0.5, 0.9, 3.3, 1.6);
    box_room_build(&two, 5.0, 6.0, 2.9, 0.3, 0.5, 0.75);
    box_room_south(&two, 0.5, 0.9, 1.2, 1.6);
    box_room_south(&two, 2.0, 0.9, 2.1, 1.6);
    assert_relative(box_method_value(&pp_method_bre_table, &two, 0)
                        + box_method_value(&pp_method_bre_table, &two, 1),
                    box_method_value(&pp_method_bre_table, &one, 0), 1e-13);
}

/* A minimum applies to every point and gives no average; the same holds for a pair that
 * contains it. */
static void minimum_is_for_points_and_no_average(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='5' height='2.7'/>"
                "<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"
                "<point x='2' y='1'/><point x='2' y='4.5'/></room>");
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count};
    assert_int_equal(
        pp_methods_evaluate(&report, "bre,exact+bre-min,exact+bre-table", NULL), PP_OK);
    const struct pp_column *bre = pp_report_find(&report, PP_IRC, "bre");
    static const char *const names[2] = {"bre-min", "bre-table"};
    for (int i = 0; i < 2; i++) {
        char pair[32];
        snprintf(pair, sizeof pair, "exact+%s", names[i]);
        const struct pp_column *least = pp_report_find(&report, PP_IRC, names[i]);
        const struct pp_column *sum = pp_report_find(&report, PP_DF, pair);
        const struct pp_column *sky = pp_report_find(&report, PP_SC, "exact");
        assert_true(isnan(least->average.value) && isnan(sum->average.value));
        assert_non_null(strstr(least->average.why, "not an average"));
        for (int j = 0; j < 2; j++) {
            assert_true(least->points[j].value > 0.0);
            assert_true(least->points[j].value < bre->points[j].value);
            assert_near(sum->points[j].value,
                        sky->points[j].value + least->points[j].value, 1e-17);
        }
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formula_over_its_ratio_is_near_every_printed_cell),
        cmocka_unit_test(ratios_are_the_published_ones),
        cmocka_unit_test(worked_room_has_its_average_over_1_35),
        cmocka_unit_test(table_reads_as_printed_in_every_cell),
        cmocka_unit_test(table_is_taken_in_proportion_between_its_cells),
        cmocka_unit_test(factors_are_the_published_ones),
        cmocka_unit_test(nothing_is_read_outside_the_printed_figures),
        cmocka_unit_test(obstruction_scales_the_table_as_the_formula),
        cmocka_unit_test(windows_share_one_reading_of_the_table),
        cmocka_unit_test(minimum_is_for_points_and_no_average),
    };
    add_tests(tests, NULL, NULL);
}
