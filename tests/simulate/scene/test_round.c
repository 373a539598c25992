/* test_round.c - points on spheres, rings and cones, uniform by area. */
#include "simulate/scene/round.h"

#include "tests/lib/near.h"

enum { SIDE = 100 };

/* Mean square distance of the points from an axis, over a grid of random numbers whose
 * midpoint sums are accurate to 1e-4. */
static double mean_square(const struct pp_shape *shape, struct pp_vec3 centre,
                          struct pp_vec3 along)
{
    double sum = 0.0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct pp_vec3 point =
            pp_round_point(shape, (i % SIDE + 0.5) / SIDE, (i / SIDE + 0.5) / SIDE);
        struct pp_vec3 off = pp_vec_cross(pp_vec_sub(point, centre), along);
        sum += pp_vec_dot(off, off) / (SIDE * SIDE);
    }
    return sum;
}

/* All points are one radius from the centre, and the mean square distance from each
 * axis is 2/3 of the squared radius. */
static void a_spheres_points_are_even_about_any_axis(void **state)
{
    (void)state;
    const struct pp_vec3 centre = {1.3, -0.4, 2.2};
    struct pp_shape sphere = {.kind = PP_SHAPE_SPHERE,
                              .is.sphere = {.centre = centre, .radius_m = 0.7}};
    static const struct pp_vec3 axes[] = {
        {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0, 0.8}};
    for (int k = 0; k < 4; k++)
        assert_relative(mean_square(&sphere, centre, axes[k]), 2.0 / 3.0 * 0.49, 2e-4);
    for (double u = 0.01; u < 1.0; u += 0.07) {
        struct pp_vec3 point = pp_round_point(&sphere, u, 1.0 - u);
        assert_near(pp_vec_length(pp_vec_sub(point, centre)), 0.7, 1e-12);
    }
    assert_near(pp_round_area(&sphere), 4.0 * M_PI * 0.49, 1e-12);
}

/* Between radii a and b the mean square distance from the axis is (a^2 + b^2)/2, in the
 * plane. */
static void a_rings_points_are_even(void **state)
{
    (void)state;
    const struct pp_vec3 centre = {0.3, 0.9, 1.1}, axis = {0.0, 0.6, 0.8};
    struct pp_shape ring = {
        .kind = PP_SHAPE_RING,
        .is.ring = {.centre = centre, .axis = axis, .radii_m = {0.4, 1.1}}};
    assert_relative(mean_square(&ring, centre, axis), (0.16 + 1.21) / 2.0, 2e-4);
    struct pp_vec3 off = pp_vec_sub(pp_round_point(&ring, 0.37, 0.81), centre);
    assert_near(pp_vec_dot(off, axis), 0.0, 1e-12);
    assert_near(pp_round_area(&ring), M_PI * (1.21 - 0.16), 1e-12);
}

/* Points of a cone from radius a to b are uniform by area; the radius changes linearly
 * along the axis. */
static void a_cones_points_are_even(void **state)
{
    (void)state;
    const struct pp_vec3 foot = {0.0, 0.0, 1.0}, head = {0.0, 0.0, 2.5};
    const struct pp_vec3 axis = {0.0, 0.0, 1.0};
    struct pp_shape cone = {.kind = PP_SHAPE_CONE,
                            .is.cone = {.ends = {foot, head}, .radii_m = {0.9, 0.2}}};
    assert_relative(mean_square(&cone, foot, axis), (0.81 + 0.04) / 2.0, 2e-4);
    for (double u = 0.03; u < 1.0; u += 0.09) {
        struct pp_vec3 point = pp_round_point(&cone, u, 0.3);
        assert_near(hypot(point.x, point.y), 0.9 - 0.7 * (point.z - 1.0) / 1.5, 1e-12);
    }
    assert_near(pp_round_area(&cone), M_PI * 1.1 * hypot(1.5, 0.7), 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_spheres_points_are_even_about_any_axis),
        cmocka_unit_test(a_rings_points_are_even),
        cmocka_unit_test(a_cones_points_are_even),
    };
    add_tests(tests, NULL, NULL);
}
