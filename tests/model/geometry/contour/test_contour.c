/* test_contour.c - level curves of functions with known level curves. */
#include <stdlib.h>

#include "model/geometry/contour/contour.h"
#include "model/geometry/clipper.h"
#include "tests/lib/near.h"

#define TOLERANCE 1e-3

static const double oblong[][2] = {{0.3, -0.2}, {5.9, -0.2}, {5.9, 4.1}, {0.3, 4.1}};
static const double l_shape[][2] = {{0, 0},     {6.3, 0},   {6.3, 2.1},
                                    {2.4, 2.1}, {2.4, 5.2}, {0, 5.2}};

static struct pp_region region_of(const double (*xy)[2], int count)
{
    struct pp_clipper *clipper;
    struct pp_region region;
    assert_int_equal(pp_clipper_create(&clipper, 0), PP_OK);
    assert_int_equal(pp_clipper_of_ring(clipper, &region, xy, count, 0), PP_OK);
    pp_clipper_destroy(clipper);
    return region;
}

/* The region without a rectangle in its middle. */
static struct pp_region with_hole(const double (*xy)[2], int count,
                                  const double (*hole)[2])
{
    struct pp_clipper *clipper;
    struct pp_region whole = region_of(xy, count), less = region_of(hole, 4), region;
    assert_int_equal(pp_clipper_create(&clipper, 0), PP_OK);
    assert_int_equal(pp_clipper_difference(clipper, &region, &whole, &less, 0), PP_OK);
    pp_clipper_destroy(clipper);
    pp_region_clear(&whole);
    pp_region_clear(&less);
    return region;
}

static struct pp_field *field_of(const struct pp_region *region,
                                 pp_field_function function)
{
    struct pp_field *field;
    struct pp_error err;
    if (pp_field_create(&field, region, function, 0, TOLERANCE, &err) != PP_OK)
        fail_msg("%s", err.message);
    return field;
}

static double signed_area(const struct pp_curve *curve)
{
    double twice = 0.0;
    for (int i = 0; i < curve->count; i++) {
        const double *a = curve->xy[i], *b = curve->xy[(i + 1) % curve->count];
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return 0.5 * twice;
}

/* A dome with its top at (3.1, 1.7): level 1 - r^2 is a circle of radius r. */
static enum pp_status dome(void *context, double x, double y, double *value,
                           struct pp_error *err)
{
    (void)context, (void)err;
    *value = 1.0 - (x - 3.1) * (x - 3.1) - (y - 1.7) * (y - 1.7);
    return PP_OK;
}

static void level_of_a_dome_is_a_circle_that_is_closed_and_turns_left(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    struct pp_field *field = field_of(&region, dome);
    struct pp_curve_list curves = {0};
    double radius = 1.37;
    assert_int_equal(pp_contour_curves(field, 1.0 - radius * radius, &curves, 0),
                     PP_OK);
    assert_int_equal(curves.count, 1);
    const struct pp_curve *circle = &curves.list[0];
    assert_true(circle->closed);
    for (int i = 0; i < circle->count; i++) {
        /* Points are on the circle; chords are inside by at most the tolerance. */
        const double *a = circle->xy[i], *b = circle->xy[(i + 1) % circle->count];
        assert_near(hypot(a[0] - 3.1, a[1] - 1.7), radius, TOLERANCE);
        assert_near(hypot(0.5 * (a[0] + b[0]) - 3.1, 0.5 * (a[1] + b[1]) - 1.7), radius,
                    1.5 * TOLERANCE);
    }
    /* The higher side is inside, on the left. The area is accurate to a strip as wide
     * as the tolerance. */
    assert_near(signed_area(circle), M_PI * radius * radius,
                2.0 * M_PI * radius * TOLERANCE);
    assert_near(pp_curve_length(circle), 2.0 * M_PI * radius, 5e-3);
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

static void circles_far_smaller_than_the_figure_are_found(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    struct pp_field *field = field_of(&region, dome);
    struct pp_curve_list curves = {0};
    assert_int_equal(pp_contour_curves(field, 1.0 - 0.15 * 0.15, &curves, 0), PP_OK);
    assert_int_equal(curves.count, 1);
    assert_near(signed_area(&curves.list[0]), M_PI * 0.15 * 0.15,
                2.0 * M_PI * 0.15 * TOLERANCE);
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

static enum pp_status slanting_ellipse(void *context, double x, double y, double *value,
                                       struct pp_error *err)
{
    (void)context, (void)err;
    double u = 0.8 * (x - 3.0) + 0.6 * (y - 2.0),
           v = -0.6 * (x - 3.0) + 0.8 * (y - 2.0);
    *value = u * u / (2.1 * 2.1) + v * v / (0.45 * 0.45);
    return PP_OK;
}

static void level_of_a_valley_is_an_ellipse_that_turns_right(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    struct pp_field *field = field_of(&region, slanting_ellipse);
    struct pp_curve_list curves = {0};
    assert_int_equal(pp_contour_curves(field, 1.0, &curves, 0), PP_OK);
    assert_int_equal(curves.count, 1);
    assert_true(curves.list[0].closed);
    /* The ellipse has a circumference of 8.9 m; the lower side is inside. */
    assert_near(signed_area(&curves.list[0]), -M_PI * 2.1 * 0.45, 9.1 * TOLERANCE);
    for (int i = 0; i < curves.list[0].count; i++) {
        /* The slope is largest at the ends of the short axis: 2/0.45 per metre. */
        double value;
        slanting_ellipse(0, curves.list[0].xy[i][0], curves.list[0].xy[i][1], &value,
                         0);
        assert_near(value, 1.0, 2.0 / 0.45 * TOLERANCE);
    }
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

/* Rises along (1, 0.3). */
static enum pp_status ramp(void *context, double x, double y, double *value,
                           struct pp_error *err)
{
    (void)context, (void)err;
    *value = x + 0.3 * y;
    return PP_OK;
}

static void a_straight_level_line_is_cut_by_the_edges_of_an_l_shape(void **state)
{
    (void)state;
    struct pp_region region = region_of(l_shape, 6);
    struct pp_field *field = field_of(&region, ramp);
    struct pp_curve_list curves = {0};
    /* x + 0.3 y = 2.95 runs through the foot from (2.95, 0) to (2.32, 2.1), where x is
     * under 2.4, and on in the stem until (1.39, 5.2). */
    assert_int_equal(pp_contour_curves(field, 2.95, &curves, 0), PP_OK);
    assert_int_equal(curves.count, 1);
    assert_false(curves.list[0].closed);
    assert_near(pp_curve_length(&curves.list[0]), hypot(5.2, 0.3 * 5.2), TOLERANCE);
    pp_curve_list_clear(&curves);

    /* The level 3.2 leaves the foot at (2.57, 2.1) and enters the stem at (2.4,
     * 2.667). */
    assert_int_equal(pp_contour_curves(field, 3.2, &curves, 0), PP_OK);
    assert_int_equal(curves.count, 2);
    for (int i = 0; i < 2; i++) {
        const struct pp_curve *line = &curves.list[i];
        assert_false(line->closed);
        const double *first = line->xy[0], *last = line->xy[line->count - 1];
        /* The higher side, the east, is on its left, so it runs south. */
        assert_true(first[1] > last[1]);
        bool foot = last[1] < 1.0;
        assert_near(first[0], foot ? 2.57 : 1.64, TOLERANCE);
        assert_near(first[1], foot ? 2.1 : 5.2, 1e-12);
        assert_near(last[0], foot ? 3.2 : 2.4, TOLERANCE);
        assert_near(last[1], foot ? 0.0 : 8.0 / 3.0, 4.0 * TOLERANCE);
    }
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

/* Two slopes that meet in a crease: at level 0 the curve of their minimum is a wedge.
 * One of them is nearly horizontal, as between rows of a table. */
struct wedge {
    double at[2], turn; /* its corner, and the direction in which it opens */
    double half;        /* angle to its sides */
};

static enum pp_status lower_of_two(void *context, double x, double y, double *value,
                                   struct pp_error *err)
{
    (void)err;
    const struct wedge *wedge = context;
    double left = wedge->turn + wedge->half, right = wedge->turn - wedge->half;
    double dx = x - wedge->at[0], dy = y - wedge->at[1];
    *value = fmin(0.02 * (dx * sin(left) - dy * cos(left)),
                  dy * cos(right) - dx * sin(right));
    return PP_OK;
}

/* In forty wedges at any position relative to the mesh, no piece of the curve, chords
 * included, is farther from the sides of the wedge than the corner may be cut off. */
static void the_curve_of_a_crease_turns_its_corner(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    for (int k = 0; k < 40; k++) {
        struct wedge wedge = {{2.0 + 0.05 * k, 1.2 + 0.031 * k},
                              0.7 + 2.4 * k,
                              (12.0 + 1.5 * k) * PP_RAD};
        struct pp_field *field;
        struct pp_curve_list curves = {0};
        double worst = 0.0, nearest = INFINITY;
        assert_int_equal(
            pp_field_create(&field, &region, lower_of_two, &wedge, TOLERANCE, NULL),
            PP_OK);
        assert_int_equal(pp_contour_curves(field, 0.0, &curves, NULL), PP_OK);
        assert_int_equal(curves.count, 1);
        const struct pp_curve *curve = &curves.list[0];
        for (int i = 1; i < curve->count; i++) {
            const double *a = curve->xy[i - 1], *b = curve->xy[i];
            double x = 0.5 * (a[0] + b[0]) - wedge.at[0];
            double y = 0.5 * (a[1] + b[1]) - wedge.at[1];
            double off = INFINITY;
            for (int side = -1; side <= 1; side += 2) {
                double angle = wedge.turn + side * wedge.half;
                if (x * cos(angle) + y * sin(angle) > 0.0)
                    off = fmin(off, fabs(x * sin(angle) - y * cos(angle)));
            }
            worst = fmax(worst, fmin(off, hypot(x, y)));
            nearest = fmin(nearest, hypot(b[0] - wedge.at[0], b[1] - wedge.at[1]));
        }
        assert_true(worst < 0.02);
        assert_true(nearest < 0.05);
        pp_curve_list_clear(&curves);
        pp_field_destroy(field);
    }
    pp_region_clear(&region);
}

/* A step from 0 to 1 at a slanting line. */
static enum pp_status step(void *context, double x, double y, double *value,
                           struct pp_error *err)
{
    (void)context, (void)err;
    *value = x - 0.4 * y > 1.83 ? 1.0 : 0.0;
    return PP_OK;
}

static void a_step_is_followed_where_it_jumps(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    struct pp_field *field = field_of(&region, step);
    struct pp_curve_list curves = {0};
    assert_int_equal(pp_contour_curves(field, 1e-9, &curves, 0), PP_OK);
    assert_int_equal(curves.count, 1);
    for (int i = 0; i < curves.list[0].count; i++)
        assert_near(curves.list[0].xy[i][0] - 0.4 * curves.list[0].xy[i][1], 1.83,
                    hypot(1.0, 0.4) * TOLERANCE);
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

static double area_below(struct pp_field *field, double level)
{
    struct pp_curve_list outlines = {0};
    assert_int_equal(pp_contour_below(field, level, &outlines, 0), PP_OK);
    double area = 0.0;
    for (int i = 0; i < outlines.count; i++) {
        assert_true(outlines.list[i].closed);
        area += signed_area(&outlines.list[i]);
    }
    pp_curve_list_clear(&outlines);
    return area;
}

static void what_lies_below_a_level_has_the_area_that_geometry_gives(void **state)
{
    (void)state;
    struct pp_region region = region_of(l_shape, 6);
    struct pp_field *field = field_of(&region, ramp);
    double whole = 6.3 * 2.1 + 2.4 * 3.1;
    assert_near(area_below(field, -1.0), 0.0, 0.0);
    assert_near(area_below(field, 7.5), whole, 1e-12);
    /* Below 2.95: a trapezium in the foot and the stem with parallel sides. */
    assert_near(area_below(field, 2.95), 0.5 * (2.95 + 1.39) * 5.2 - 0.0,
                5.5 * TOLERANCE);
    /* Below 3.2: the trapezium in the foot, and the stem without the corner that the
     * line cuts off, with the height 5.2 - 8/3. */
    double stem = 2.4 * 3.1 - 0.5 * (5.2 - 8.0 / 3.0) * (2.4 - 1.64);
    assert_near(area_below(field, 3.2), 0.5 * (3.2 + 2.57) * 2.1 + stem,
                5.0 * TOLERANCE);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

static void a_hole_in_the_figure_is_kept_out(void **state)
{
    (void)state;
    static const double hole[][2] = {{2.2, 1.1}, {4.0, 1.1}, {4.0, 2.4}, {2.2, 2.4}};
    struct pp_region region = with_hole(oblong, 4, hole);
    struct pp_field *field = field_of(&region, dome);
    /* The circle of radius 0.5 is inside the hole, that of 0.8 partly outside its upper
     * and lower sides, that of 1.6 surrounds the hole. */
    static const struct {
        double radius;
        int count;
    } rows[] = {{0.5, 0}, {0.8, 2}, {1.6, 1}};
    for (int i = 0; i < 3; i++) {
        double radius = rows[i].radius;
        struct pp_curve_list curves = {0};
        assert_int_equal(pp_contour_curves(field, 1.0 - radius * radius, &curves, 0),
                         PP_OK);
        assert_int_equal(curves.count, rows[i].count);
        pp_curve_list_clear(&curves);
    }
    /* Everything is lower except the ring between the circle of 1.6 and the hole. */
    assert_near(area_below(field, 1.0 - 1.6 * 1.6), 5.6 * 4.3 - M_PI * 1.6 * 1.6,
                2.0 * M_PI * 1.6 * TOLERANCE);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

static void function_values_are_not_evaluated_twice_as_often_as_needed(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    struct pp_field *field = field_of(&region, dome);
    struct pp_curve_list curves = {0};
    double low, low_xy[2], high, high_xy[2];
    pp_field_range(field, &low, low_xy, &high, high_xy);
    assert_near(high, 1.0, 0.2);
    assert_near(hypot(high_xy[0] - 3.1, high_xy[1] - 1.7), 0.0, 0.3);
    long before = pp_field_evaluations(field);
    /* Six levels of a smooth function, about 40 m of curve, must need few evaluations:
     * those of `exact` take up to 0.1 ms each, and a plan should be drawn within a
     * second. */
    for (int i = 1; i <= 6; i++)
        assert_int_equal(pp_contour_curves(field, 1.0 - 0.1 * i * i, &curves, 0),
                         PP_OK);
    assert_true(before < 4000);
    assert_true(pp_field_evaluations(field) - before < 8000);
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

static enum pp_status fails_in_the_east(void *context, double x, double y,
                                        double *value, struct pp_error *err)
{
    *(int *)context += 1;
    if (x > 4.0)
        return pp_fail(err, PP_INTERRUPTED, "no more at %g, %g", x, y);
    *value = x;
    return PP_OK;
}

static void a_failure_of_the_function_is_handed_on(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4), empty = {0};
    struct pp_field *field;
    struct pp_error err;
    int calls = 0;
    assert_int_equal(
        pp_field_create(&field, &region, fails_in_the_east, &calls, TOLERANCE, &err),
        PP_INTERRUPTED);
    assert_null(field);
    assert_non_null(strstr(err.message, "no more at"));
    assert_int_equal(pp_field_create(&field, &empty, ramp, 0, TOLERANCE, &err),
                     PP_BAD_INPUT);
    assert_int_equal(pp_field_create(&field, &region, ramp, 0, 0.0, &err),
                     PP_BAD_INPUT);
    pp_region_clear(&region);
}

/* A slope with waves half as long as a triangle: its level curve leaves triangles
 * between their corners and returns. */
static double wave(double x)
{
    return 2.0 + 0.11 * sin(17.0 * x);
}

static enum pp_status wavy_slope(void *context, double x, double y, double *value,
                                 struct pp_error *err)
{
    (void)context, (void)err;
    *value = y - wave(x);
    return PP_OK;
}

static void a_level_that_leaves_triangles_and_comes_back_is_followed(void **state)
{
    (void)state;
    struct pp_region region = region_of(oblong, 4);
    struct pp_field *field = field_of(&region, wavy_slope);
    struct pp_curve_list curves = {0};
    assert_int_equal(pp_contour_curves(field, 0.0, &curves, 0), PP_OK);
    assert_int_equal(curves.count, 1);
    const struct pp_curve *curve = &curves.list[0];
    double steepest = hypot(1.0, 17.0 * 0.11);
    for (int i = 0; i + 1 < curve->count; i++) {
        const double *a = curve->xy[i], *b = curve->xy[i + 1];
        double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]);
        assert_near(y, wave(x), 4.0 * steepest * TOLERANCE);
    }
    pp_curve_list_clear(&curves);
    pp_field_destroy(field);
    pp_region_clear(&region);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(level_of_a_dome_is_a_circle_that_is_closed_and_turns_left),
        cmocka_unit_test(circles_far_smaller_than_the_figure_are_found),
        cmocka_unit_test(level_of_a_valley_is_an_ellipse_that_turns_right),
        cmocka_unit_test(a_straight_level_line_is_cut_by_the_edges_of_an_l_shape),
        cmocka_unit_test(a_step_is_followed_where_it_jumps),
        cmocka_unit_test(a_level_that_leaves_triangles_and_comes_back_is_followed),
        cmocka_unit_test(the_curve_of_a_crease_turns_its_corner),
        cmocka_unit_test(what_lies_below_a_level_has_the_area_that_geometry_gives),
        cmocka_unit_test(a_hole_in_the_figure_is_kept_out),
        cmocka_unit_test(function_values_are_not_evaluated_twice_as_often_as_needed),
        cmocka_unit_test(a_failure_of_the_function_is_handed_on),
    };
    add_tests(tests, NULL, NULL);
}
