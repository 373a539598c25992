/* test_solid_angle.c - closed forms for plane polygons: limits and known values. */
#include "tests/lib/near.h"

#include "methods/exact/solid_angle.h"

static const struct pp_vec3 zenith = {0.0, 0.0, 1.0};

/* Quadrilaterals, counter-clockwise as the eye at the origin sees them. */
static struct pp_moments moments_of(const struct pp_vec3 corners[4],
                                    struct pp_vec3 normal)
{
    struct pp_moments sum = {0};
    struct pp_vec3 half_spaces[2] = {normal, zenith};
    pp_solid_angle_add_moments(&sum, corners, 4, normal, half_spaces, 2);
    return sum;
}

/* A vertical rectangle at `distance` in the direction +y. */
static struct pp_moments upright(double left, double right, double sill, double head,
                                 double distance, struct pp_vec3 normal)
{
    const struct pp_vec3 corners[4] = {{left, distance, sill},
                                       {right, distance, sill},
                                       {right, distance, head},
                                       {left, distance, head}};
    return moments_of(corners, normal);
}

/* A horizontal rectangle overhead. */
static struct pp_moments overhead(double x0, double x1, double y0, double y1,
                                  double height)
{
    const struct pp_vec3 corners[4] = {
        {x0, y1, height}, {x1, y1, height}, {x1, y0, height}, {x0, y0, height}};
    return moments_of(corners, zenith);
}

static double overcast(struct pp_moments moments)
{
    struct pp_sky sky = pp_sky_overcast();
    return pp_solid_angle_sky_component(&moments, &sky);
}

static double uniform(struct pp_moments moments)
{
    struct pp_sky sky = pp_sky_uniform();
    return pp_solid_angle_sky_component(&moments, &sky);
}

/* A ceiling that is 1e9 times as wide as high misses a strip of the horizon. The light
 * from this strip is of the order of 1e-9 squared. */
static void an_endless_ceiling_shows_the_whole_sky(void **state)
{
    (void)state;
    struct pp_moments all = overhead(-1.3e9, 1.7e9, -2.1e9, 1.1e9, 0.7);
    assert_near(overcast(all), 1.0, 1e-14);
    assert_near(uniform(all), 1.0, 1e-14);
    assert_near(all.omega, 2.0 * PP_PI, 1e-8);
}

static void an_endless_wall_shows_half_the_sky(void **state)
{
    (void)state;
    struct pp_moments half = upright(-1.3e9, 1.7e9, -1.0, 2.1e9, 0.3, zenith);
    assert_near(overcast(half), 0.5, 1e-9);
    assert_near(uniform(half), 0.5, 1e-9);
    assert_near(half.omega, PP_PI, 1e-8);
}

/* The vertical sky component of the overcast sky: 3/14 + 4/(7 pi) = 0.3961768. */
static void a_vertical_receiver_sees_the_vertical_sky_component(void **state)
{
    (void)state;
    struct pp_vec3 facing = {0.0, 1.0, 0.0};
    struct pp_moments all = upright(-1.3e9, 1.7e9, -2.0e9, 2.1e9, 0.3, facing);
    assert_near(overcast(all), 3.0 / 14.0 + 4.0 / (7.0 * PP_PI), 1e-13);
    assert_near(overcast(all), 0.396177, 5e-7);
    assert_near(uniform(all), 0.5, 1e-13);
}

/* A window calculated independently to fourteen digits. */
static void the_design_window_has_its_fourteen_digits(void **state)
{
    (void)state;
    struct pp_moments window = upright(0.2 - 1.1, 2.8 - 1.1, 0.1, 1.5, 2.0, zenith);
    assert_relative(overcast(window), 0.04486082291318, 1e-13);
    assert_relative(uniform(window), 0.05899459937149, 1e-13);
}

/* SF and SC of a rectangle with its sill in the receiver's plane and one jamb on its
 * normal [TS93], h and w over the distance. */
static double paper_uniform(double h, double w)
{
    double slant = sqrt(1.0 + h * h);
    return (atan(w) - atan(w / slant) / slant) / (2.0 * PP_PI);
}

static double paper_overcast(double h, double w)
{
    double r = sqrt(1.0 + h * h + w * w);
    return 3.0 / 7.0 * paper_uniform(h, w)
           + 2.0 / (7.0 * PP_PI) * (atan(h * w / r) - h * w / ((1.0 + h * h) * r));
}

static void vertical_rectangles_agree_with_closed_forms(void **state)
{
    (void)state;
    static const double sides[][4] = {/* h, w, SF and SC in per cent as printed */
                                      {0.5, 0.5, 1.3928, 0.9430},
                                      {1.0, 1.0, 5.5734, 4.5251},
                                      {1.0, 2.0, 6.8697, 5.4586},
                                      {2.0, 1.0, 9.5068, 8.8164},
                                      {0.5, 2.0, 2.5164, 1.6457}};
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        double h = sides[i][0], w = sides[i][1], d = 1.7;
        struct pp_moments m = upright(0.0, w * d, 0.0, h * d, d, zenith);
        assert_near(uniform(m), sides[i][2] / 100.0, 0.5e-6);
        assert_near(overcast(m), sides[i][3] / 100.0, 0.5e-6);
        assert_relative(uniform(m), paper_uniform(h, w), 1e-13);
        assert_relative(overcast(m), paper_overcast(h, w), 1e-13);
    }
}

static void horizontal_rectangles_agree_with_closed_forms(void **state)
{
    (void)state;
    static const double sides[][4] = {{1.0, 1.0, 13.8532, 15.9497},
                                      {0.5, 2.0, 10.6838, 12.2905}};
    for (size_t i = 0; i < 2; i++) {
        double a = sides[i][0], b = sides[i][1], height = 2.3;
        struct pp_moments m = overhead(0.0, a * height, 0.0, b * height, height);
        double ra = sqrt(1.0 + a * a), rb = sqrt(1.0 + b * b);
        double r = sqrt(1.0 + a * a + b * b);
        double u = 0.5 * (a / ra * atan(b / ra) + b / rb * atan(a / rb));
        double v =
            (atan(a * b / r) + a * b / r * (1.0 / (ra * ra) + 1.0 / (rb * rb))) / 3.0;
        assert_near(uniform(m), sides[i][2] / 100.0, 0.5e-6);
        assert_near(overcast(m), sides[i][3] / 100.0, 0.5e-6);
        assert_relative(uniform(m), u / PP_PI, 1e-13);
        assert_relative(overcast(m), 3.0 / (7.0 * PP_PI) * (u + 2.0 * v), 1e-13);
    }
}

/* Infinitely long strips up to 30 and 60 degrees above the horizon, as on protractors 9
 * and 10. A strip of length 2e5 misses about 1e-10. */
static void strips_are_the_unglazed_protractors(void **state)
{
    (void)state;
    double d = 1.3, thirty = tan(30.0 * PP_RAD), sixty = tan(60.0 * PP_RAD);
    struct pp_moments low = upright(-1e5, 1e5, 0.0, d * thirty, d, zenith);
    struct pp_moments high = upright(-1e5, 1e5, 0.0, d * sixty, d, zenith);
    assert_near(uniform(low), 0.066987, 0.5e-6);
    assert_near(overcast(low), 0.04519, 0.5e-5);
    assert_near(uniform(high), 0.25, 0.5e-6);
    assert_near(overcast(high), 0.21886, 0.5e-5);
}

/* A vertical receiver in front of a continuous obstruction at the altitude alpha in
 * section. Ends at 1e6 times the distance miss a share of 1e-12. */
static void a_continuous_obstruction_leaves_the_vertical_sky_component(void **state)
{
    (void)state;
    struct pp_vec3 facing = {0.0, 1.0, 0.0};
    static const double printed[][2] = {{10, 35.35}, {20, 30.16}, {25, 27.31},
                                        {40, 18.33}, {60, 7.42},  {80, 0.87}};
    for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
        double alpha = printed[i][0] * PP_RAD;
        /* Half-space above the plane through the eye at that altitude. */
        struct pp_vec3 half_spaces[3] = {
            facing, zenith, {0.0, -sin(alpha), cos(alpha)}};
        const struct pp_vec3 wall[4] = {
            {-2e5, 0.3, -1e5}, {2e5, 0.3, -1e5}, {2e5, 0.3, 2e5}, {-2e5, 0.3, 2e5}};
        struct pp_moments m = {0};
        pp_solid_angle_add_moments(&m, wall, 4, facing, half_spaces, 3);
        double paper = 3.0 / 14.0 * (1.0 - sin(alpha))
                       + 4.0 / (7.0 * PP_PI) * cos(alpha) * cos(alpha);
        assert_near(overcast(m), paper, 1e-10);
        assert_near(overcast(m), printed[i][1] / 100.0, 0.5e-4);
        assert_near(uniform(m), 0.5 * (1.0 - sin(alpha)), 1e-10);
    }
}

/* Inverse square law for a small, distant window: area times both cosines divided by
 * the distance squared. The relative error is about the square of the angular size,
 * 1e-8. */
static void a_small_far_window_obeys_the_inverse_square_law(void **state)
{
    (void)state;
    double d = 1e4, sill = 5e3, size = 0.9;
    struct pp_moments m = upright(-size / 2, size / 2, sill, sill + size, d, zenith);
    double middle = sill + size / 2, r2 = d * d + middle * middle;
    double omega = size * size * d / (r2 * sqrt(r2));
    assert_relative(m.omega, omega, 1e-7);
    assert_relative(m.cosine, omega * middle / sqrt(r2), 1e-7);
    assert_relative(m.cosine_sine, omega * middle * middle / r2, 1e-7);
}

/* An outline and the same outline in the opposite sense cancel; a hole is such an
 * outline. */
static void a_hole_counts_negative(void **state)
{
    (void)state;
    struct pp_vec3 n = pp_vec_unit(pp_vec(0.3, 0.4, 0.7));
    const struct pp_vec3 ring[5] = {{-1.2, 2.0, 0.4},
                                    {1.9, 2.0, -0.6},
                                    {2.1, 2.0, 1.5},
                                    {0.2, 2.0, 0.3},
                                    {-0.9, 2.0, 1.8}};
    struct pp_vec3 back[5];
    for (int i = 0; i < 5; i++)
        back[i] = ring[4 - i];
    struct pp_vec3 half_spaces[2] = {n, zenith};
    struct pp_moments sum = {0};
    pp_solid_angle_add_moments(&sum, ring, 5, n, half_spaces, 2);
    assert_true(sum.cosine > 0.1);
    pp_solid_angle_add_moments(&sum, back, 5, n, half_spaces, 2);
    assert_near(sum.omega, 0.0, 1e-15);
    assert_near(sum.cosine, 0.0, 1e-15);
    assert_near(sum.cosine_sine, 0.0, 1e-15);
}

/* If a window is cut in two along any line, the parts add up to the window, even if the
 * cut passes directly above the point, along its horizon or through a corner. */
static void parts_of_a_window_add_up(void **state)
{
    (void)state;
    struct pp_vec3 n =
        pp_vec_unit(pp_vec(0.6, -0.5, 0.4)); /* its horizon cuts the window */
    struct pp_moments whole = upright(-1.4, 2.3, -0.7, 1.9, 0.8, n);
    static const double cuts[] = {-1.1, 0.0, 1e-9, 0.37, 2.2999999};
    for (size_t i = 0; i < sizeof cuts / sizeof cuts[0]; i++) {
        struct pp_moments a = upright(-1.4, cuts[i], -0.7, 1.9, 0.8, n);
        struct pp_moments b = upright(cuts[i], 2.3, -0.7, 1.9, 0.8, n);
        assert_near(a.cosine + b.cosine, whole.cosine, 1e-15);
        assert_near(a.cosine_sine + b.cosine_sine, whole.cosine_sine, 1e-15);
    }
    struct pp_moments up = upright(-1.4, 2.3, 0.0, 1.9, 0.8, n);
    assert_near(up.cosine, whole.cosine, 1e-15);
    assert_near(up.cosine_sine, whole.cosine_sine, 1e-15);
    struct pp_moments down = upright(-1.4, 2.3, -0.7, 0.0, 0.8, n);
    assert_near(down.omega, 0.0, 0.0);

    struct pp_moments roof = overhead(-1.3, 1.1, -0.8, 0.9, 1.7);
    struct pp_moments west = overhead(-1.3, 0.0, -0.8, 0.9, 1.7);
    struct pp_moments east = overhead(0.0, 1.1, -0.8, 0.9, 1.7);
    assert_relative(west.cosine_sine + east.cosine_sine, roof.cosine_sine, 1e-14);
    assert_relative(west.omega + east.omega, roof.omega, 1e-14);
}

/* A corner directly above the point and an edge through the zenith. */
static void a_corner_at_the_zenith_is_like_any_other(void **state)
{
    (void)state;
    struct pp_moments at = overhead(0.0, 1.4, 0.0, 0.9, 2.1);
    struct pp_moments beside = overhead(1e-12, 1.4, -1e-12, 0.9, 2.1);
    assert_near(at.cosine, beside.cosine, 1e-11);
    assert_near(at.cosine_sine, beside.cosine_sine, 1e-11);
    assert_near(at.omega, beside.omega, 1e-11);
}

/* A receiver near the plane of the window, beside the window, receives almost nothing
 * from it. A receiver just in front of the window that faces it receives nothing
 * else. */
static void near_its_plane_a_window_is_all_or_nothing(void **state)
{
    (void)state;
    struct pp_vec3 facing = {0.0, 1.0, 0.0};
    struct pp_moments beside = upright(0.4, 1.9, 0.3, 1.1, 1e-6, facing);
    assert_near(beside.omega, 0.0, 1e-5);
    assert_true(beside.omega > 0.0);
    struct pp_moments before = upright(-0.4, 1.9, -0.3, 1.1, 1e-6, facing);
    assert_near(overcast(before), 3.0 / 14.0 + 4.0 / (7.0 * PP_PI), 1e-10);
    assert_near(before.omega, PP_PI, 1e-5);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_endless_ceiling_shows_the_whole_sky),
        cmocka_unit_test(an_endless_wall_shows_half_the_sky),
        cmocka_unit_test(a_vertical_receiver_sees_the_vertical_sky_component),
        cmocka_unit_test(the_design_window_has_its_fourteen_digits),
        cmocka_unit_test(vertical_rectangles_agree_with_closed_forms),
        cmocka_unit_test(horizontal_rectangles_agree_with_closed_forms),
        cmocka_unit_test(strips_are_the_unglazed_protractors),
        cmocka_unit_test(a_continuous_obstruction_leaves_the_vertical_sky_component),
        cmocka_unit_test(a_small_far_window_obeys_the_inverse_square_law),
        cmocka_unit_test(a_hole_counts_negative),
        cmocka_unit_test(parts_of_a_window_add_up),
        cmocka_unit_test(a_corner_at_the_zenith_is_like_any_other),
        cmocka_unit_test(near_its_plane_a_window_is_all_or_nothing),
    };
    add_tests(tests, NULL, NULL);
}
