/* test_daylight_curves.c - positions of no-sky lines by geometry, and of contours by
 * `exact`. */
#include <stdio.h>
#include <stdlib.h>

#include "methods/daylight_curves.h"
#include "methods/method.h"
#include "model/geometry/vec.h"
#include "tests/lib/room_of.h"

#define SIMPLE_ROOM                                                                    \
    "<plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>"                               \
    "<window wall=\"south\" left=\"0.7\" sill=\"0.95\" width=\"2.6\" height=\"1.3\" "  \
    "glazing=\"none\"/>"

static struct pp_world *world_of(struct pp_outside_light *light, const char *name,
                                 const char *body)
{
    char text[4096];
    snprintf(text, sizeof text, "<room version=\"1\" name=\"%s\">%s</room>", name,
             body);
    return pp_test_lit_world(light, text);
}

static struct pp_daylight_plan plan_of(const struct pp_world *world,
                                       const struct pp_outside_light *light)
{
    struct pp_daylight_plan plan;
    struct pp_error err;
    if (pp_daylight_curves(&plan, world, light, 0.004, "bre", 0, 0, &err) != PP_OK)
        fail_msg("%s", err.message);
    return plan;
}

/* Every point of the only no-sky line has this y; sky is visible south of it, on its
 * left. */
static void assert_no_sky_at(const struct pp_daylight_plan *plan, double y)
{
    assert_int_equal(plan->no_sky.count, 1);
    const struct pp_curve *line = &plan->no_sky.list[0];
    assert_false(line->closed);
    for (int i = 0; i < line->count; i++)
        assert_near(line->xy[i][1], y, 2e-3);
    assert_true(line->xy[0][0] > line->xy[line->count - 1][0]);
    assert_near(fabs(line->xy[0][0] - line->xy[line->count - 1][0]), 4.1, 1e-6);
    assert_near(plan->sky_share, y / 6.3, 1e-3);
}

/* From the working plane at 0.85 m the head at 2.25 m appears above a skyline of 30
 * degrees at infinite distance up to 1.4 / tan 30 from the window. */
static void no_sky_line_lies_where_the_head_meets_a_far_skyline(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "Far", SIMPLE_ROOM "<skyline wall=\"south\" angle=\"30\"/>");
    struct pp_daylight_plan plan = plan_of(world, &light);
    assert_no_sky_at(&plan, 1.4 / tan(30 * PP_RAD));
    assert_int_equal(plan.dark.count, 1);
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

/* The top of the skyline is 1.6 + 8 tan 30 high at 8 m. The line from it past the head
 * of the window meets the working plane where both slopes are equal. */
static void no_sky_line_lies_where_the_head_meets_a_near_skyline(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "Near",
                 SIMPLE_ROOM "<skyline wall=\"south\" angle=\"30\" distance=\"8\"/>");
    struct pp_daylight_plan plan = plan_of(world, &light);
    double rise = 1.6 + 8.0 * tan(30 * PP_RAD) - 0.85;
    assert_no_sky_at(&plan, 1.4 * 8.0 / (rise - 1.4));
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

static void a_room_before_open_sky_has_no_no_sky_line(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Open", SIMPLE_ROOM);
    struct pp_daylight_plan plan = plan_of(world, &light);
    assert_int_equal(plan.no_sky.count, 0);
    assert_int_equal(plan.dark.count, 0);
    assert_near(plan.sky_share, 1.0, 0.0);
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

static void a_room_without_a_window_is_all_dark(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(
        &light, "Cellar", "<plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>");
    struct pp_daylight_plan plan;
    assert_int_equal(pp_daylight_curves(&plan, world, &light, 0.0, 0, 0, 0, 0), PP_OK);
    assert_string_equal(plan.name, "exact");
    assert_int_equal(plan.contours.count, 0);
    assert_int_equal(plan.dark.count, 1);
    assert_near(plan.sky_share, 0.0, 1e-12);
    assert_near(plan.highest, 0.0, 0.0);
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

/* In the stem of an L-shaped room, the part of the window from x = 3.5 on is visible
 * past the corner (2.5, 3) only from points west of the line through both. */
static void the_corner_of_an_l_shape_throws_a_straight_shadow(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(
        &light, "L",
        "<plan height=\"2.6\"><vertex x=\"0\" y=\"0\"/><vertex x=\"6\" y=\"0\"/>"
        "<vertex x=\"6\" y=\"3\"/><vertex x=\"2.5\" y=\"3\"/>"
        "<vertex x=\"2.5\" y=\"7\"/><vertex x=\"0\" y=\"7\"/></plan>"
        "<window wall=\"1\" left=\"3.5\" sill=\"1\" width=\"2\" height=\"1.2\"/>");
    struct pp_daylight_plan plan = plan_of(world, &light);
    assert_int_equal(plan.no_sky.count, 1);
    const struct pp_curve *line = &plan.no_sky.list[0];
    for (int i = 0; i < line->count; i++)
        assert_near(line->xy[i][0], 3.5 - line->xy[i][1] / 3.0, 4e-3);
    assert_near(pp_curve_length(line), hypot(4.0, 4.0 / 3.0), 1e-2);
    assert_near((1.0 - plan.sky_share) * pp_region_area(&world->plane),
                0.5 * 4.0 * 4.0 / 3.0, 2e-2);
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

static void points_of_a_contour_have_its_daylight_factor(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "Blocks",
                 SIMPLE_ROOM "<block x=\"-4\" y=\"-12\" width=\"7\" depth=\"5\" "
                             "height=\"6\" rotate=\"10\" reflectance=\"0.3\"/>");
    struct pp_daylight_plan plan = plan_of(world, &light);
    assert_true(plan.contours.count >= 4);
    assert_string_equal(plan.name, "exact+bre");
    double before = 0.0;
    int seen = 0;
    for (int i = 0; i < plan.contours.count; i++) {
        const struct pp_curve *curve = &plan.contours.list[i];
        assert_true(curve->level >= before);
        before = curve->level;
        for (int k = 0; k < curve->count; k += 7) {
            struct pp_receiver receiver = {
                .position = {curve->xy[k][0], curve->xy[k][1], 0.85},
                .normal = {0, 0, 1}};
            /* Near the window and the walls the factor changes too rapidly for a
             * comparison. */
            if (curve->xy[k][1] < 0.4 || curve->xy[k][0] < 0.01
                || curve->xy[k][0] > 4.09 || curve->xy[k][1] > 6.29)
                continue;
            struct pp_part part = {0};
            assert_int_equal(pp_method_exact.evaluate(world, &light, world->openings,
                                                      &receiver, NULL, &part, 0),
                             PP_OK);
            double factor =
                pp_allowance_factor(pp_method_exact.allowances, world->openings);
            /* About a millimetre, where the relative change is up to 0.2 per
             * centimetre. */
            assert_relative(0.004 + (part.sky + part.external) * factor, curve->level,
                            0.01);
            seen++;
        }
    }
    assert_true(seen > 20);
    assert_true(plan.highest > plan.lowest);
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

/* A function that falls linearly from the window to the back: the share of the plane
 * below a level equals the share of the distance. */
static enum pp_status falling(void *context, double x, double y, double *value,
                              struct pp_error *err)
{
    const double *ends = context;
    (void)x, (void)err;
    *value = ends[1] + (ends[0] - ends[1]) * y / 6.3;
    return PP_OK;
}

/* If round levels (1.1, 1.2, ... 2.2, 2.5 ...) are at most a fifth of the range apart,
 * at most a fifth of the plane has no contour. The share is accurate to 0.01, by
 * triangles. */
static void no_more_than_a_fifth_of_the_plane_has_no_line(void **state)
{
    (void)state;
    static double ends[][2] = {
        {0.0101, 0.0199}, {0.0102, 0.049}, {0.011, 0.031}, {0.0004, 0.021}};
    struct pp_world *world =
        pp_test_world("<room version=\"1\" name=\"Even\">" SIMPLE_ROOM "</room>");
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        struct pp_daylight_plan plan;
        assert_int_equal(
            pp_daylight_curves_of(&plan, world, "even", falling, NULL, ends[i], NULL),
            PP_OK);
        double before = ends[i][0], range = ends[i][1] - ends[i][0];
        for (int k = 0; k <= plan.contours.count; k++) {
            double level =
                k < plan.contours.count ? plan.contours.list[k].level : ends[i][1];
            assert_true(level - before < 0.21 * range);
            before = level;
        }
        pp_daylight_plan_clear(&plan);
    }
    pp_world_destroy(world);
}

/* Between 5.1 and 9.9 per cent there is no usual level, so contours are drawn in whole
 * per cent. */
static void levels_between_usual_ones_are_multiples_of_a_round_step(void **state)
{
    (void)state;
    double ends[] = {0.051, 0.099};
    struct pp_world *world =
        pp_test_world("<room version=\"1\" name=\"Even\">" SIMPLE_ROOM "</room>");
    struct pp_daylight_plan plan;
    assert_int_equal(
        pp_daylight_curves_of(&plan, world, "even", falling, NULL, ends, NULL), PP_OK);
    assert_int_equal(plan.contours.count, 4);
    for (int i = 0; i < 4; i++)
        assert_near(plan.contours.list[i].level, 0.06 + 0.01 * i, 1e-12);
    pp_daylight_plan_clear(&plan);
    pp_world_destroy(world);
}

static void requested_levels_are_the_levels_drawn(void **state)
{
    (void)state;
    static const double levels[] = {0.0077, 0.0233};
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Own", SIMPLE_ROOM);
    struct pp_daylight_plan plan;
    struct pp_error err;
    assert_int_equal(pp_daylight_curves(&plan, world, &light, 0.0, 0, levels, 2, 0),
                     PP_OK);
    for (int i = 0; i < plan.contours.count; i++)
        assert_true(plan.contours.list[i].level == levels[0]
                    || plan.contours.list[i].level == levels[1]);
    assert_true(plan.contours.count >= 2);
    pp_daylight_plan_clear(&plan);
    assert_int_equal(pp_daylight_curves(&plan, world, &light, NAN, "bre", 0, 0, &err),
                     PP_BAD_INPUT);
    pp_world_destroy(world);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_sky_line_lies_where_the_head_meets_a_far_skyline),
        cmocka_unit_test(no_sky_line_lies_where_the_head_meets_a_near_skyline),
        cmocka_unit_test(a_room_before_open_sky_has_no_no_sky_line),
        cmocka_unit_test(a_room_without_a_window_is_all_dark),
        cmocka_unit_test(the_corner_of_an_l_shape_throws_a_straight_shadow),
        cmocka_unit_test(points_of_a_contour_have_its_daylight_factor),
        cmocka_unit_test(no_more_than_a_fifth_of_the_plane_has_no_line),
        cmocka_unit_test(levels_between_usual_ones_are_multiples_of_a_round_step),
        cmocka_unit_test(requested_levels_are_the_levels_drawn),
    };
    add_tests(tests, NULL, NULL);
}
