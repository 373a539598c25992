/* test_cause_search.c - the search for causes with made-up effects: patterns over
 * points that are not simulated. */
#include "studies/research/compare/cause_search.h"
#include "studies/research/compare/cause_shares.h"
#include "tests/lib/near.h"

enum { POINTS = 20, CAUSES = 6, FLAT = 3, FACTOR = 4, FITTED = 5 };

/* Two causes of one kind; one that increases with depth; one that is the same
 * everywhere; a common factor; and one that increases with its value and is largest in
 * the middle. */
static const struct pp_cause listed[CAUSES] = {
    {"cut=1", "cut", "", "", false, false, NULL},
    {"cut=2", "cut", "", "", false, false, NULL},
    {"deep=1", "deep", "", "", false, false, NULL},
    {"flat=1", "flat", "", "", false, false, NULL},
    {"factor", "factor", "", "", true, false, NULL},
    {"ground", "ground", "", "", false, false, NULL}};

/* Effect of a pair beyond the sum of its effects, relative to the smaller effect at
 * each point. */
static const double TOGETHER = 0.5;

static double fitted(double value, int point)
{
    double across = (point % 4 - 1.5) / 1.5; /* NOLINT */
    return log(0.8 + value * (1.0 - 0.5 * across * across));
}

static double alone(int cause, double value, int point)
{
    if (cause == FITTED)
        return fitted(value, point);
    double depth = point / (POINTS - 1.0);
    return cause == 0   ? -0.6 * depth
           : cause == 1 ? -0.3 * depth
           : cause == 2 ? 0.25 * depth * depth + 0.05
                        : -0.08;
}

static enum pp_status trace(void *traced, const int *causes, int count, double value,
                            double *effect, double *variance, struct pp_error *err)
{
    (void)err;
    *(int *)traced += count > 1;
    for (int i = 0; i < POINTS; i++) {
        effect[i] = 0.0;
        variance[i] = 0.003 * 0.003;
        for (int k = 0; k < count; k++) {
            effect[i] += alone(causes[k], value, i);
            for (int m = 0; m < k; m++)
                effect[i] += TOGETHER
                             * fmin(fabs(alone(causes[k], value, i)),
                                    fabs(alone(causes[m], value, i)));
        }
    }
    return PP_OK;
}

/* Noise with a standard deviation of 0.9, without a spatial pattern, always the same
 * numbers. */
static double noise(int i)
{
    static const double even[] = {0.3,  -1.2, 0.9,  0.1, -0.4, 1.4,  -0.8,
                                  -0.1, 0.6,  -1.6, 1.1, 0.2,  -0.6, 0.7,
                                  -1.0, 1.7,  -0.3, 0.5, -0.9, 0.0};
    return even[i];
}

static struct pp_cause_search search_within(const double *gap, int most, int *traced)
{
    struct pp_vec3 places[POINTS];
    const struct pp_cause *list[CAUSES];
    struct pp_cause_search search;
    struct pp_error err = {0};
    for (int i = 0; i < POINTS; i++)
        places[i] = pp_vec(0.7 * (i % 4), 0.7 * (i / 4), 0.8); /* NOLINT */
    for (int i = 0; i < CAUSES; i++)
        list[i] = &listed[i];
    *traced = 0;
    const struct pp_cause_search_question question = {.data = {POINTS, gap, places},
                                                      .causes = list,
                                                      .cause_count = CAUSES,
                                                      .trace = trace,
                                                      .tracer = traced,
                                                      .traced_most = most};
    if (pp_cause_search_find(&search, &question, &err) != PP_OK)
        fail_msg("%s", err.message);
    return search;
}

static struct pp_cause_search search_of(const double *gap, int *traced)
{
    return search_within(gap, 40, traced);
}

static void assert_named(const double *gap, const int *causes, int count)
{
    int traced;
    struct pp_cause_search search = search_of(gap, &traced);
    assert_true(search.count > 0);
    assert_int_equal(search.sets[0].count, count);
    for (int i = 0; i < count; i++)
        assert_int_equal(search.sets[0].causes[i], causes[i]);
    assert_true(search.sets[0].probability > 0.5);
    pp_cause_search_clear(&search);
}

static void noise_alone_has_no_cause(void **state)
{
    (void)state;
    double gap[POINTS];
    for (int i = 0; i < POINTS; i++)
        gap[i] = 0.02 * noise(i);
    assert_named(gap, NULL, 0);
}

static void one_cause_is_named_and_its_level(void **state)
{
    (void)state;
    double gap[POINTS];
    for (int cause = 0; cause < FLAT; cause++) {
        for (int i = 0; i < POINTS; i++)
            gap[i] = alone(cause, 0.0, i) + 0.02 * noise(i);
        assert_named(gap, &cause, 1);
    }
}

/* Two causes whose common effect is not the sum of the single effects. */
static void two_causes_that_interact_are_named(void **state)
{
    (void)state;
    static const int pair[] = {1, 2};
    double gap[POINTS], variance[POINTS];
    int traced = 0;
    trace(&traced, pair, 2, 0.0, gap, variance, NULL);
    for (int i = 0; i < POINTS; i++)
        gap[i] += 0.01 * noise(i);
    assert_named(gap, pair, 2);
}

/* A pair is only identified when it is simulated together. If no more simulations are
 * allowed, the result reports this and judges the variants simulated. */
static void causes_not_simulated_are_not_named(void **state)
{
    (void)state;
    static const int pair[] = {1, 2};
    double gap[POINTS], variance[POINTS], sum = 0.0;
    int traced = 0;
    trace(&traced, pair, 2, 0.0, gap, variance, NULL);
    struct pp_cause_search search = search_within(gap, 0, &traced);
    assert_int_equal(traced, 0);
    assert_true(search.is_cut);
    for (int i = 0; i < search.count; i++) {
        const struct pp_cause_set *set = &search.sets[i];
        sum += set->probability;
        assert_true(set->count < 2 || set->causes[1] == FACTOR);
    }
    assert_near(sum, 1.0, 0.02);
    pp_cause_search_clear(&search);
}

/* Values within three standard errors: noise of 1 % at 20 points for a slope of 1. */
static void a_value_between_those_that_are_traced_is_found(void **state)
{
    (void)state;
    static const int cause = FITTED;
    static const double values[] = {0.03, 0.37, 0.61};
    for (int k = 0; k < 3; k++) {
        double gap[POINTS];
        int traced;
        for (int i = 0; i < POINTS; i++)
            gap[i] = fitted(values[k], i) + 0.01 * noise(i);
        assert_named(gap, &cause, 1);
        struct pp_cause_search search = search_of(gap, &traced);
        assert_near(search.sets[0].value, values[k], 3.0 * 0.01 / sqrt(POINTS));
        pp_cause_search_clear(&search);
    }
}

/* Without the first cut, the second cut is the closest set; the gap is twice its
 * effect. */
static void the_nearest_set_without_a_cause_is_known(void **state)
{
    (void)state;
    double gap[POINTS];
    int traced;
    for (int i = 0; i < POINTS; i++)
        gap[i] = alone(0, 0.0, i);
    struct pp_cause_search search = search_of(gap, &traced);
    assert_int_equal(search.sets[0].causes[0], 0);
    assert_true(search.without[0] > 0.05 && search.without[0] < 0.3);
    assert_near(search.without[1], 0.0, 1e-9);
    pp_cause_search_clear(&search);
}

static void a_factor_of_any_size_is_found(void **state)
{
    (void)state;
    static const int factor = FACTOR;
    static const double logarithms[] = {-0.7, -0.11, 0.06, 0.4};
    for (int k = 0; k < 4; k++) {
        double gap[POINTS];
        int traced;
        for (int i = 0; i < POINTS; i++)
            gap[i] = logarithms[k] + 0.01 * noise(i);
        assert_named(gap, &factor, 1);
        struct pp_cause_search search = search_of(gap, &traced);
        /* Within three standard errors of a mean of 20 points. */
        assert_near(search.sets[0].likelihood.theta, logarithms[k],
                    3.0 * 0.015 / sqrt(POINTS));
        pp_cause_search_clear(&search);
    }
}

/* A cause with exactly this value is more likely than a factor that happens to have it;
 * both are reported. */
static void what_looks_alike_is_listed_together(void **state)
{
    (void)state;
    double gap[POINTS];
    int traced;
    for (int i = 0; i < POINTS; i++)
        gap[i] = alone(FLAT, 0.0, i) + 0.02 * noise(i);
    struct pp_cause_search search = search_of(gap, &traced);
    assert_int_equal(search.sets[0].causes[0], FLAT);
    assert_true(search.probability[FLAT] > 0.6 && search.probability[FACTOR] > 0.01);
    assert_true(search.probability[FLAT] + search.probability[FACTOR] > 0.95);
    pp_cause_search_clear(&search);
}

static void levels_of_a_kind_exclude_each_other(void **state)
{
    (void)state;
    double gap[POINTS];
    int traced;
    for (int i = 0; i < POINTS; i++)
        gap[i] = alone(0, 0.0, i) + alone(1, 0.0, i);
    struct pp_cause_search search = search_of(gap, &traced);
    for (int i = 0; i < search.count; i++)
        for (int k = 1; k < search.sets[i].count; k++)
            assert_false(search.sets[i].causes[k - 1] == 0
                         && search.sets[i].causes[k] == 1);
    pp_cause_search_clear(&search);
}

static void noise_is_recognised_by_size_and_correlation_of_neighbours(void **state)
{
    (void)state;
    double rays[POINTS], cache[POINTS];
    int traced;
    for (int i = 0; i < POINTS; i++) {
        rays[i] = 0.03 * noise(i);
        cache[i] = 0.05 * sin(0.9 * (i / 4) + 1.5 * (i % 4)); /* NOLINT */
    }
    struct pp_cause_search of_rays = search_of(rays, &traced);
    struct pp_cause_search of_cache = search_of(cache, &traced);
    assert_near(of_rays.sets[0].likelihood.sigma, 0.03, 0.012);
    assert_true(of_rays.sets[0].likelihood.near < 0.5);
    assert_true(of_cache.sets[0].likelihood.near > 0.9);
    pp_cause_search_clear(&of_rays);
    pp_cause_search_clear(&of_cache);
}

static void probabilities_are_of_one_whole(void **state)
{
    (void)state;
    double gap[POINTS], sum = 0.0;
    int traced;
    for (int i = 0; i < POINTS; i++)
        gap[i] = alone(2, 0.0, i) - 0.03 + 0.02 * noise(i);
    struct pp_cause_search search = search_of(gap, &traced);
    for (int i = 0; i < search.count; i++) {
        sum += search.sets[i].probability;
        assert_true(i == 0
                    || search.sets[i].probability <= search.sets[i - 1].probability);
    }
    /* About thirty sets with a probability below a thousandth are omitted. */
    assert_true(sum > 0.97 && sum < 1.0 + 1e-9);
    pp_cause_search_clear(&search);
}

/* Three players own gloves, two of them left ones: a pair is worth 1. The Shapley
 * values are 1/6, 1/6 and 4/6. */
static void shares_are_averages_over_orders(void **state)
{
    (void)state;
    double shares[3];
    static const double worth[8] = {0, 0, 0, 0, 0, 1, 1, 1};
    pp_cause_shares(shares, worth, 3);
    assert_near(shares[0], 1.0 / 6.0, 1e-15);
    assert_near(shares[1], 1.0 / 6.0, 1e-15);
    assert_near(shares[2], 4.0 / 6.0, 1e-15);
}

static void shares_sum_up_to_what_all_do(void **state)
{
    (void)state;
    double shares[3];
    static const double done[8] = {0.1, 0.37, -0.2, 0.9, 1.3, 0.4, 0.77, 2.1};
    pp_cause_shares(shares, done, 3);
    assert_near(shares[0] + shares[1] + shares[2], 2.0, 1e-14);
    pp_cause_shares(shares, done, 1);
    assert_near(shares[0], 0.27, 1e-15);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_alone_has_no_cause),
        cmocka_unit_test(one_cause_is_named_and_its_level),
        cmocka_unit_test(two_causes_that_interact_are_named),
        cmocka_unit_test(causes_not_simulated_are_not_named),
        cmocka_unit_test(a_factor_of_any_size_is_found),
        cmocka_unit_test(a_value_between_those_that_are_traced_is_found),
        cmocka_unit_test(the_nearest_set_without_a_cause_is_known),
        cmocka_unit_test(what_looks_alike_is_listed_together),
        cmocka_unit_test(levels_of_a_kind_exclude_each_other),
        cmocka_unit_test(noise_is_recognised_by_size_and_correlation_of_neighbours),
        cmocka_unit_test(probabilities_are_of_one_whole),
        cmocka_unit_test(shares_are_averages_over_orders),
        cmocka_unit_test(shares_sum_up_to_what_all_do),
    };
    add_tests(tests, NULL, NULL);
}
