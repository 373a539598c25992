/* test_area_moments.c - areas, centroids and boxes of plane figures and of their parts,
 * compared with calculations by hand. */
#include "model/geometry/area_moments.h"

#include "tests/lib/near.h"

static void assert_moments(struct pp_area_moments is, double area, double x, double z,
                           const double box[4])
{
    assert_near(is.area, area, 1e-13);
    assert_near(is.x_moment, area * x, 1e-12);
    assert_near(is.z_moment, area * z, 1e-12);
    assert_near(is.left, box[0], 1e-14);
    assert_near(is.right, box[1], 1e-14);
    assert_near(is.low, box[2], 1e-14);
    assert_near(is.high, box[3], 1e-14);
}

/* The centroid of a triangle is the mean of its corners, for any origin. */
static void a_triangles_centroid_is_the_mean_of_its_corners(void **state)
{
    (void)state;
    static const double corners[3][2] = {{1.3, 0.4}, {4.9, 1.1}, {2.2, 3.7}};
    static const double box[4] = {1.3, 4.9, 0.4, 3.7};
    double area = (3.6 * 3.3 - 0.7 * 0.9) / 2.0;
    struct pp_area_moments sum = pp_area_moments_empty();
    for (int i = 0; i < 3; i++)
        pp_area_moments_add_edge(&sum, corners[i], corners[(i + 1) % 3]);
    assert_moments(sum, area, 8.4 / 3.0, 5.2 / 3.0, box);
}

/* A rectangle 3 m by 2 m with a hole of 1 m by 0.5 m in the opposite orientation: 5.5
 * m2, with centroids weighted by area. */
static void a_hole_reduces_area_and_moments(void **state)
{
    (void)state;
    static const double outer[4][2] = {{0.5, 1.0}, {3.5, 1.0}, {3.5, 3.0}, {0.5, 3.0}};
    static const double hole[4][2] = {{2.0, 2.2}, {2.0, 2.7}, {3.0, 2.7}, {3.0, 2.2}};
    static const double box[4] = {0.5, 3.5, 1.0, 3.0};
    struct pp_area_moments sum = pp_area_moments_empty();
    for (int i = 0; i < 4; i++) {
        pp_area_moments_add_edge(&sum, outer[i], outer[(i + 1) % 4]);
        pp_area_moments_add_edge(&sum, hole[i], hole[(i + 1) % 4]);
    }
    assert_moments(sum, 5.5, (6.0 * 2.0 - 0.5 * 2.5) / 5.5,
                   (6.0 * 2.0 - 0.5 * 2.45) / 5.5, box);
}

/* A triangle from 1 m below the horizon to 2 m above it: the part above the horizon is
 * a triangle of two thirds of its size. A spike to z = 5 and back is not included. */
static void above_the_horizon_the_upper_part_is_left(void **state)
{
    (void)state;
    double xy[6][2] = {{-1.5, -1.0}, {1.5, -1.0}, {0.75, 0.5},
                       {3.0, 5.0},   {0.75, 0.5}, {0.0, 2.0}};
    struct pp_ring ring = {6, xy};
    struct pp_region region = {1, &ring};
    static const double box[4] = {-1.0, 1.0, 0.0, 2.0};
    assert_moments(pp_area_moments_above_horizon(&region), 2.0, 0.0, 2.0 / 3.0, box);
}

/* The box leaves the part from 1.1 to 2.9 by 0.3 to 4 of the square from 0 to 4. It cuts
 * one corner off the triangle. */
static void a_box_keeps_the_part_inside_it(void **state)
{
    (void)state;
    double square[4 * PP_AREA_MOMENTS_POINTS][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    double spare[4 * PP_AREA_MOMENTS_POINTS][2];
    static const double of_square[4] = {1.1, 2.9, 0.3, 4.0};
    assert_moments(pp_area_moments_in_box(square, spare, 4, 1.1, 2.9, 0.3, INFINITY),
                   1.8 * 3.7, 2.0, 2.15, of_square);

    double corner[4 * PP_AREA_MOMENTS_POINTS][2] = {{0, 0}, {3, 0}, {0, 3}};
    static const double of_corner[4] = {0.0, 2.0, 0.0, 3.0};
    struct pp_area_moments rest =
        pp_area_moments_in_box(corner, spare, 3, -INFINITY, 2.0, -INFINITY, INFINITY);
    /* 4.5 m2 about (1, 1) less 0.5 m2 about (7/3, 1/3) */
    assert_moments(rest, 4.0, (4.5 - 0.5 * 7.0 / 3.0) / 4.0, (4.5 - 0.5 / 3.0) / 4.0,
                   of_corner);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_triangles_centroid_is_the_mean_of_its_corners),
        cmocka_unit_test(a_hole_reduces_area_and_moments),
        cmocka_unit_test(above_the_horizon_the_upper_part_is_left),
        cmocka_unit_test(a_box_keeps_the_part_inside_it),
    };
    add_tests(tests, NULL, NULL);
}
