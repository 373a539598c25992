/* test_protractor_shapes.c - openings of any shape, which the protractor reads as
 * rectangles. */
#include <stdio.h>

#include "tests/lib/opened.h"

/* Sky component at (3.1, 1.9, 0.85) below a ceiling at 2.85 m with this opening. */
static double sky_under(const char *opening)
{
    char xml[600];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='9' depth='9' height='2.85'/>%s"
             "<point x='3.1' y='1.9' z='0.85'/></room>",
             opening);
    struct pp_test_opened opened = pp_test_open(xml);
    assert_int_equal(pp_study_methods(opened.study, "protractor", false, NULL), PP_OK);
    int column = pp_study_find(opened.study, PP_SC, "protractor");
    assert_true(column >= 0);
    double sky = pp_study_reading(opened.study, column, 0).value;
    pp_test_close(&opened);
    return sky;
}

/* A triangular opening is read as the rectangle with the same area, centre and
 * proportions: for a triangle of 3 m by 2 m, 3 by 2 divided by the square root of 2.
 * The same applies to a diamond of this size. */
static void a_triangle_is_read_as_the_rectangle_of_its_area(void **state)
{
    (void)state;
    char rectangle[200];
    double width = 3.0 / sqrt(2.0), depth = 2.0 / sqrt(2.0);
    snprintf(rectangle, sizeof rectangle,
             "<rooflight x='%.12f' y='%.12f' width='%.12f' depth='%.12f' "
             "glazing='none'/>",
             3.6 - width / 2.0, 3.3 - depth / 2.0, width, depth);
    double expected = sky_under(rectangle);
    assert_true(expected > 0.05);
    assert_relative(
        sky_under("<opening glazing='none'><vertex x='2.1' y='2.3' z='2.85'/>"
                  "<vertex x='2.1' y='4.3' z='2.85'/>"
                  "<vertex x='5.1' y='2.3' z='2.85'/></opening>"),
        expected, 1e-9);
    assert_relative(
        sky_under("<opening glazing='none'><vertex x='2.1' y='3.3' z='2.85'/>"
                  "<vertex x='3.6' y='4.3' z='2.85'/>"
                  "<vertex x='5.1' y='3.3' z='2.85'/>"
                  "<vertex x='3.6' y='2.3' z='2.85'/></opening>"),
        expected, 1e-9);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_triangle_is_read_as_the_rectangle_of_its_area),
    };
    add_tests(tests, NULL, NULL);
}
