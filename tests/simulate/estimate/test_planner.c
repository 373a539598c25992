/* test_planner.c - values and standard errors of samplers with known expected
 * values. */
#include "simulate/estimate/planner.h"

#include <stdlib.h>
#include <string.h>

#include "simulate/sampling/hash.h"
#include "tests/lib/near.h"

/* Paths of a point return 1/chance with the probability `chance`, otherwise 0: the mean
 * is 1 for any chance above 0. chance = 0 is a point without light. Values are
 * multiplied by `scale`. */
struct rare {
    double chance[4], scale[4];
    uint64_t seed;
};

static void begin(const void *client, void *state)
{
    (void)client;
    *(int *)state = 0;
}

static uint64_t seed_of(const void *client, int point)
{
    const struct rare *rare = client;
    return pp_hash(rare->seed, (uint64_t)(1e6 * rare->scale[point]));
}

static void follow(const void *client, void *state, const struct pp_path_range *range,
                   struct pp_randomisation *randomisation)
{
    const struct rare *rare = client;
    double chance = rare->chance[range->point];
    (void)state;
    for (uint32_t i = range->first; i < range->end; i++) {
        /* Independent numbers: a low-discrepancy net would give nearly equal counts. */
        double u = (double)(pp_hash(range->sequence.seed, i) >> 11) * 0x1p-53;
        randomisation->sums[0] += u < chance ? 1.0 / chance : 0.0;
        randomisation->rays[0]++;
    }
}

static double value_of(const void *client, int point,
                       const struct pp_randomisation *randomisation, int value)
{
    (void)value;
    return ((const struct rare *)client)->scale[point] * randomisation->sums[0]
           / randomisation->done.of[0];
}

static double bound_of(const void *client, int point, int value, unsigned found,
                       const double *paths)
{
    (void)value;
    const struct rare *rare = client;
    double one = rare->scale[point] / fmax(rare->chance[point], 1e-3);
    return found ? 0.0 : one / paths[0];
}

static const struct pp_sampler sampler = {.estimators = 1,
                                          .values = 1,
                                          .fall = {1.0},
                                          .pilot = {{8}},
                                          .least = {{16}},
                                          .state_size = sizeof(int),
                                          .begin = begin,
                                          .seed = seed_of,
                                          .follow = follow,
                                          .value = value_of,
                                          .bound = bound_of};

static struct pp_reading read_first(const struct pp_planner *planner, int point)
{
    struct pp_reading readings[PP_VALUES_MOST];
    pp_planner_read(planner, point, readings);
    return readings[0];
}

static struct pp_reading first_of(const struct pp_sampled *sampled)
{
    struct pp_reading readings[PP_VALUES_MOST];
    pp_spread_readings(sampled, readings);
    return readings[0];
}

static void run(const struct rare *rare, int points, struct pp_planner_options options,
                double slice, struct pp_reading *readings)
{
    struct pp_planner *planner;
    assert_int_equal(
        pp_planner_create(&planner, &sampler, rare, points, &options, NULL), PP_OK);
    while (!pp_planner_done(planner))
        assert_int_equal(pp_planner_advance(planner, slice, NULL), PP_OK);
    assert_near(pp_planner_progress(planner), 1.0, 0.0);
    for (int i = 0; i < points; i++)
        readings[i] = read_first(planner, i);
    pp_planner_destroy(planner);
}

/* ---- worked by hand ---- */

/* Means 1, 2, 3 and 6 of four randomisations: mean 3, variance 14/3, standard error
 * sqrt(14/3 / 4 x 3/1) = sqrt(3.5). */
static void a_standard_error_is_students(void **state)
{
    (void)state;
    struct pp_randomisation four[4] = {{.sums = {2.0}, .done = {{2}}},
                                       {.sums = {2.0}, .done = {{1}}},
                                       {.sums = {9.0}, .done = {{3}}},
                                       {.sums = {6.0}, .done = {{1}}}};
    const struct rare one = {.scale = {1.0}};
    struct pp_sampled sampled = {&sampler, &one, 0, four, 4};
    struct pp_reading reading = first_of(&sampled);
    assert_near(reading.value, 3.0, 1e-15);
    assert_near(reading.std_error, sqrt(3.5), 1e-15);
    sampled.count = 3;
    assert_near(first_of(&sampled).value, 2.0, 1e-15);
    assert_true(isnan(first_of(&sampled).std_error));
}

/* Even randomisations 1, 2, 1, 2 (mean 1.5, variance 1/3), odd ones 3, 5, 4, 3, 5, 4
 * (mean 4, variance 4/5). The value is (1.5 + 4)/2, not the mean of all ten; its error
 * is half the square root of 1/3/4 x 3/1 + 4/5/6 x 5/3. */
static void halves_weigh_the_same_whatever_their_sizes(void **state)
{
    (void)state;
    static const double even[] = {1, 2, 1, 2}, odd[] = {3, 5, 4, 3, 5, 4};
    struct pp_randomisation twelve[12] = {0};
    for (int i = 0; i < 12; i++)
        if (i % 2 || i < 8)
            twelve[i] = (struct pp_randomisation){
                .sums = {i % 2 ? odd[i / 2] : even[i / 2]}, .done = {{1}}};
    const struct rare one = {.scale = {1.0}};
    struct pp_sampled sampled = {&sampler, &one, 0, twelve, 12};
    struct pp_reading reading = first_of(&sampled);
    assert_near(reading.value, 2.75, 1e-15);
    assert_near(reading.std_error, 0.5 * sqrt(0.25 + 2.0 / 9.0), 1e-15);
}

/* ---- over seeds ---- */

/* One path in 40 returns a value; target 5 %. The distribution is so skewed that a rule
 * that stops at the value's own error has a bias of 1 %. 1,500 seeds determine the mean
 * to 0.13 %, the frequencies to 1.2 and 0.6 %; the limits are three and four times
 * these. */
static void skewed_values_are_unbiased_and_their_errors_true(void **state)
{
    (void)state;
    enum { SEEDS = 1500 };
    double sum = 0.0;
    int within_1 = 0, within_2 = 0;
    for (int i = 0; i < SEEDS; i++) {
        struct rare rare = {{1.0 / 40.0}, {1.0}, (uint64_t)i};
        struct pp_reading reading;
        run(&rare, 1, (struct pp_planner_options){.error = 0.05, .threads = 1}, 1.0,
            &reading);
        assert_true(reading.std_error > 0.0 && reading.std_error < 0.09);
        double off = fabs(reading.value - 1.0) / reading.std_error;
        sum += reading.value / SEEDS;
        within_1 += off < 1.0;
        within_2 += off < 2.0;
    }
    print_message("# mean %.4f, %.1f %% and %.1f %% within\n", sum,
                  100.0 * within_1 / SEEDS, 100.0 * within_2 / SEEDS);
    assert_near(sum, 1.0, 0.0039);
    assert_in_range(1000 * within_1 / SEEDS, 640, 740);
    assert_in_range(1000 * within_2 / SEEDS, 930, 970);
}

/* One path in 500 finds light, and the target is 20 %: a pilot of 256 paths finds none,
 * or far too much. The pilot grows until it is sufficient. */
static void a_pilot_that_saw_nothing_grows(void **state)
{
    (void)state;
    enum { SEEDS = 400 };
    double sum = 0.0;
    int within_2 = 0;
    for (int i = 0; i < SEEDS; i++) {
        struct rare rare = {{1.0 / 500.0}, {1.0}, (uint64_t)i};
        struct pp_reading reading;
        run(&rare, 1,
            (struct pp_planner_options){
                .error = 0.01, .least_error = 0.2, .threads = 1},
            1.0, &reading);
        assert_true(reading.std_error > 0.0);
        sum += reading.value / SEEDS;
        within_2 += fabs(reading.value - 1.0) < 2.0 * reading.std_error;
    }
    print_message("# mean %.4f, %.1f %% within 2\n", sum, 100.0 * within_2 / SEEDS);
    assert_near(sum, 1.0, 4.0 * 0.22 / sqrt(SEEDS));
    assert_in_range(1000 * within_2 / SEEDS, 900, 980);
}

static void undetected_light_has_an_upper_limit(void **state)
{
    (void)state;
    struct rare rare = {{0.0}, {0.5}, 3};
    struct pp_reading reading;
    run(&rare, 1,
        (struct pp_planner_options){.error = 0.01, .least_error = 0.1, .threads = 1},
        1.0, &reading);
    assert_near(reading.value, 0.0, 0.0);
    assert_true(reading.std_error > 0.0 && reading.std_error <= 0.05);
}

/* ---- independence of values ---- */

static const struct rare four = {{0.3, 0.01, 0.001, 0.7}, {1.0, 2.0, 3.0, 4.0}, 5};

static void assert_same(const struct pp_reading *a, const struct pp_reading *b)
{
    assert_memory_equal(&a->value, &b->value, sizeof a->value);
    assert_memory_equal(&a->std_error, &b->std_error, sizeof a->std_error);
}

static void threads_and_slices_change_nothing(void **state)
{
    (void)state;
    struct pp_reading one[4], other[4];
    for (int by_samples = 0; by_samples < 2; by_samples++)
        for (int threads = 1; threads <= 4; threads *= 2) {
            struct pp_planner_options options = {.error = 0.05, .threads = threads};
            options.samples = by_samples ? 100 : 0;
            run(&four, 4, options, threads == 2 ? 0.0 : 1.0,
                threads == 1 ? one : other);
            for (int i = 0; threads > 1 && i < 4; i++)
                assert_same(&one[i], &other[i]);
        }
}

/* Other points may need larger pilots and more paths, but do not change this point. */
static void a_point_depends_on_no_other(void **state)
{
    (void)state;
    struct pp_planner_options options = {.error = 0.05, .threads = 1};
    struct pp_reading all[4], turned[4], alone;
    run(&four, 4, options, 1.0, all);
    struct rare reversed = four;
    for (int i = 0; i < 4; i++) {
        struct rare one = {{four.chance[i]}, {four.scale[i]}, four.seed};
        run(&one, 1, options, 1.0, &alone);
        assert_same(&all[i], &alone);
        reversed.chance[3 - i] = four.chance[i];
        reversed.scale[3 - i] = four.scale[i];
    }
    run(&reversed, 4, options, 1.0, turned);
    for (int i = 0; i < 4; i++)
        assert_same(&all[i], &turned[3 - i]);
}

static void a_restart_forgets_the_points(void **state)
{
    (void)state;
    struct rare rare = four;
    struct pp_planner *planner;
    const struct pp_planner_options options = {
        .samples = 64, .randomisations = 8, .threads = 1};
    struct pp_reading before[4], after;
    assert_int_equal(pp_planner_create(&planner, &sampler, &rare, 4, &options, NULL),
                     PP_OK);
    for (int round = 0; round < 2; round++) {
        assert_int_equal(pp_planner_advance(planner, 1e9, NULL), PP_OK);
        assert_true(pp_planner_done(planner));
        for (int i = 0; round == 0 && i < 4; i++)
            before[i] = read_first(planner, i);
        assert_int_equal(pp_planner_work(planner).paths, round ? 5 * 512 : 4 * 512);
        if (round == 0) {
            rare.chance[0] = four.chance[3];
            rare.scale[0] = four.scale[3];
            pp_planner_restart(planner, 1);
        }
    }
    after = read_first(planner, 0);
    assert_same(&before[3], &after);
    pp_planner_destroy(planner);
}

/* ---- data shared by points ---- */

/* The randomisations that are prepared, with the number of paths prepared in each, and
 * how often a range of paths was followed that was not prepared. */
struct ready {
    int stage, first, count, missed;
    uint32_t paths[128];
};

struct sharing {
    struct rare rare; /* must be first: the functions of the sampler use it */
    struct ready *ready;
};

static enum pp_status prepare(const void *client, int stage, int first, int count,
                              const struct pp_counts *wanted,
                              struct pp_thread_pool *pool, struct pp_error *err)
{
    struct ready *ready = ((const struct sharing *)client)->ready;
    (void)pool;
    (void)err;
    assert_in_range(count, 1, 128);
    if (stage != ready->stage || first != ready->first)
        memset(ready->paths, 0, sizeof ready->paths);
    ready->stage = stage;
    ready->first = first;
    ready->count = count;
    for (int i = 0; i < count; i++)
        if (wanted[i].of[0] > ready->paths[i])
            ready->paths[i] = wanted[i].of[0];
    return PP_OK;
}

static void follow_ready(const void *client, void *state,
                         const struct pp_path_range *range,
                         struct pp_randomisation *randomisation)
{
    struct ready *ready = ((const struct sharing *)client)->ready;
    int i = range->randomisation - ready->first;
    if (i < 0 || i >= ready->count || range->end > ready->paths[i])
        ready->missed++;
    follow(client, state, range, randomisation);
}

/* Half of the paths return 2: 1 % of the mean of 1 requires 1/0.01^2 paths, at most 32
 * in each randomisation. About 10,000/32 randomisations in several batches are
 * therefore needed; their shared data must be prepared in advance. */
static void what_points_share_is_ready_when_they_are_followed(void **state)
{
    (void)state;
    struct ready ready = {.stage = -1};
    const struct sharing sharing = {
        .rare = {.chance = {0.5, 0.9}, .scale = {1.0, 3.0}, .seed = 8},
        .ready = &ready};
    struct pp_sampler limited = sampler;
    limited.most = (struct pp_counts){{32}};
    limited.prepare = prepare;
    limited.follow = follow_ready;
    const struct pp_planner_options options = {.error = 0.01, .threads = 1};
    struct pp_planner *planner;
    assert_int_equal(pp_planner_create(&planner, &limited, &sharing, 2, &options, NULL),
                     PP_OK);
    while (!pp_planner_done(planner))
        assert_int_equal(pp_planner_advance(planner, 1.0, NULL), PP_OK);
    assert_int_equal(ready.missed, 0);
    struct pp_sampled sampled = pp_planner_sampled(planner, 0);
    assert_in_range(sampled.count, 200, 700);
    for (int i = 0; i < sampled.count; i++)
        assert_in_range(sampled.randomisations[i].done.of[0], 0, 32);
    struct pp_reading reading = read_first(planner, 0);
    assert_near(reading.std_error, 0.01, 0.0025);
    assert_near(reading.value, 1.0, 4.0 * reading.std_error);
    pp_planner_destroy(planner);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_standard_error_is_students),
        cmocka_unit_test(halves_weigh_the_same_whatever_their_sizes),
        cmocka_unit_test(skewed_values_are_unbiased_and_their_errors_true),
        cmocka_unit_test(a_pilot_that_saw_nothing_grows),
        cmocka_unit_test(undetected_light_has_an_upper_limit),
        cmocka_unit_test(threads_and_slices_change_nothing),
        cmocka_unit_test(a_point_depends_on_no_other),
        cmocka_unit_test(a_restart_forgets_the_points),
        cmocka_unit_test(what_points_share_is_ready_when_they_are_followed),
    };
    add_tests(tests, NULL, NULL);
}
