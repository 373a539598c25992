/* test_sobol.c - scrambled Sobol points and directions about a normal. */
#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/lobe_run.h"
#include "simulate/sampling/sobol.h"

#include "tests/lib/near.h"

static struct pp_sobol sobol;

static int make_sobol(void **state)
{
    (void)state;
    pp_sobol_init(&sobol);
    return 0;
}

/* A (0, m, 2)-net has one point in each box of 2^-a by 2^-(m-a), for any a. */
static void assert_net(uint64_t seed, int vertex, uint32_t first, int m)
{
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, seed);
    for (int a = 0; a <= m; a++) {
        unsigned char hits[1 << 10] = {0};
        for (uint32_t i = 0; i < UINT32_C(1) << m; i++) {
            double u[2];
            pp_sobol_sequence_draw(&sequence, first + i, vertex, 2, u);
            int column = (int)(u[0] * (1 << a)), row = (int)(u[1] * (1 << (m - a)));
            hits[row << a | column]++;
        }
        for (int box = 0; box < 1 << m; box++)
            assert_int_equal(hits[box], 1);
    }
}

static void every_elementary_box_is_hit_once(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 20; seed++)
        for (int m = 0; m <= 10; m++)
            assert_net(pp_hash_mix64(seed), (int)seed, 0, m);
}

static void a_sum_is_extended_by_nets(void **state)
{
    (void)state;
    assert_net(7, 0, 64, 6);
    assert_net(7, 3, 384, 7);
    assert_net(11, 9, UINT32_C(3) << 20, 10);
}

/* In each of the six dimensions the points form a one-dimensional net. */
static void every_dimension_falls_once_into_each_interval(void **state)
{
    (void)state;
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, 2718);
    enum { N = 256 };
    int hits[PP_SOBOL_DIMENSIONS][N] = {{0}};
    for (uint32_t i = 0; i < N; i++) {
        double u[PP_SOBOL_DIMENSIONS];
        pp_sobol_sequence_draw(&sequence, i, 1, PP_SOBOL_DIMENSIONS, u);
        for (int k = 0; k < PP_SOBOL_DIMENSIONS; k++)
            hits[k][(int)(u[k] * N)]++;
    }
    for (int k = 0; k < PP_SOBOL_DIMENSIONS; k++)
        for (int i = 0; i < N; i++)
            assert_int_equal(hits[k][i], 1);
}

/* The first four direction numbers m of each dimension: printed in [JK08], the rest by
 * its recurrence by hand, such as 2 x 3 + 4 + 1 without carry, 3. The table stores m
 * with reversed digits, at the index of its highest binary digit. */
static void direction_numbers_are_the_printed_ones(void **state)
{
    (void)state;
    static const uint32_t m[PP_SOBOL_DIMENSIONS][4] = {{1, 1, 1, 1},  {1, 3, 5, 15},
                                                       {1, 3, 3, 9},  {1, 3, 1, 5},
                                                       {1, 1, 1, 11}, {1, 1, 3, 3}};
    for (int dimension = 0; dimension < PP_SOBOL_DIMENSIONS; dimension++)
        for (int k = 0; k < 4; k++) {
            /* Dimension 1 (van der Corput's) has only the digit k. */
            uint32_t turned = 0;
            for (int digit = 0; digit <= k; digit++)
                turned |= (m[dimension][k] >> digit & 1) << (k - digit);
            assert_int_equal(sobol.table[dimension][3][1 << (7 - k)], turned);
        }
}

/* Each point of a randomisation is uniform by itself: over seeds, point 5 fills the
 * square uniformly. Chi-square with 63 degrees of freedom exceeds 119 for one set of
 * seeds in 10^5. */
static void one_point_is_uniform_over_the_scrambles(void **state)
{
    (void)state;
    enum { SIDE = 8, N = 64000 };
    double hits[SIDE * SIDE] = {0}, chi2 = 0.0;
    for (uint64_t seed = 0; seed < N; seed++) {
        struct pp_sobol_sequence sequence;
        pp_sobol_sequence_init(&sequence, &sobol, pp_hash(99, seed));
        double u[2];
        pp_sobol_sequence_draw(&sequence, 5, 2, 2, u);
        hits[(int)(u[0] * SIDE) * SIDE + (int)(u[1] * SIDE)]++;
    }
    double expected = (double)N / (SIDE * SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        chi2 += (hits[i] - expected) * (hits[i] - expected) / expected;
    assert_true(chi2 < 119.0);
}

/* The mean of x y over vertex 0 and each of the next eight is 1/4 if they are
 * independent; the standard deviation of the mean of 2^16 independent products is 0.22
 * / 2^8. */
static void vertices_of_a_path_do_not_follow_each_other(void **state)
{
    (void)state;
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, 31415);
    for (int vertex = 1; vertex < 9; vertex++) {
        double sum = 0.0;
        for (uint32_t i = 0; i < 1 << 16; i++) {
            double a[1], b[1];
            pp_sobol_sequence_draw(&sequence, i, 0, 1, a);
            pp_sobol_sequence_draw(&sequence, i, vertex, 1, b);
            sum += a[0] * b[0];
        }
        assert_near(sum / (1 << 16), 0.25, 4.0 * 0.22 / 256.0);
    }
}

/* Owen scrambling keeps shared leading digits equal and separates the following
 * digits. */
static void digits_depend_only_on_the_digits_before_them(void **state)
{
    (void)state;
    for (uint32_t trial = 0; trial < 1000; trial++) {
        uint32_t x = pp_hash_mix32(trial + 1), seed = pp_hash_mix32(trial + 7777);
        int digit = (int)(trial % 32);
        uint32_t y = x ^ UINT32_C(1) << digit;
        uint32_t differ = pp_sobol_owen_scramble_reversed(x, seed)
                          ^ pp_sobol_owen_scramble_reversed(y, seed);
        assert_int_equal(differ & ((UINT64_C(1) << digit) - 1), 0);
        assert_true(differ >> digit & 1);
    }
}

/* Vertices with stored seeds and others, in all dimensions. */
static void a_run_has_the_points_of_the_sequence(void **state)
{
    (void)state;
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, 161803);
    for (uint32_t trial = 0; trial < 2000; trial++) {
        int count = 1 << trial % 5, vertex = (int)(trial % 29);
        int dimensions = 1 + (int)(trial % PP_SOBOL_DIMENSIONS);
        uint32_t first = trial < 40
                             ? trial * (uint32_t)count
                             : pp_hash_mix32(trial) / (uint32_t)count * (uint32_t)count;
        double run[PP_SOBOL_DIMENSIONS][PP_RUN_MOST], u[PP_SOBOL_DIMENSIONS];
        pp_sobol_sequence_draw_run(&sequence, first, count, vertex, dimensions, run);
        for (int i = 0; i < count; i++) {
            pp_sobol_sequence_draw(&sequence, first + (uint32_t)i, vertex, dimensions,
                                   u);
            for (int k = 0; k < dimensions; k++)
                assert_true(run[k][i] == u[k]);
        }
    }
}

/* The directions include the centre of the square, where the map divides zero by zero,
 * its diagonals and its edge. */
static void a_run_of_the_lobe_has_its_directions(void **state)
{
    (void)state;
    static const double apart[] = {0.5, 0.25, 0.75, 0x1p-33, 1.0 - 0x1p-33, 0.3};
    uint64_t series = 3;
    for (int trial = 0; trial < 2000; trial++) {
        double u[2][PP_RUN_MOST];
        int count = 1 + trial % PP_RUN_MOST;
        for (int i = 0; i < PP_RUN_MOST; i++)
            for (int k = 0; k < 2; k++) {
                series = pp_hash_mix64(series);
                u[k][i] = trial % 3 == 0 ? apart[series % 6]
                                         : ((double)(series >> 32) + 0.5) * 0x1p-32;
            }
        struct pp_frame frame = {
            .z = pp_vec_unit(pp_vec(sin(trial), cos(3.0 * trial), sin(2.0 * trial)))};
        pp_lobe_frame(frame.z, &frame.x, &frame.y);
        struct pp_lanes_directions to;
        pp_lobe_run(&frame, u, count, &to);
        for (int i = 0; i < count; i++) {
            struct pp_vec3 one =
                pp_lobe_sample_in_frame(frame.x, frame.y, frame.z, u[0][i], u[1][i]);
            assert_true(to.x[i] == one.x && to.y[i] == one.y && to.z[i] == one.z);
        }
    }
}

static void small_sine_and_cosine_are_the_library_s(void **state)
{
    (void)state;
    for (int i = -1000; i <= 1000; i++) {
        double x = PP_PI / 4.0 * i / 1000.0, sine, cosine;
        pp_lobe_small_sincos(x, &sine, &cosine);
        assert_near(sine, sin(x), 3e-14);
        assert_near(cosine, cos(x), 3e-14);
    }
}

/* Moments of the cosine lobe about an arbitrary normal: mean cosine 2/3, mean square
 * 1/2, zero sideways. A net of 2^14 points gives 1e-4. */
static void lobe_is_cosine_weighted_about_its_normal(void **state)
{
    (void)state;
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &sobol, 5);
    struct pp_vec3 n = pp_vec_unit(pp_vec(0.3, -0.5, -0.9)), a, b;
    pp_lobe_frame(n, &a, &b);
    assert_near(pp_vec_dot(pp_vec_cross(a, b), n), 1.0, 1e-15);
    double mean = 0.0, square = 0.0, aside = 0.0, askew = 0.0;
    enum { N = 1 << 14 };
    for (uint32_t i = 0; i < N; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        struct pp_vec3 d = pp_lobe_sample_in_frame(a, b, n, u[0], u[1]);
        assert_near(pp_vec_length(d), 1.0, 1e-12);
        double c = pp_vec_dot(d, n);
        mean += c / N;
        square += c * c / N;
        aside += pp_vec_dot(d, a) / N;
        askew += pp_vec_dot(d, a) * pp_vec_dot(d, b) / N;
    }
    assert_near(mean, 2.0 / 3.0, 1e-4);
    assert_near(square, 0.5, 1e-4);
    assert_near(aside, 0.0, 1e-4);
    assert_near(askew, 0.0, 1e-4);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_elementary_box_is_hit_once),
        cmocka_unit_test(a_sum_is_extended_by_nets),
        cmocka_unit_test(every_dimension_falls_once_into_each_interval),
        cmocka_unit_test(direction_numbers_are_the_printed_ones),
        cmocka_unit_test(one_point_is_uniform_over_the_scrambles),
        cmocka_unit_test(vertices_of_a_path_do_not_follow_each_other),
        cmocka_unit_test(digits_depend_only_on_the_digits_before_them),
        cmocka_unit_test(a_run_has_the_points_of_the_sequence),
        cmocka_unit_test(a_run_of_the_lobe_has_its_directions),
        cmocka_unit_test(small_sine_and_cosine_are_the_library_s),
        cmocka_unit_test(lobe_is_cosine_weighted_about_its_normal),
    };
    add_tests(tests, make_sobol, NULL);
}
