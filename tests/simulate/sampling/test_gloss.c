/* test_gloss.c - the Gaussian gloss: energy is conserved at any angle, the lobe is
 * reciprocal, and sampled directions follow the lobe. */
#include "simulate/sampling/gloss.h"

#include "simulate/sampling/hash.h"
#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

static double random_of(uint64_t seed, uint64_t part)
{
    return ((double)(pp_hash(seed, part) >> 11) + 0.5) * 0x1p-53;
}

static const double roughnesses[][2] = {
    {0.001, 0.001}, {0.05, 0.05}, {0.1, 0.1},  {0.2, 0.2},   {0.3, 0.3}, {0.5, 0.5},
    {1.0, 1.0},     {0.05, 0.2},  {0.4, 0.07}, {0.002, 0.9}, {0.6, 1.0}};
enum { ROUGHNESSES = sizeof roughnesses / sizeof *roughnesses };

static struct pp_gloss *gloss_of(double along, double across)
{
    static struct pp_gloss gloss;
    assert_int_equal(pp_gloss_init(&gloss, along, across, NULL), PP_OK);
    return &gloss;
}

/* Sums over directions sampled on a grid: all, weighted by x, by the square of y, and
 * all without the scales at the two ends. */
struct moments {
    double all, x, yy, unscaled;
};

static struct moments drawn(const struct pp_gloss *gloss, struct pp_vec3 i, int side)
{
    struct moments sum = {0.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < side * side; k++) {
        struct pp_vec3 o;
        double weight = pp_gloss_sample(gloss, i, (k / side + 0.5) / side,
                                        (k % side + 0.5) / side, &o)
                        / (side * side);
        if (!(weight > 0.0))
            continue;
        sum.all += weight;
        sum.x += weight * o.x;
        sum.yy += weight * o.y * o.y;
        sum.unscaled += weight / pp_gloss_scale(gloss, i) / pp_gloss_scale(gloss, o);
    }
    return sum;
}

/* Energy is conserved to the error of the table between its nodes: 0.3 %, half of it
 * from the grid of this test; 1 % if one roughness is hundreds of times the other. */
static void a_gloss_gives_back_all_that_it_gets_at_any_angle(void **state)
{
    (void)state;
    const double tilts[] = {0.0, 17.0, 40.0, 60.0, 75.0, 80.0, 85.0, 88.0, 89.5};
    const double azimuths[] = {0.0, 12.0, 37.0, 90.0, 241.0};
    for (int i = 0; i < ROUGHNESSES; i++) {
        bool isotropic = roughnesses[i][0] == roughnesses[i][1];
        double within = roughnesses[i][1] > 100.0 * roughnesses[i][0] ? 0.01 : 0.003;
        struct pp_gloss *gloss = gloss_of(roughnesses[i][0], roughnesses[i][1]);
        for (size_t t = 0; t < sizeof tilts / sizeof *tilts; t++)
            for (size_t a = 0; a < (isotropic ? 1 : 5); a++) {
                double albedo =
                    drawn(gloss, pp_test_towards(tilts[t], azimuths[a]), 160).all;
                if (!(fabs(albedo - 1.0) < within))
                    fail_msg("%g %g: %g at %g degrees, azimuth %g", gloss->along,
                             gloss->across, albedo, tilts[t], azimuths[a]);
            }
    }
}

/* Albedo of [GMD10] without the correction, calculated independently: in closed form
 * with error functions over the slopes of facets across the plane of incidence, and by
 * adaptive quadrature along it. At normal incidence and roughness a there is a closed
 * form: 1 - a^2 + a^2 exp(-1/a^2). */
static void unscaled_the_lobe_loses_what_facets_throw_down(void **state)
{
    (void)state;
    const double expected[4][5] = {{0.1, 0.990000, 0.973957, 0.867418, 0.812771},
                                   {0.2, 0.960000, 0.897580, 0.799414, 0.805507},
                                   {0.5, 0.754579, 0.708255, 0.765428, 0.825086},
                                   {1.0, 0.367879, 0.539652, 0.727539, 0.819147}};
    const double tilts[4] = {0.0, 60.0, 80.0, 85.0};
    for (int i = 0; i < 4; i++) {
        double a = expected[i][0];
        struct pp_gloss *gloss = gloss_of(a, a);
        assert_near(expected[i][1], 1.0 - a * a + a * a * exp(-1.0 / (a * a)), 1e-6);
        for (int t = 0; t < 4; t++)
            assert_near(drawn(gloss, pp_test_towards(tilts[t], 0.0), 200).unscaled,
                        expected[i][t + 1], 5e-4);
    }
}

/* The scale calculated independently: the lobe integrated over a grid of 160 cosines by
 * 512 azimuths. Both grids are accurate to 0.001. */
static void the_scale_is_that_of_another_discretisation(void **state)
{
    (void)state;
    const double expected[3][5] = {{0.2, 1.0198, 1.0227, 1.0535, 1.1437},
                                   {0.5, 1.1300, 1.1622, 1.2041, 1.1170},
                                   {1.0, 1.9234, 1.7149, 1.2819, 0.9592}};
    const double tilts[4] = {0.0, 30.0, 60.0, 80.0};
    for (int i = 0; i < 3; i++) {
        struct pp_gloss *gloss = gloss_of(expected[i][0], expected[i][0]);
        for (int t = 0; t < 4; t++)
            assert_relative(pp_gloss_scale(gloss, pp_test_towards(tilts[t], 33.0)),
                            expected[i][t + 1], 2e-3);
    }
}

/* Reciprocal except for rounding. */
static void light_may_run_either_way(void **state)
{
    (void)state;
    for (int i = 0; i < ROUGHNESSES; i++) {
        struct pp_gloss *gloss = gloss_of(roughnesses[i][0], roughnesses[i][1]);
        for (int k = 0; k < 40; k++) {
            double r[4];
            for (int j = 0; j < 4; j++)
                r[j] = random_of(7, (uint64_t)(4 * k + j));
            struct pp_vec3 a = pp_test_towards(89.9 * r[0], 360.0 * r[1]);
            struct pp_vec3 b = pp_test_towards(89.9 * r[2], 360.0 * r[3]);
            assert_relative(pp_gloss_value(gloss, a, b), pp_gloss_value(gloss, b, a),
                            1e-12);
        }
    }
}

/* Two ways to the same moments: sampled directions with their weights, the lobe times
 * the cosine divided by the density; and the lobe's value over the hemisphere
 * (midpoints, a quarter of a degree by half a degree). */
static void directions_are_drawn_as_the_lobe_is_shaped(void **state)
{
    (void)state;
    for (int i = 4; i < ROUGHNESSES; i++) {
        if (roughnesses[i][0] < 0.05)
            continue; /* too narrow for that grid */
        struct pp_gloss *gloss = gloss_of(roughnesses[i][0], roughnesses[i][1]);
        struct pp_vec3 from = pp_test_towards(50.0, 20.0);
        struct moments by_value = {0.0, 0.0, 0.0, 0.0};
        double step = PP_PI / 720.0;
        for (int t = 0; t < 360; t++)
            for (int a = 0; a < 720; a++) {
                double tilt = (t + 0.5) * step, azimuth = (a + 0.5) * 2.0 * step;
                struct pp_vec3 o = pp_test_towards(tilt / PP_RAD, azimuth / PP_RAD);
                double part = pp_gloss_value(gloss, from, o) * o.z * sin(tilt) * 2.0
                              * step * step;
                by_value.all += part;
                by_value.x += part * o.x;
                by_value.yy += part * o.y * o.y;
            }
        struct moments by_draw = drawn(gloss, from, 300);
        assert_near(by_draw.all, by_value.all, 2e-3);
        assert_near(by_draw.x, by_value.x, 2e-3);
        assert_near(by_draw.yy, by_value.yy, 2e-3);
    }
}

/* A brushed surface seen from above: light spreads across the brushing by the second
 * roughness, and hardly along it. The RMS of a slope a r cos is a / sqrt 2; the scale
 * hardly changes in this range. */
static void slopes_spread_by_the_roughness_of_their_direction(void **state)
{
    (void)state;
    struct pp_gloss *gloss = gloss_of(0.02, 0.2);
    double along = 0.0, across = 0.0;
    enum { COUNT = 20000 };
    for (int i = 0; i < COUNT; i++) {
        struct pp_vec3 o;
        pp_gloss_sample(gloss, pp_vec(0.0, 0.0, 1.0), random_of(13, (uint64_t)i),
                        random_of(17, (uint64_t)i), &o);
        double hz = o.z + 1.0;
        along += o.x * o.x / (hz * hz) / COUNT;
        across += o.y * o.y / (hz * hz) / COUNT;
    }
    assert_relative(sqrt(along), 0.02 / sqrt(2.0), 0.02);
    assert_relative(sqrt(across), 0.2 / sqrt(2.0), 0.02);
}

/* After a rotation by 90 degrees the two roughnesses are exchanged; if they are equal,
 * azimuth does not matter. */
static void roughnesses_go_with_their_axes(void **state)
{
    (void)state;
    static struct pp_gloss one, other;
    assert_int_equal(pp_gloss_init(&one, 0.07, 0.4, NULL), PP_OK);
    assert_int_equal(pp_gloss_init(&other, 0.4, 0.07, NULL), PP_OK);
    struct pp_vec3 i = pp_test_towards(63.0, 20.0), o = pp_test_towards(41.0, 190.0);
    struct pp_vec3 i_turned = pp_test_towards(63.0, 110.0),
                   o_turned = pp_test_towards(41.0, 280.0);
    /* The two tables were calculated for facets that are not rotated with them. */
    assert_relative(pp_gloss_value(&one, i, o),
                    pp_gloss_value(&other, i_turned, o_turned), 1e-3);
    struct pp_gloss *even = gloss_of(0.25, 0.25);
    assert_relative(pp_gloss_value(even, i, o),
                    pp_gloss_value(even, i_turned, o_turned), 1e-12);
}

/* For lobes that are wide enough for a quadrature over the hemisphere: the density
 * integrates to 1 less the share of samples that have no direction above the surface.
 * The weight of a sample is the lobe times the cosine, divided by the density. */
static void densities_are_those_of_the_directions_drawn(void **state)
{
    (void)state;
    const double rough[][2] = {{0.2, 0.2}, {0.5, 0.5}, {0.15, 0.4}};
    const double tilts[] = {0.0, 33.0, 71.0, 85.0};
    enum { SIDE = 1200, DRAWN = 60 };
    for (int r = 0; r < 3; r++)
        for (int t = 0; t < 4; t++) {
            struct pp_gloss *gloss = gloss_of(rough[r][0], rough[r][1]);
            struct pp_vec3 i = pp_test_towards(tilts[t], 29.0), o;
            double sum = 0.0, lost = 0.0;
            for (int k = 0; k < SIDE; k++)
                for (int m = 0; m < SIDE; m++) {
                    double tilt = (k + 0.5) / SIDE * 90.0, sine = sin(tilt * PP_RAD);
                    o = pp_test_towards(tilt, (m + 0.5) / SIDE * 360.0);
                    sum += pp_gloss_pdf(gloss, i, o) * sine * PP_PI / 2.0 / SIDE * 2.0
                           * PP_PI / SIDE;
                }
            for (int k = 0; k < DRAWN * DRAWN; k++) {
                double weight = pp_gloss_sample(gloss, i, (k / DRAWN + 0.5) / DRAWN,
                                                (k % DRAWN + 0.5) / DRAWN, &o);
                lost += (weight > 0.0 ? 0.0 : 1.0) / (DRAWN * DRAWN);
                if (weight > 0.0)
                    assert_relative(pp_gloss_pdf(gloss, i, o) * weight,
                                    pp_gloss_value(gloss, i, o) * o.z, 1e-6);
            }
            assert_near(sum, 1.0 - lost, 0.003);
        }
}

/* A surface that is rough in one direction only is not a mirror. */
static void a_gloss_is_a_mirror_where_both_roughnesses_vanish(void **state)
{
    (void)state;
    assert_true(pp_gloss_is_mirror(0.0, 0.0) && pp_gloss_is_mirror(0.0009, 0.0));
    assert_false(pp_gloss_is_mirror(0.001, 0.001) || pp_gloss_is_mirror(0.0, 0.1));
    struct pp_gloss *gloss = gloss_of(0.0, 0.1);
    assert_true(pp_gloss_is_of(gloss, 0.0, 0.1) && !pp_gloss_is_of(gloss, 0.1, 0.0));
    assert_near(drawn(gloss, pp_test_towards(30.0, 70.0), 128).all, 1.0, 0.003);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gloss_gives_back_all_that_it_gets_at_any_angle),
        cmocka_unit_test(unscaled_the_lobe_loses_what_facets_throw_down),
        cmocka_unit_test(the_scale_is_that_of_another_discretisation),
        cmocka_unit_test(light_may_run_either_way),
        cmocka_unit_test(directions_are_drawn_as_the_lobe_is_shaped),
        cmocka_unit_test(slopes_spread_by_the_roughness_of_their_direction),
        cmocka_unit_test(roughnesses_go_with_their_axes),
        cmocka_unit_test(densities_are_those_of_the_directions_drawn),
        cmocka_unit_test(a_gloss_is_a_mirror_where_both_roughnesses_vanish),
    };
    add_tests(tests, NULL, NULL);
}
