/* test_surface_pattern.c - slopes of heights given by a formula. */
#include "model/expression/surface_pattern.h"

#include "tests/lib/near.h"

/* Normals of a floor and of a wall. */
static const struct pp_vec3 up = {0.0, 0.0, 1.0}, east = {1.0, 0.0, 0.0};

static struct pp_vec3 slope_at(const char *formula, struct pp_vec3 normal, double x,
                               double y, double z)
{
    struct pp_surface_pattern height;
    struct pp_expression_mistake mistake;
    assert_true(pp_surface_pattern_parse(&height, formula, &mistake));
    return pp_surface_pattern_slope(&height, pp_vec(x, y, z), normal, NULL);
}

static void slopes_are_gradients(void **state)
{
    (void)state;
    struct pp_vec3 plane = slope_at("0.3 x - 2 y + 5", up, 1.0, 2.0, 3.0);
    assert_near(plane.x, 0.3, 1e-9);
    assert_near(plane.y, -2.0, 1e-9);
    assert_near(plane.z, 0.0, 1e-9);
    /* d/dz of 0.002 sin(3600 z): 0.002 (20 pi) cos(3600 z), angles in degrees */
    struct pp_vec3 wave = slope_at("0.002 sin(3600 z)", east, 1.0, 2.0, 0.1);
    assert_near(wave.z, 0.002 * 20.0 * PP_PI, 1e-4);
}

/* A height that grows only along the normal leaves the surface even. */
static void a_slope_lies_in_the_surface(void **state)
{
    (void)state;
    struct pp_vec3 slope = slope_at("3 z + 0.5 y", up, 1.0, 2.0, 0.0);
    assert_near(slope.y, 0.5, 1e-9);
    assert_near(slope.z, 0.0, 1e-15);
}

/* A saw has one slope everywhere, at its steps too. */
static void steps_have_no_slope(void **state)
{
    (void)state;
    for (double x = 0.0; x < 0.31; x += 0.01)
        assert_near(slope_at("0.5 mod(x, 0.1)", up, x, 0.0, 0.0).x, 0.5, 1e-9);
    assert_near(slope_at("floor(10 y)", up, 0.0, 0.3, 0.0).y, 0.0, 0.0);
}

/* At the edge of its range a formula has the slope of the side with a value. */
static void the_edge_of_the_range_has_a_slope(void **state)
{
    (void)state;
    assert_near(slope_at("x + 0 sqrt(x)", up, 0.0, 0.0, 0.0).x, 1.0, 1e-9);
    assert_true(isnan(slope_at("x + 0 sqrt(x)", up, -1.0, 0.0, 0.0).x));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_are_gradients),
        cmocka_unit_test(a_slope_lies_in_the_surface),
        cmocka_unit_test(steps_have_no_slope),
        cmocka_unit_test(the_edge_of_the_range_has_a_slope),
    };
    add_tests(tests, NULL, NULL);
}
