/* test_form_factor.c - Lambert's sum compared with textbook formulae for rectangles,
 * and with the sum of form factors in closed rooms. */
#include "simulate/research/radiosity/form_factor.h"

#include "tests/lib/dice.h"
#include "tests/lib/near.h"

/* A rectangle a x b parallel to the receiver at distance c, with one corner above it
 * [HSM16]. */
static double above_corner(double a, double b, double c)
{
    double A = a / c, B = b / c, p = sqrt(1.0 + A * A), q = sqrt(1.0 + B * B);
    return (A / p * atan(B / p) + B / q * atan(A / q)) / (2.0 * PP_PI);
}

/* A vertical rectangle, b wide and a high, that begins at the receiver's plane at
 * distance c, with its lower corner directly in front of the receiver. */
static double upright_corner(double a, double b, double c)
{
    double X = a / b, Y = c / b, r = sqrt(X * X + Y * Y);
    return (atan(1.0 / Y) - Y / r * atan(1.0 / r)) / (2.0 * PP_PI);
}

static void rectangles_overhead_are_as_in_the_textbook(void **state)
{
    (void)state;
    const struct pp_vec3 corners[4] = {
        {0.0, 0.0, 1.7}, {2.0, 0.0, 1.7}, {2.0, 3.0, 1.7}, {0.0, 3.0, 1.7}};
    const struct pp_vec3 round[4] = {
        {-2.0, -3.0, 1.7}, {2.0, -3.0, 1.7}, {2.0, 3.0, 1.7}, {-2.0, 3.0, 1.7}};
    struct pp_vec3 up = {0.0, 0.0, 1.0}, at = {0.0, 0.0, 0.0};
    assert_near(pp_form_factor(at, up, corners, 4), above_corner(2.0, 3.0, 1.7), 1e-14);
    assert_near(pp_form_factor(at, up, round, 4), 4.0 * above_corner(2.0, 3.0, 1.7),
                1e-14);
    assert_near(pp_form_factor(at, pp_vec_scale(up, -1.0), corners, 4), 0.0, 0.0);
}

/* Two thirds of it are below the horizon and do not count. */
static void parts_below_the_horizon_are_cut_off(void **state)
{
    (void)state;
    const struct pp_vec3 upright[4] = {
        {0.0, 1.5, -2.4}, {2.0, 1.5, -2.4}, {2.0, 1.5, 1.2}, {0.0, 1.5, 1.2}};
    struct pp_vec3 up = {0.0, 0.0, 1.0}, at = {0.0, 0.0, 0.0};
    assert_near(pp_form_factor(at, up, upright, 4), upright_corner(1.2, 2.0, 1.5),
                1e-14);
}

/* From any point in a box, and for any orientation, the form factors of its six sides
 * add up to 1. */
static void the_sides_of_a_box_are_all_there_is(void **state)
{
    (void)state;
    static const int side[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    struct dice dice = {5};
    for (int trial = 0; trial < 500; trial++) {
        struct pp_vec3 size = pp_vec(between(&dice, 0.1, 9.0), between(&dice, 0.1, 9.0),
                                     between(&dice, 0.1, 9.0));
        struct pp_vec3 at =
            pp_vec(size.x * between(&dice, 0.0, 1.0), size.y * between(&dice, 0.0, 1.0),
                   size.z * between(&dice, 0.0, 1.0));
        struct pp_vec3 n =
            pp_vec_unit(pp_vec(between(&dice, -1.0, 1.0), between(&dice, -1.0, 1.0),
                               between(&dice, 0.1, 1.0)));
        double sum = 0.0;
        for (int i = 0; i < 6; i++) {
            struct pp_vec3 corners[4];
            for (int k = 0; k < 4; k++) {
                int c = side[i][k];
                corners[k] = pp_vec(c & 1 ? size.x : 0.0, c & 2 ? size.y : 0.0,
                                    c & 4 ? size.z : 0.0);
            }
            sum += pp_form_factor(at, n, corners, 4);
        }
        assert_near(sum, 1.0, 1e-12);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles_overhead_are_as_in_the_textbook),
        cmocka_unit_test(parts_below_the_horizon_are_cut_off),
        cmocka_unit_test(the_sides_of_a_box_are_all_there_is),
    };
    add_tests(tests, NULL, NULL);
}
