/* test_band_tree.c - regimes and bands of generated rooms whose true bands are
 * known. */
#include "studies/bands/band_tree.h"

#include <stdlib.h>

#include "tests/lib/dice.h"
#include "tests/lib/near.h"

enum { ROOMS = 2000, POINTS = 4, FEATURES = 3, ROWS = ROOMS * POINTS };

/* Generated rooms; the rows (points) of a room share feature 0 and a part of the
 * error. */
struct made {
    int rooms[ROWS];
    double ratios[ROWS], features[ROWS * FEATURES];
    struct pp_band_sample sample;
};

static double normal(struct dice *dice)
{
    double u = between(dice, 0.0, 1.0), v = between(dice, 0.0, 1.0);
    return sqrt(-2.0 * log(1.0 - u)) * cos(2.0 * acos(-1.0) * v);
}

/* Where feature 0 is below 0.3, ratios are exp(0.05 z), otherwise 0.6 exp(0.3 z), with
 * z normal; features 1 and 2 have no influence. plain: exp(0.2 z) everywhere. */
static struct made *make(uint64_t seed, bool plain)
{
    struct made *made = malloc(sizeof *made);
    struct dice dice = {seed};
    assert_non_null(made);
    for (int room = 0; room < ROOMS; room++) {
        double first = between(&dice, 0.0, 1.0), z = normal(&dice);
        for (int p = 0; p < POINTS; p++) {
            int row = room * POINTS + p;
            double *features = made->features + row * FEATURES;
            features[0] = first;
            features[1] = between(&dice, 0.0, 1.0);
            features[2] = between(&dice, -3.0, 5.0);
            double own = 0.8 * z + 0.6 * normal(&dice);
            made->rooms[row] = room;
            made->ratios[row] = plain         ? exp(0.2 * own)
                                : first < 0.3 ? exp(0.05 * own)
                                              : 0.6 * exp(0.3 * own);
        }
    }
    made->sample = (struct pp_band_sample){ROWS, made->rooms, made->ratios, FEATURES,
                                           made->features};
    return made;
}

static const struct pp_band_regime all = {.condition_count = 0};

static struct pp_band_regime *grow(const struct made *made, int *count)
{
    struct pp_band_regime *regimes;
    assert_int_equal(pp_band_tree_grow(&regimes, count, &made->sample,
                                       &pp_band_tree_rules, &all, 1, NULL),
                     PP_OK);
    return regimes;
}

/* The 2.5 % point of the normal distribution is at 1.96. Its estimate from n = 600
 * rooms has a standard error of sqrt(0.025 * 0.975 / n) divided by the density there,
 * 0.0584: 0.11. */
static void two_kinds_of_rooms_are_separated_with_the_band_of_each(void **state)
{
    (void)state;
    struct made *made = make(41, false);
    int count;
    struct pp_band_regime *regimes = grow(made, &count);
    assert_int_equal(count, 2);
    assert_int_equal(regimes[0].condition_count, 1);
    assert_int_equal(regimes[0].conditions[0].feature, 0);
    assert_near(regimes[0].conditions[0].to, 0.3, 0.02);
    assert_int_equal(regimes[0].rooms + regimes[1].rooms, ROOMS);
    assert_near(log(regimes[0].ratio.low) / 0.05, -1.96, 4 * 0.11);
    assert_near(log(regimes[0].ratio.high) / 0.05, 1.96, 4 * 0.11);
    assert_near(log(regimes[1].ratio.low / 0.6) / 0.3, -1.96, 4 * 0.08);
    assert_near(log(regimes[1].ratio.median / 0.6) / 0.3, 0.0, 4 * 0.04);
    assert_near(log(regimes[1].ratio.high / 0.6) / 0.3, 1.96, 4 * 0.08);
    free(regimes);
    free(made);
}

static void rooms_that_err_alike_are_one_regime(void **state)
{
    (void)state;
    struct made *made = make(42, true);
    int count;
    struct pp_band_regime *regimes = grow(made, &count);
    assert_int_equal(count, 1);
    assert_int_equal(regimes[0].condition_count, 0);
    free(regimes);
    free(made);
}

/* Tolerance: three standard errors of the difference of two shares of 95 %, that of the
 * rooms tested and that of the rooms from which the band was made. */
static void a_band_holds_its_share_of_rooms_that_it_was_not_made_from(void **state)
{
    (void)state;
    struct made *fit = make(43, false), *test = make(44, false);
    int count, *rows = malloc(ROWS * sizeof *rows);
    struct pp_band_regime *regimes = grow(fit, &count);
    for (int i = 0; i < count; i++) {
        int found = pp_band_tree_rows(rows, &test->sample, &regimes[i]);
        int rooms = pp_band_sample_rooms(&test->sample, rows, found);
        double inside =
            pp_band_sample_inside(&test->sample, rows, found, &regimes[i].ratio, true);
        assert_near(inside, 0.95,
                    3.0 * sqrt(0.0475 * (1.0 / rooms + 1.0 / regimes[i].rooms)));
    }
    free(rows);
    free(regimes);
    free(test);
    free(fit);
}

static void no_regime_has_fewer_rooms_than_the_rule_says(void **state)
{
    (void)state;
    struct made *made = make(45, false);
    const struct pp_band_rules rules = {
        .rooms_least = 300, .regimes_most = 16, .gain_least = 0.0};
    struct pp_band_regime *regimes;
    int count, *rows = malloc(ROWS * sizeof *rows), found = 0;
    assert_int_equal(
        pp_band_tree_grow(&regimes, &count, &made->sample, &rules, &all, 1, NULL),
        PP_OK);
    assert_true(count > 4);
    for (int i = 0; i < count; i++) {
        assert_true(regimes[i].rooms >= 300);
        found += pp_band_tree_rows(rows, &made->sample, &regimes[i]);
    }
    assert_int_equal(found, ROWS); /* each row in one of them */
    free(rows);
    free(regimes);
    free(made);
}

/* The ranks 0.025 (n + 1) and 0.975 (n + 1) of n = 39 rooms are the first and the last.
 * A room of many points counts like a room with one point. */
static void a_room_counts_once_however_many_points_it_has(void **state)
{
    (void)state;
    enum { COUNT = 39 + 20 };
    int rooms[COUNT], rows[COUNT];
    double ratios[COUNT];
    for (int i = 0; i < COUNT; i++) {
        rows[i] = i;
        rooms[i] = i < 38 ? i : 38;
        ratios[i] = i < 38 ? 1.0 + 0.01 * i : 3.0;
    }
    struct pp_band_sample sample = {COUNT, rooms, ratios, 0, NULL};
    struct pp_band_quantiles band;
    assert_int_equal(pp_band_sample_rooms(&sample, rows, COUNT), 39);
    assert_int_equal(pp_band_sample_quantiles(&band, &sample, rows, COUNT, NULL),
                     PP_OK);
    assert_near(band.low, 1.0, 1e-12);
    assert_near(band.median, 1.19, 1e-12);
    assert_near(band.high, 3.0, 1e-12);
    struct pp_band_quantiles part = {.low = 1.0, .high = 2.0};
    assert_near(pp_band_sample_inside(&sample, rows, COUNT, &part, true), 38.0 / 39.0,
                1e-12);
    assert_near(pp_band_sample_inside(&sample, rows, COUNT, &part, false), 37.0 / 39.0,
                1e-12);
}

/* With the offset a = 0.02: (0.05 + 0.02) 0.5 - 0.02 = 0.015. The lower limit is never
 * negative. */
static void a_small_figure_has_a_band_of_so_much_more_or_less(void **state)
{
    (void)state;
    assert_near(pp_band_regime_truth(0.05, 0.5, 0.02), 0.015, 1e-15);
    assert_near(pp_band_regime_truth(0.0, 3.0, 0.02), 0.04, 1e-15);
    assert_near(pp_band_regime_truth(0.01, 0.5, 0.02), 0.0, 0.0);
    assert_near(pp_band_regime_ratio(0.015, 0.05, 0.02), 0.5, 1e-15);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_kinds_of_rooms_are_separated_with_the_band_of_each),
        cmocka_unit_test(rooms_that_err_alike_are_one_regime),
        cmocka_unit_test(a_band_holds_its_share_of_rooms_that_it_was_not_made_from),
        cmocka_unit_test(no_regime_has_fewer_rooms_than_the_rule_says),
        cmocka_unit_test(a_room_counts_once_however_many_points_it_has),
        cmocka_unit_test(a_small_figure_has_a_band_of_so_much_more_or_less),
    };
    add_tests(tests, NULL, NULL);
}
