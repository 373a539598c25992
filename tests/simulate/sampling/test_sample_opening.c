/* test_sample_opening.c - directions towards openings, compared with closed forms. */
#include "simulate/sampling/sample_polygon.h"
#include "simulate/sampling/sobol.h"

#include "tests/lib/near.h"

static struct pp_sobol sobol;

static int make_sobol(void **state)
{
    (void)state;
    pp_sobol_init(&sobol);
    return 0;
}

/* A window in the plane y = 0 that lights y > 0. */
static struct pp_target window(double x, double z, double width, double height)
{
    return (struct pp_target){.normal = {0.0, 1.0, 0.0},
                              .middle = {x + width / 2.0, 0.0, z + height / 2.0},
                              .area_m2 = width * height,
                              .rectangle = true,
                              .corner = {x + width, 0.0, z},
                              .along = {-1.0, 0.0, 0.0},
                              .up = {0.0, 0.0, 1.0},
                              .width_m = width,
                              .height_m = height};
}

/* Lambert's formula: the integral of the cosine over a polygon that is entirely in
 * front of n. */
static double lambert(const struct pp_vec3 *p, int count, struct pp_vec3 from,
                      struct pp_vec3 n)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 a = pp_vec_unit(pp_vec_sub(p[i], from));
        struct pp_vec3 b = pp_vec_unit(pp_vec_sub(p[(i + 1) % count], from));
        struct pp_vec3 across = pp_vec_cross(a, b);
        double sine = pp_vec_length(across);
        sum += atan2(sine, pp_vec_dot(a, b)) * pp_vec_dot(across, n) / sine;
    }
    return fabs(sum) / 2.0;
}

/* Solid angle of a rectangle with one corner at the foot of the perpendicular from the
 * point. */
static double corner_solid_angle(double a, double b, double d)
{
    return atan2(a * b, d * sqrt(a * a + b * b + d * d));
}

static double solid_angle(double x0, double x1, double z0, double z1, double d)
{
    return corner_solid_angle(x1, z1, d) - corner_solid_angle(x0, z1, d)
           - corner_solid_angle(x1, z0, d) + corner_solid_angle(x0, z0, d);
}

static const struct pp_brightness plain = {.ground = 0.2, .gradation = 2.0};

/* Solid angle and configuration integral by 2^m samples. */
static void sample_sums_under(const struct pp_brightness *brightness,
                              const struct pp_target *target, struct pp_vec3 from,
                              struct pp_vec3 n, int m, double *solid, double *facing)
{
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, 161803);
    struct pp_polygon_sampler sampler;
    pp_sample_polygon_init(&sampler, target, from, n, brightness);
    *solid = *facing = 0.0;
    for (uint32_t i = 0; i < UINT32_C(1) << m; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        struct pp_direction_sample sample =
            pp_sample_polygon_draw(&sampler, u[0], u[1]);
        *solid += sample.per_density / (1 << m);
        double c = pp_vec_dot(sample.direction, n);
        *facing += sample.per_density * (c > 0.0 ? c : 0.0) / (1 << m);
        assert_near(pp_vec_length(sample.direction), 1.0, 1e-9);
        /* The density of a given direction agrees, except for rounding at grazing
         * directions. */
        assert_relative(pp_sample_polygon_pdf(&sampler, sample.direction)
                            * sample.per_density,
                        1.0, 1e-5);
        assert_near(
            pp_vec_dot(pp_vec_sub(sample.point, target->middle), target->normal), 0.0,
            1e-9 * sample.distance_m);
    }
}

static void sample_sums(const struct pp_target *target, struct pp_vec3 from,
                        struct pp_vec3 n, int m, double *solid, double *facing)
{
    sample_sums_under(&plain, target, from, n, m, solid, facing);
}

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

/* Near and far, low and high, in front and to one side: the choice of density and the
 * weighting do not change the integrals. 2^14 points of a net give 1e-4. */
static void a_rectangle_has_its_solid_angle_from_anywhere(void **state)
{
    (void)state;
    struct pp_target target = window(0.2, 0.9, 2.6, 1.4);
    const struct pp_vec3 points[] = {{1.1, 2.0, 0.8},  {0.1, 0.05, 1.0},
                                     {1.4, 0.02, 1.6}, {2.9, 8.3, 0.0},
                                     {-4.0, 1.0, 2.7}, {1.5, 40.0, 0.3}};
    for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
        struct pp_vec3 p = points[i];
        double solid, facing;
        sample_sums(&target, p, pp_vec(0.0, -1.0, 0.0), 14, &solid, &facing);
        double expected = solid_angle(0.2 - p.x, 2.8 - p.x, 0.9 - p.z, 2.3 - p.z, p.y);
        assert_relative(solid, expected, 3e-4);
        struct pp_vec3 corners[4] = {
            {0.2, 0, 0.9}, {2.8, 0, 0.9}, {2.8, 0, 2.3}, {0.2, 0, 2.3}};
        assert_relative(facing, lambert(corners, 4, p, pp_vec(0.0, -1.0, 0.0)), 3e-4);
    }
}

/* A window 9 m long, seen from in front of its middle to beyond its end, near and far:
 * the estimate of its contribution is correct to a factor of 4. An estimate from its
 * middle alone is 40 times too low near the end. */
static void a_long_window_is_guessed_at_near_its_end(void **state)
{
    (void)state;
    const struct pp_brightness even = {.ground = 1.0, .gradation = 0.0};
    struct pp_target target = window(0.0, 0.9, 9.0, 0.6);
    struct pp_vec3 corners[4] = {
        {0.0, 0, 0.9}, {9.0, 0, 0.9}, {9.0, 0, 1.5}, {0.0, 0, 1.5}};
    struct pp_vec3 n = {0.0, -1.0, 0.0};
    double low = 1e9, high = 0.0;
    for (double x = 4.5; x < 9.6; x += 0.3)
        for (double y = 0.05; y < 5.0; y *= 2.0) {
            struct pp_vec3 p = {x, y, 1.1};
            double guess = pp_sample_polygon_importance(&target, p, n, &even);
            double ratio = guess / lambert(corners, 4, p, n);
            low = fmin(low, ratio);
            high = fmax(high, ratio);
        }
    assert_true(low > 0.25 && high < 4.0);
}

static void a_polygon_has_its_configuration_factor(void **state)
{
    (void)state;
    /* A sloping pentagon of three triangles. */
    struct pp_vec3 slope = pp_vec_unit(pp_vec(0.0, 0.5, -1.0));
    struct pp_vec3 along = {1.0, 0.0, 0.0}, over = pp_vec_cross(slope, along);
    struct pp_vec3 origin = {0.7, 1.1, 2.9};
    const double plan[5][2] = {
        {0, 0}, {1.7, -0.2}, {2.1, 1.0}, {0.9, 1.9}, {-0.3, 1.2}};
    struct pp_vec3 corner[5], triangles[3][3];
    for (int i = 0; i < 5; i++)
        corner[i] =
            pp_vec_along(pp_vec_along(origin, plan[i][0], along), plan[i][1], over);
    struct pp_target target = {.normal = slope, .middle = origin, .triangle_count = 3};
    for (int i = 0; i < 3; i++) {
        triangles[i][0] = corner[0];
        triangles[i][1] = corner[i + 1];
        triangles[i][2] = corner[i + 2];
        target.area_m2 +=
            pp_vec_length(pp_vec_cross(pp_vec_sub(corner[i + 1], corner[0]),
                                       pp_vec_sub(corner[i + 2], corner[0])))
            / 2.0;
    }
    target.triangles = triangles;
    const struct pp_vec3 points[] = {
        {1.1, 2.0, 0.8}, {1.4, 1.5, 2.6}, {30.0, 40.0, -9.0}};
    for (int i = 0; i < 3; i++) {
        double solid, facing;
        struct pp_vec3 n = pp_vec_scale(slope, -1.0);
        sample_sums(&target, points[i], n, 14, &solid, &facing);
        assert_relative(facing, lambert(corner, 5, points[i], n), 1e-3);
    }
}

/* A rooflight outside, at a height of 5 m and 1.8 m to 2.7 m in front of the window. */
static const struct pp_target beyond = {.normal = {0.0, 0.0, -1.0},
                                        .middle = {1.45, -2.25, 5.0},
                                        .area_m2 = 1.3 * 0.9,
                                        .rectangle = true,
                                        .corner = {0.8, -2.7, 5.0},
                                        .along = {1.0, 0.0, 0.0},
                                        .up = {0.0, 1.0, 0.0},
                                        .width_m = 1.3,
                                        .height_m = 0.9};

/* A rooflight that is seen through part of the window attracts directions, but does not
 * change the solid angle of the window. From the third point it is not seen. */
static void an_opening_beyond_a_window_leaves_its_solid_angle_alone(void **state)
{
    (void)state;
    struct pp_target target = window(0.2, 0.9, 2.6, 1.4);
    struct pp_brightness brightness = plain;
    brightness.beyond = &beyond;
    brightness.beyond_count = 1;
    const struct pp_vec3 points[] = {{1.1, 1.1, 0.2}, {0.4, 0.3, 1.1}, {1.1, 9.0, 0.8}};
    for (int i = 0; i < 3; i++) {
        struct pp_polygon_sampler sampler;
        struct pp_vec3 p = points[i];
        double solid, facing;
        pp_sample_polygon_init(&sampler, &target, p, up, &brightness);
        assert_true(i < 2 ? sampler.part.share > 0.05 : sampler.part.share == 0.0);
        sample_sums_under(&brightness, &target, p, up, 16, &solid, &facing);
        assert_relative(
            solid, solid_angle(0.2 - p.x, 2.8 - p.x, 0.9 - p.z, 2.3 - p.z, p.y), 1e-3);
    }
}

/* The part through which the rooflight is seen: from 1 m behind the window, the
 * corners of the rooflight at 2.7 m and 1.8 m outside are projected to 1/3.7 and 1/2.8
 * of the way. */
static void an_opening_beyond_is_projected_to_the_window(void **state)
{
    (void)state;
    struct pp_target target = window(0.2, 0.9, 2.6, 1.4);
    struct pp_brightness brightness = {.beyond = &beyond, .beyond_count = 1};
    struct pp_polygon_sampler sampler;
    struct pp_vec3 p = {1.1, 1.0, 0.2};
    pp_sample_polygon_init(&sampler, &target, p, up, &brightness);
    /* x from 1.1 - 0.3/2.8 to 1.1 + 1.0/2.8, counted from x = 2.8 to the left; z from
     * 0.2 + 4.8/3.7 to 0.2 + 4.8/2.8, counted from 0.9. */
    assert_near(sampler.part.x0, 2.8 - (1.1 + 1.0 / 2.8), 1e-12);
    assert_near(sampler.part.x1, 2.8 - (1.1 - 0.3 / 2.8), 1e-12);
    assert_near(sampler.part.y0, 0.2 + 4.8 / 3.7 - 0.9, 1e-12);
    assert_near(sampler.part.y1, 0.2 + 4.8 / 2.8 - 0.9, 1e-12);
}

/* Each of 5 x 5 parts of the window contributes its own solid angle. */
static void density_is_right_in_every_part_of_a_rectangle(void **state)
{
    (void)state;
    struct pp_target target = window(0.2, 0.9, 2.6, 1.4);
    const struct pp_vec3 points[] = {{1.1, 1.0, 0.4}, {3.1, 6.0, 1.7}};
    for (int k = 0; k < 2; k++) {
        struct pp_vec3 p = points[k];
        double part[5][5] = {{0.0}};
        struct pp_sobol_sequence sequence;
        pp_sobol_sequence_init(&sequence, &sobol, 42);
        struct pp_polygon_sampler sampler;
        pp_sample_polygon_init(
            &sampler, &target, p, up,
            &(struct pp_brightness){.ground = 0.2, .gradation = 2.0});
        enum { N = 1 << 20 };
        for (uint32_t i = 0; i < N; i++) {
            double u[2];
            pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
            struct pp_direction_sample sample =
                pp_sample_polygon_draw(&sampler, u[0], u[1]);
            int column = (int)((sample.point.x - 0.2) / 2.6 * 5.0);
            int row = (int)((sample.point.z - 0.9) / 1.4 * 5.0);
            part[row < 5 ? row : 4][column < 5 ? column : 4] += sample.per_density / N;
        }
        for (int row = 0; row < 5; row++)
            for (int column = 0; column < 5; column++) {
                double x = 0.2 + 0.52 * column - p.x, z = 0.9 + 0.28 * row - p.z;
                assert_relative(part[row][column],
                                solid_angle(x, x + 0.52, z, z + 0.28, p.y), 5e-3);
            }
    }
}

/* A receiver facing up beside a window that is entirely above it: the estimate of the
 * cosine is so good that 64 directions give the configuration factor to 1 %. */
static void the_guess_makes_a_few_directions_enough(void **state)
{
    (void)state;
    struct pp_target target = window(0.2, 0.9, 2.6, 1.4);
    struct pp_vec3 corners[4] = {
        {0.2, 0, 0.9}, {2.8, 0, 0.9}, {2.8, 0, 2.3}, {0.2, 0, 2.3}};
    struct pp_vec3 p = {1.1, 2.0, 0.8};
    double solid, facing;
    sample_sums(&target, p, up, 6, &solid, &facing);
    assert_relative(facing, lambert(corners, 4, p, up), 0.01);
}

static void a_window_is_seen_from_its_own_side_only(void **state)
{
    (void)state;
    struct pp_target target = window(0.2, 0.9, 2.6, 1.4);
    assert_true(pp_sample_polygon_in_sight(&target, pp_vec(1.0, 2.0, 0.8), up));
    assert_false(pp_sample_polygon_in_sight(&target, pp_vec(1.0, -2.0, 0.8), up));
    assert_false(pp_sample_polygon_in_sight(&target, pp_vec(3.0, 0.0, 0.8), up));
    assert_false(pp_sample_polygon_in_sight(&target, pp_vec(1.0, 2.0, 2.4), up));
    assert_true(pp_sample_polygon_in_sight(&target, pp_vec(1.0, 2.0, 2.2), up));
    assert_false(pp_sample_polygon_in_sight(&target, pp_vec(1.0, 2.0, 2.0),
                                            pp_vec(0.0, 1.0, 0.0)));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rectangle_has_its_solid_angle_from_anywhere),
        cmocka_unit_test(a_long_window_is_guessed_at_near_its_end),
        cmocka_unit_test(a_polygon_has_its_configuration_factor),
        cmocka_unit_test(an_opening_beyond_a_window_leaves_its_solid_angle_alone),
        cmocka_unit_test(an_opening_beyond_is_projected_to_the_window),
        cmocka_unit_test(density_is_right_in_every_part_of_a_rectangle),
        cmocka_unit_test(the_guess_makes_a_few_directions_enough),
        cmocka_unit_test(a_window_is_seen_from_its_own_side_only),
    };
    add_tests(tests, make_sobol, NULL);
}
