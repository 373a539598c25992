/* test_left_over.c - the unexplained rest compared with independent noise: the scatter
 * of points on a grid about a smooth surface, or the stated noise. */
#include "studies/research/compare/left_over.h"
#include "tests/lib/near.h"

enum { POINTS = 20, TRIALS = 400 };

static void lay_out(struct pp_vec3 places[POINTS])
{
    for (int i = 0; i < POINTS; i++)
        places[i] = pp_vec(0.4 + 0.7 * (i % 4), 0.3 + 0.9 * (i / 4), 0.8); /* NOLINT */
}

/* Noise of variance 1 from a separate generator: a sum of twelve uniform numbers. */
static double draw(uint32_t *state)
{
    double sum = -6.0;
    for (int i = 0; i < 12; i++) {
        *state = *state * 1664525u + 1013904223u;
        sum += *state / 4294967296.0;
    }
    return sum;
}

static struct pp_left_over over_of(const double *left, int count, double known)
{
    struct pp_left_over over;
    struct pp_vec3 places[POINTS];
    lay_out(places);
    assert_int_equal(pp_left_over(&over, left, places, count, known, NULL), PP_OK);
    return over;
}

/* One case in twenty by the quantile of F; 3 % is three standard errors for 400
 * trials. */
static void noise_alone_exceeds_itself_in_one_case_of_twenty(void **state)
{
    (void)state;
    uint32_t seed = 7;
    int exceeds = 0;
    double noise = 0.0;
    for (int trial = 0; trial < TRIALS; trial++) {
        double left[POINTS];
        for (int i = 0; i < POINTS; i++)
            left[i] = 0.02 * draw(&seed);
        struct pp_left_over over = over_of(left, POINTS, 0.0);
        exceeds += pp_left_over_exceeds(&over);
        noise += over.noise / TRIALS;
    }
    assert_true(exceeds < TRIALS * (0.05 + 0.03));
    /* The mean of a standard deviation with 14 degrees of freedom is 2 % too low. */
    assert_near(noise, 0.02 * 0.982, 0.0008);
}

/* A mistake proportional to the square of the depth is reported completely, and not
 * treated as noise. */
static void a_smooth_mistake_is_left_and_does_not_pass_for_noise(void **state)
{
    (void)state;
    double left[POINTS], sum = 0.0;
    uint32_t seed = 3;
    for (int i = 0; i < POINTS; i++) {
        double depth = (i / 4) / 4.0; /* NOLINT */
        left[i] = -0.05 * depth * depth;
        sum += left[i] * left[i];
    }
    struct pp_left_over over = over_of(left, POINTS, 0.0);
    assert_near(over.noise, 0.0, 1e-9);
    assert_near(over.left, sqrt(sum / POINTS), 1e-9);
    for (int i = 0; i < POINTS; i++)
        left[i] += 0.005 * draw(&seed);
    over = over_of(left, POINTS, 0.0);
    assert_true(pp_left_over_exceeds(&over) && !pp_left_over_is_noise(&over));
    assert_near(over.noise, 0.005, 0.003);
}

static void stated_noise_replaces_the_scatter(void **state)
{
    (void)state;
    double left[POINTS];
    for (int i = 0; i < POINTS; i++)
        left[i] = 0.03;
    struct pp_left_over over = over_of(left, POINTS, 0.01);
    assert_near(over.left, 0.03, 1e-12);
    assert_true(pp_left_over_exceeds(&over));
    over = over_of(left, POINTS, 0.04);
    assert_true(pp_left_over_is_noise(&over));
    over = over_of(left, 3, 0.04);
    assert_true(pp_left_over_is_noise(&over));
}

/* Six points, or points at one position, cannot show the scatter over a room. */
static void few_points_do_not_tell_noise(void **state)
{
    (void)state;
    double left[POINTS] = {0.01, -0.02, 0.01, 0.02, 0.0, -0.01};
    struct pp_vec3 places[POINTS] = {{0.0, 0.0, 0.0}};
    struct pp_left_over over = over_of(left, 6, 0.0);
    assert_true(isnan(over.noise));
    assert_false(pp_left_over_exceeds(&over) || pp_left_over_is_noise(&over));
    assert_int_equal(pp_left_over(&over, left, places, POINTS, 0.0, NULL), PP_OK);
    assert_false(pp_left_over_is_noise(&over));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_alone_exceeds_itself_in_one_case_of_twenty),
        cmocka_unit_test(a_smooth_mistake_is_left_and_does_not_pass_for_noise),
        cmocka_unit_test(stated_noise_replaces_the_scatter),
        cmocka_unit_test(few_points_do_not_tell_noise),
    };
    add_tests(tests, NULL, NULL);
}
