/* test_nomogram.c - nomograms of the internally reflected component: their scales,
 * their rounding, and the method. */
#include <stdio.h>

#include "methods/reflected/interior.h"
#include "methods/evaluate.h"
#include "methods/method.h"
#include "methods/nomogram/nomogram_reading.h"
#include "methods/nomogram/nomogram_scale.h"
#include "methods/nomogram/nomogram_sheet_fill.h"
#include "methods/reflected/obstruction.h"
#include "model/geometry/vec.h"

#include "tests/lib/near.h"

#include "tests/lib/box_room.h"
#include "tests/lib/room_of.h"

/* The formula with the rule R_cw = k R_fw, written independently; C and ground in per
 * cent, the result a fraction. */
static double formula(double ratio, double R, double C, double ground, double k)
{
    double R_fw = 2.0 * R / (1.0 + k), R_cw = k * R_fw;
    return 0.85 * ratio / (1.0 - R) * (C * R_fw + ground * R_cw) / 100.0;
}

static double across(const struct pp_nomogram *nomogram, int index, double from,
                     double to)
{
    const struct pp_nomogram_edge *edge = &nomogram->edges[index];
    double y = pp_nomogram_scale_crossing(
        nomogram, index, pp_nomogram_scale_position(nomogram, edge->from, from),
        pp_nomogram_scale_position(nomogram, edge->to, to),
        nomogram->stems[edge->read].x);
    return pp_nomogram_scale_value(nomogram, edge->read, y);
}

/* Calculated by hand: W/A 0.05, R 0.45778, k 1.5: R_fw 0.366224, R_cw 0.549336; 39 R_fw
 * + 5 R_cw = 17.029; 0.85 x 0.05/0.54222 x 17.029 = 1.3348 %. At 40 degrees with 20
 * instead of 39: 10.0712, 0.7894 %. */
static void straight_edge_does_the_sum_worked_by_hand(void **state)
{
    (void)state;
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_AVERAGE);
    double C = across(&nomogram, 0, 0.05, 0.45778);
    assert_near(100.0 * C, 1.3348, 5e-5);
    assert_near(100.0 * across(&nomogram, 1, C, 40.0 * PP_RAD), 0.7894, 5e-5);
}

static void straight_edge_gives_the_formula_with_its_rule(void **state)
{
    (void)state;
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_AVERAGE);
    for (double ratio = 0.005; ratio <= 0.2; ratio *= 1.37)
        for (double R = 0.1; R <= 0.9; R += 0.07)
            for (double alpha = 0.0; alpha <= 80.0; alpha += 7.3) {
                double C = across(&nomogram, 0, ratio, R);
                assert_relative(C, formula(ratio, R, 39.0, 5.0, PP_NOMOGRAM_K), 1e-12);
                double E = across(&nomogram, 1, C, alpha * PP_RAD);
                double factor = 100.0 * pp_obstruction_factor(alpha * PP_RAD);
                assert_relative(E, formula(ratio, R, factor, 5.0, PP_NOMOGRAM_K),
                                1e-12);
            }
}

/* Glass under the open sky: horizontal glass receives 100 %, vertical glass 39.6 % and
 * 5 % from the ground. */
static void straight_edge_gives_the_formula_for_top_light(void **state)
{
    (void)state;
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_ROOFLIGHT);
    double k = PP_NOMOGRAM_K;
    for (double R = 0.13; R <= 0.9; R += 0.11) {
        double C = across(&nomogram, 0, 0.031, R);
        assert_relative(C, formula(0.031, R, 100.0, 0.0, k), 1e-12);
        assert_relative(across(&nomogram, 1, C, 0.0), C, 1e-12);
        double upright = 100.0 * (3.0 / 14.0 + 4.0 / (7.0 * PP_PI));
        assert_relative(across(&nomogram, 1, C, PP_PI / 2.0),
                        formula(0.031, R, upright, 5.0, k), 1e-12);
        double at_60 =
            100.0
            * (3.0 / 14.0 * 1.5
               + 4.0 / (7.0 * PP_PI) * (sqrt(0.75) + PP_PI * 2.0 / 3.0 * 0.5));
        assert_relative(across(&nomogram, 1, C, PP_PI / 3.0),
                        formula(0.031, R, at_60, 2.5, k), 1e-12);
    }
}

/* Calculated by hand: T W 3 m2, A 100 m2 and R 0.5: 0.03/0.5 = 0.06; illuminance 20 %:
 * 1.2 %; with a factor of 0.5: 0.6 %. */
static void straight_edge_gives_the_component_at_a_point(void **state)
{
    (void)state;
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_POSITION);
    double C = across(&nomogram, 0, 0.03, 0.5);
    assert_relative(C, 0.06, 1e-12);
    double E = across(&nomogram, 1, C, 0.2);
    assert_relative(E, 0.012, 1e-12);
    assert_relative(across(&nomogram, 2, E, 0.5), 0.006, 1e-12);
}

/* All lines from a position to its factor meet at one point of the curve. Calculated by
 * hand for q = 2 at the position 0.5: 2 exp(-1)/(1 - exp(-2)) = 0.85092. This also
 * holds for rooms that are brighter at the back. */
static void lines_of_one_depth_meet_on_the_curve(void **state)
{
    (void)state;
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_POSITION);
    double x_H = nomogram.stems[PP_STEM_H].x, x_F = nomogram.stems[PP_STEM_F].x;
    for (double q = PP_NOMOGRAM_LEAST_Q; q <= PP_NOMOGRAM_MOST_Q; q += 0.47)
        for (double u = 0.0; u <= 2.0; u += 0.25) {
            double f = q * exp(-q * u) / (1.0 - exp(-q)), x, y;
            double y_H = pp_nomogram_scale_position(&nomogram, PP_STEM_H, u);
            pp_nomogram_scale_curve(&nomogram, q, &x, &y);
            double y_F = y_H + (y - y_H) * (x_F - x_H) / (x - x_H);
            assert_relative(pp_nomogram_scale_value(&nomogram, PP_STEM_F, y_F), f,
                            1e-9);
        }
    double x, y, y_H = pp_nomogram_scale_position(&nomogram, PP_STEM_H, 0.5);
    pp_nomogram_scale_curve(&nomogram, 2.0, &x, &y);
    assert_near(pp_nomogram_scale_value(&nomogram, PP_STEM_F,
                                        y_H + (y - y_H) * (x_F - x_H) / (x - x_H)),
                0.85092, 5e-6);
    pp_nomogram_scale_curve(&nomogram, 0.0, &x, &y);
    assert_near(x, x_F, 1e-12);
    assert_near(y, pp_nomogram_scale_position(&nomogram, PP_STEM_F, 1.0), 1e-12);
}

/* Read to a fifth of a division, the sum over the windows of a room is within 3 % of
 * irc-atlas at any point. */
static void point_of_a_room_is_read_as_the_formula_has_it(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='7' height='3'/>"
                "<window wall='south' left='1' sill='0.9' width='2' height='1.5'/>"
                "<window wall='west' left='2' sill='1' width='1' height='1.2' "
                "reveal='0.2'/><skyline wall='south' angle='27'/>"
                "<point x='2' y='0.5'/><point x='1' y='3'/><point x='3.5' y='6.5'/>"
                "</room>");
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count};
    assert_int_equal(pp_methods_evaluate(&report, "irc-atlas", NULL), PP_OK);
    const struct pp_column *column = pp_report_find(&report, PP_IRC, "irc-atlas");
    for (int i = 0; i < 3; i++) {
        struct pp_nomogram_sheet sheet;
        const struct pp_nomogram_spacing spacing = {200.0, 240.0, 0.9, 3.0};
        assert_int_equal(
            pp_nomogram_sheet_fill_room(&sheet, PP_NOMOGRAM_POSITION, world, &light,
                                        &world->receivers[i], spacing, NULL),
            PP_OK);
        assert_relative(sheet.further, column->points[i].value, 0.03);
        assert_relative(sheet.component, column->average.value, 0.03);
        pp_nomogram_sheet_clear(&sheet);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void what_leaves_the_scales_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *room, *why;
    } cases[] = {
        {"<plan width='3' depth='40' height='2.5'/><window wall='south' left='1' "
         "sill='1' width='1' height='1'/>",
         "outside the range of the curve"},
        {"<plan width='3' depth='4' height='2.5'/><finishes walls='0.01' floor='0.01' "
         "ceiling='0.01'/><window wall='south' left='1' sill='1' width='1' "
         "height='1'/>",
         "0.1 to 0.9"},
        {"<plan width='3' depth='4' height='2.5'/><sky type='uniform'/><window "
         "wall='south' left='1' sill='1' width='1' height='1'/>",
         "overcast"},
        {"<plan width='3' depth='4' height='2.5'/><rooflight x='1' y='1' width='1' "
         "depth='1'/>",
         "vertical"},
    };
    for (int i = 0; i < 4; i++) {
        char xml[500];
        struct pp_outside_light light;
        struct pp_nomogram_sheet sheet;
        struct pp_error err = {0};
        const struct pp_nomogram_spacing spacing = {200.0, 240.0, 0.9, 3.0};
        snprintf(xml, sizeof xml, "<room version='1'>%s<point x='1' y='2'/></room>",
                 cases[i].room);
        struct pp_world *world = pp_test_lit_world(&light, xml);
        assert_int_equal(pp_nomogram_sheet_fill_room(&sheet, PP_NOMOGRAM_POSITION,
                                                     world, &light, world->receivers,
                                                     spacing, &err),
                         PP_BAD_INPUT);
        if (!strstr(err.message, cases[i].why))
            fail_msg("%s", err.message);
        pp_nomogram_sheet_clear(&sheet);
        pp_world_destroy(world);
    }
}

/* For all values, the readings are between the values set and on the sheet. */
static void scales_keep_to_the_sheet(void **state)
{
    (void)state;
    for (int kind = 0; kind < PP_NOMOGRAMS; kind++) {
        struct pp_nomogram nomogram =
            pp_nomogram_scale_make((enum pp_nomogram_kind)kind);
        for (int i = 0; i < nomogram.stem_count; i++) {
            const struct pp_nomogram_stem *stem = &nomogram.stems[i];
            assert_int_equal(stem->letter, 'A' + i);
            assert_true(stem->x >= 0.0 && stem->x <= 1.0);
            double low = pp_nomogram_scale_position(&nomogram, i, stem->low);
            double high = pp_nomogram_scale_position(&nomogram, i, stem->high);
            assert_in_range((int)(1000.0 * low + 1e-6), 0, 1000);
            assert_in_range((int)(1000.0 * high + 1e-6), 0, 1000);
            for (int j = 0; j < i; j++)
                assert_true(fabs(nomogram.stems[j].x - stem->x) > 0.08);
        }
        for (int i = 0; i < nomogram.edge_count; i++) {
            const struct pp_nomogram_edge *edge = &nomogram.edges[i];
            assert_true(nomogram.stems[edge->from].x < nomogram.stems[edge->read].x);
            assert_true(nomogram.stems[edge->read].x < nomogram.stems[edge->to].x);
        }
    }
}

/* Divisions in steps of 1, 2 or 5, at least 0.9 mm wide, that include the numbered
 * marks. */
static void divisions_can_be_told_apart(void **state)
{
    (void)state;
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_AVERAGE);
    for (int i = 0; i < 3; i++) {
        const struct pp_nomogram_stem *stem = &nomogram.stems[i];
        double unit = pp_nomogram_scale_printed_unit(stem->quantity);
        double stretch[2];
        for (double p = unit * stem->low * 1.0001; p < unit * stem->high; p *= 1.013) {
            double step =
                pp_nomogram_scale_division(&nomogram, i, p, 200.0, 0.9, stretch);
            assert_true(stretch[0] <= p * (1.0 + 1e-8) && p < stretch[1]);
            double count = (stretch[1] - stretch[0]) / step;
            assert_near(count, rint(count), 1e-6);
            double low = stretch[0] + step * floor((p - stretch[0]) / step);
            if (low < unit * stem->low || low + step > unit * stem->high)
                continue;
            double apart = pp_nomogram_scale_position(&nomogram, i, (low + step) / unit)
                           - pp_nomogram_scale_position(&nomogram, i, low / unit);
            assert_true(200.0 * apart > 0.9 - 1e-9);
            double read = unit * pp_nomogram_scale_read(&nomogram, i, p / unit);
            assert_near(read, p, 0.1 * step + 1e-12);
            assert_near(5.0 * read / step, rint(5.0 * read / step), 1e-6);
        }
    }
}

/* Geometric mean, over the rooms for which k was chosen, of the formula with the rule
 * divided by the formula itself, without an obstruction. */
static double mean_ratio(double k)
{
    static const double sides[] = {3.0, 4.5, 6.0, 8.0}, heights[] = {2.5, 3.0, 3.5},
                        shares[] = {0.1, 0.15, 0.2, 0.3};
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < 4 * 4 * 3 * 4; i++) {
        double w = sides[i % 4], d = sides[i / 4 % 4], h = heights[i / 16 % 3];
        double high = h - 1.2, wide = shares[i / 48] * w * d / high;
        if (wide > 0.95 * w)
            continue;
        struct box_room box;
        box_room_build(&box, w, d, h, 0.2, 0.5, 0.7);
        box_room_south(&box, 0.02 * w, 0.9, wide, high);
        struct pp_part part = {0};
        assert_int_equal(pp_method_bre.evaluate(&box.world, &box.light, box.openings,
                                                NULL, NULL, &part, NULL),
                         PP_OK);
        struct pp_interior all = pp_interior_all(&box.world);
        sum += log(formula(wide * high / all.area_m2, all.reflectance, 39.0, 5.0, k)
                   / part.value);
        count++;
    }
    assert_int_equal(count, 164);
    return exp(sum / count);
}

static void k_is_what_agrees_best_in_typical_rooms(void **state)
{
    (void)state;
    double best = fabs(log(mean_ratio(PP_NOMOGRAM_K)));
    assert_true(best < 0.011); /* 1.05 % */
    assert_true(fabs(log(mean_ratio(PP_NOMOGRAM_K - 0.1))) > best);
    assert_true(fabs(log(mean_ratio(PP_NOMOGRAM_K + 0.1))) > best);
}

static double nomogram_of(const struct pp_world *world,
                          const struct pp_outside_light *light, int index,
                          struct pp_steps *steps)
{
    const struct pp_method *method = &pp_method_nomogram;
    struct pp_part part = {.sheet = {.steps = steps}};
    void *tools;
    assert_null(method->refuses_room(world, light, NULL));
    assert_null(method->refuses(world, light, &world->openings[index], NULL));
    assert_int_equal(method->prepare(&tools, world, light, NULL), PP_OK);
    assert_int_equal(method->evaluate(world, light, &world->openings[index], NULL,
                                      tools, &part, NULL),
                     PP_OK);
    method->destroy_tools(tools);
    return part.value;
}

/* Room 6 x 4 x 3 m, window 3.6 x 1.5 m: A = 0.05; R = 0.45778, set to 0.458 (divisions
 * of 0.01, a fifth is 0.002). The sum is 1.336 %, read as 1.34 on divisions of 0.05 (a
 * fifth is 0.01). */
static void worked_room_is_read_to_a_fifth_of_a_division(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 0.2, 0.9, 3.6, 1.5);
    assert_near(100.0 * nomogram_of(&box.world, &box.light, 0, NULL), 1.34, 1e-12);
    box_room_skyline(&box, 40.0 * PP_RAD, 1.65, INFINITY);
    /* 1.34 x 27.5/46.5 = 0.7925, on divisions of 0.1 */
    assert_near(100.0 * nomogram_of(&box.world, &box.light, 0, NULL), 0.80, 1e-12);
}

/* Unobstructed panes are set on scale D at the slopes for which it has values. Light on
 * the pane is calculated from the closed form for the overcast sky and the share of the
 * ground. A and B together, and C and E, are each read to half of a fifth of a
 * division, at most 0.55 %. */
static void top_light_is_set_at_its_slope(void **state)
{
    (void)state;
    static const double slopes_deg[] = {30.0, 60.0, 90.0};
    struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_ROOFLIGHT);
    for (int i = 0; i < 3; i++) {
        double beta = slopes_deg[i] * PP_RAD;
        struct box_room box;
        box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
        box_room_south(&box, 0.2, 0.9, 2.1, 1.3)->slope_rad = beta;
        struct pp_nomogram_reading reading;
        assert_int_equal(pp_nomogram_reading_of_opening(&reading, &nomogram, &box.world,
                                                        &box.light, box.openings, NULL),
                         PP_OK);
        assert_near(reading.value[PP_STEM_D], beta, 1e-12);
        double sky = 3.0 / 14.0 * (1.0 + cos(beta))
                     + 4.0 / (7.0 * PP_PI) * (sin(beta) + (PP_PI - beta) * cos(beta));
        double ground = 0.1 * (1.0 - cos(beta)) / 2.0;
        assert_relative(reading.component,
                        formula(reading.ratio, pp_interior_all(&box.world).reflectance,
                                100.0 * sky, 100.0 * ground, PP_NOMOGRAM_K),
                        0.017);
    }
}

/* A pane of 2 dm2 is far below the end of scale A; a glasshouse is far above it. */
static void ratios_off_the_scale_are_shifted_by_tens(void **state)
{
    (void)state;
    static const struct {
        double left, sill, width, height;
        int tens;
    } cases[] = {{1.0, 1.5, 0.1, 0.2, 2}, {1.0, 1.5, 0.5, 0.6, 1}, {0, 0, 4, 9, -1}};
    for (int i = 0; i < 3; i++) {
        struct box_room box;
        double height = i == 2 ? 9.0 : 3.0, depth = i == 2 ? 0.5 : 6.0;
        box_room_build(&box, 4.0, depth, height, 0.3, 0.5, 0.7);
        box_room_south(&box, cases[i].left, cases[i].sill, cases[i].width,
                       cases[i].height);
        struct pp_nomogram nomogram = pp_nomogram_scale_make(PP_NOMOGRAM_AVERAGE);
        struct pp_nomogram_reading reading;
        assert_int_equal(pp_nomogram_reading_of_opening(&reading, &nomogram, &box.world,
                                                        &box.light, box.openings, NULL),
                         PP_OK);
        assert_int_equal(reading.tens, cases[i].tens);
        struct pp_interior all = pp_interior_all(&box.world);
        /* A fifth of a division is at most 1.1 % in this part of scale C, and the error
         * is half of this; the same applies to A and B together. */
        assert_relative(
            reading.component,
            formula(reading.ratio, all.reflectance, 39.0, 5.0, PP_NOMOGRAM_K), 0.012);
    }
}

static void others_are_refused_with_a_reason(void **state)
{
    (void)state;
    const struct pp_method *method = &pp_method_nomogram;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><sky type='uniform'/><plan width='4' depth='5' height='3'/>"
        "<window wall='south' left='1' sill='1' width='2' height='1'/></room>");
    assert_non_null(strstr(method->refuses_room(world, &light, NULL), "overcast"));
    pp_world_destroy(world);

    world = pp_test_lit_world(&light,
                              "<room version='1'><plan width='4' depth='5' height='3'/>"
                              "<rooflight x='1' y='1' width='2' depth='1'/></room>");
    assert_null(method->refuses_room(world, &light, NULL));
    assert_non_null(
        strstr(method->refuses(world, &light, world->openings, NULL), "vertical"));
    pp_world_destroy(world);

    static const char *const greys[] = {"0.05", "0.97"};
    for (int i = 0; i < 2; i++) {
        char xml[400];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='4' depth='5' height='3'/>"
                 "<finishes floor='%s' walls='%s' ceiling='%s'/><window wall='south' "
                 "left='1' sill='1' width='1' height='1'/></room>",
                 greys[i], greys[i], greys[i]);
        world = pp_test_lit_world(&light, xml);
        assert_non_null(
            strstr(method->refuses_room(world, &light, NULL), "0.1 to 0.9"));
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(straight_edge_does_the_sum_worked_by_hand),
        cmocka_unit_test(straight_edge_gives_the_formula_with_its_rule),
        cmocka_unit_test(straight_edge_gives_the_formula_for_top_light),
        cmocka_unit_test(straight_edge_gives_the_component_at_a_point),
        cmocka_unit_test(lines_of_one_depth_meet_on_the_curve),
        cmocka_unit_test(point_of_a_room_is_read_as_the_formula_has_it),
        cmocka_unit_test(what_leaves_the_scales_is_refused),
        cmocka_unit_test(scales_keep_to_the_sheet),
        cmocka_unit_test(divisions_can_be_told_apart),
        cmocka_unit_test(k_is_what_agrees_best_in_typical_rooms),
        cmocka_unit_test(worked_room_is_read_to_a_fifth_of_a_division),
        cmocka_unit_test(top_light_is_set_at_its_slope),
        cmocka_unit_test(ratios_off_the_scale_are_shifted_by_tens),
        cmocka_unit_test(others_are_refused_with_a_reason),
    };
    add_tests(tests, NULL, NULL);
}
