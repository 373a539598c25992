/* test_plane_share.c - the share of the plane that reaches a daylight factor, and its
 * probability. */
#include <stdlib.h>

#include "studies/criteria/finding.h"
#include "studies/criteria/grid/plane_share.h"
#include "tests/lib/near.h"

enum { MOST = 400 };

static struct pp_plane_share share_of(const struct pp_reading *points, int count,
                                      double part, double target)
{
    struct pp_plane_share share;
    assert_int_equal(
        pp_plane_share(&share, points, NULL, count, 0.0, part, target, NULL), PP_OK);
    return share;
}

static void computed_points_are_counted(void **state)
{
    (void)state;
    static const double values[] = {0.031, 0.007, 0.022, 0.014, 0.019, 0.0205, 0.009};
    struct pp_reading points[7];
    for (int i = 0; i < 7; i++)
        points[i] = pp_reading_of(values[i]);
    struct pp_plane_share half = share_of(points, 7, 0.5, 0.02);
    assert_near(half.level, 0.019, 0.0); /* 4 of 7 are half of them or more */
    assert_near(half.over, 3.0 / 7.0, 1e-15);
    assert_true(isnan(half.std_error) && isnan(half.probability));
    /* 95 % of 7 points requires all 7. */
    assert_near(share_of(points, 7, 0.95, 0.02).level, 0.007, 0.0);
    assert_near(share_of(points, 7, 1.0, 0.007).over, 1.0, 0.0);
    /* 95 % of 20 points requires 19, in spite of the rounding of 0.95 * 20. */
    struct pp_reading many[20];
    for (int i = 0; i < 20; i++)
        many[i] = pp_reading_of(0.001 * (i + 1));
    assert_near(share_of(many, 20, 0.95, 0.01).level, 0.002, 0.0);
}

/* By Python's statistics.median: [0.007, 0.014, 0.019, 0.022, 0.031, 0.009] has 0.0165. */
static void median_of_an_even_number_is_the_mean_of_the_middle_two(void **state)
{
    (void)state;
    static const double values[] = {0.031, 0.007, 0.022, 0.014, 0.019, 0.009};
    struct pp_reading points[6];
    for (int i = 0; i < 6; i++)
        points[i] = pp_reading_of(values[i]);
    assert_near(share_of(points, 6, 0.5, 0.02).level, 0.0165, 1e-17);
    assert_near(share_of(points, 2, 0.5, 0.02).level, 0.019, 1e-17);
    assert_near(share_of(points, 1, 0.5, 0.02).level, 0.031, 0.0);
}

static void one_point_is_as_sure_as_the_normal_distribution(void **state)
{
    (void)state;
    struct pp_reading point = {.value = 0.0213, .std_error = 0.0004};
    struct pp_plane_share share = share_of(&point, 1, 0.5, 0.0209);
    assert_near(share.probability, 0.8413447460685429, 1e-12);
    assert_near(share.level, 0.0213, 0.0);
    /* Phi(1) = 0.8413 and 0.1587 are one standard error away, to 2e-4 of it. */
    assert_relative(share.std_error, 0.0004, 1e-3);
}

/* Enumerates all 64 outcomes of six points. */
static void sums_of_unlike_tosses_are_what_enumeration_gives(void **state)
{
    (void)state;
    static const double values[] = {0.018, 0.0192, 0.0199, 0.0207, 0.0211, 0.0231};
    static const double errors[] = {0.0007, 0.0011, 0.0006, 0.0009, 0.0013, 0.0008};
    struct pp_reading points[6];
    double p[6];
    for (int i = 0; i < 6; i++) {
        points[i] = (struct pp_reading){.value = values[i], .std_error = errors[i]};
        p[i] = 0.5 * (1.0 - erf((0.02 - values[i]) / errors[i] / sqrt(2.0)));
    }
    for (int wanted = 1; wanted <= 6; wanted++) {
        double sum = 0.0;
        for (int ways = 0; ways < 64; ways++) {
            double odds = 1.0;
            int reach = 0;
            for (int i = 0; i < 6; i++) {
                reach += ways >> i & 1;
                odds *= ways >> i & 1 ? p[i] : 1.0 - p[i];
            }
            sum += reach >= wanted ? odds : 0.0;
        }
        /* Slightly above and below one half, the level is not the median. */
        double part = wanted == 3 ? 0.5 - 1e-6 : wanted / 6.0;
        assert_near(share_of(points, 6, part, 0.02).probability, sum, 1e-11);
    }
}

/* Enumerates the 16 outcomes of four points that represent 1, 2, 3 and 2 m2. */
static void sums_of_unlike_areas_are_what_enumeration_gives(void **state)
{
    (void)state;
    static const double values[] = {0.0192, 0.0199, 0.0207, 0.0231};
    static const double errors[] = {0.0011, 0.0006, 0.0009, 0.0028};
    static const double areas[] = {1.0, 2.0, 3.0, 2.0};
    static const double parts[] = {0.1, 0.3, 0.45, 0.6, 0.72, 0.8, 1.0};
    struct pp_reading points[4];
    struct pp_receiver receivers[4] = {0};
    double p[4];
    for (int i = 0; i < 4; i++) {
        points[i] = (struct pp_reading){.value = values[i], .std_error = errors[i]};
        receivers[i].area_m2 = areas[i];
        p[i] = 0.5 * (1.0 - erf((0.02 - values[i]) / errors[i] / sqrt(2.0)));
    }
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
        double sum = 0.0;
        for (int ways = 0; ways < 16; ways++) {
            double odds = 1.0, reach_m2 = 0.0;
            for (int i = 0; i < 4; i++) {
                reach_m2 += ways >> i & 1 ? areas[i] : 0.0;
                odds *= ways >> i & 1 ? p[i] : 1.0 - p[i];
            }
            sum += reach_m2 >= parts[k] * 8.0 ? odds : 0.0;
        }
        struct pp_plane_share share;
        assert_int_equal(
            pp_plane_share(&share, points, receivers, 4, 0.0, parts[k], 0.02, NULL),
            PP_OK);
        assert_near(share.probability, sum, 1e-11);
        assert_near(share.over, 5.0 / 8.0, 1e-15);
        /* In descending order the points reach 2, 5, 7 and 8 of the 8 m2. */
        assert_near(share.level,
                    parts[k] <= 0.25    ? 0.0231
                    : parts[k] <= 0.625 ? 0.0207
                    : parts[k] <= 0.875 ? 0.0199
                                        : 0.0192,
                    0.0);
    }
}

/* Uniform numbers by a congruential generator, which is sufficient here. */
static double uniform(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0 + 1.0 / 33554432.0;
}

static double normal(unsigned *state)
{
    double u = uniform(state), v = uniform(state);
    return sqrt(-2.0 * log(u)) * cos(2.0 * 3.14159265358979323846 * v);
}

/* `count` values, each 4 % higher than the last, with errors 2 % higher. */
static void make_rising(struct pp_reading *points, int count, double first,
                        double std_error)
{
    for (int i = 0; i < count; i++)
        points[i] = (struct pp_reading){.value = first * pow(1.04, i),
                                        .std_error = std_error * pow(1.02, i)};
}

static int in_order(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Draws random values about the readings. Compares the frequency of medians at or above
 * the target, and half the distance between those exceeded by 16 and 84 % of the draws.
 * For 20,000 draws four standard errors of a frequency are 1.4 %, and of that distance
 * 4 %. */
static void compare_with_draws(const struct pp_reading *points, int count,
                               double common, double target)
{
    enum { DRAWS = 20000 };
    static double medians[DRAWS];
    double hits = 0.0, values[MOST];
    unsigned seed = 7;
    for (int draw = 0; draw < DRAWS; draw++) {
        double shift = common > 0.0 ? sqrt(common) * normal(&seed) : 0.0;
        for (int i = 0; i < count; i++) {
            double value =
                points[i].value
                + points[i].std_error * (shift + sqrt(1.0 - common) * normal(&seed));
            int k = i;
            for (; k > 0 && values[k - 1] < value; k--)
                values[k] = values[k - 1];
            values[k] = value;
        }
        double median = 0.5 * (values[(count - 1) / 2] + values[count / 2]);
        hits += median >= target;
        medians[draw] = median;
    }
    qsort(medians, DRAWS, sizeof *medians, in_order);
    struct pp_plane_share share;
    assert_int_equal(
        pp_plane_share(&share, points, NULL, count, common, 0.5, target, NULL), PP_OK);
    assert_near(share.probability, hits / DRAWS, 0.014);
    double spread =
        0.5 * (medians[(int)(0.8413 * DRAWS)] - medians[(int)(0.1587 * DRAWS)]);
    assert_relative(share.std_error, spread, 0.04);
    assert_true(share.probability > 0.1 && share.probability < 0.9);
}

static void probability_and_error_are_what_drawing_gives(void **state)
{
    (void)state;
    struct pp_reading points[31];
    make_rising(points, 31, 0.012, 0.0007);
    compare_with_draws(points, 31, 0.0, 0.0214);
}

/* Cases in which the middle two values overlap, in which they are separate, with
 * different errors, and with partly common errors. */
static void median_of_an_even_number_is_as_sure_as_drawing_says(void **state)
{
    (void)state;
    struct pp_reading points[32];
    make_rising(points, 32, 0.012, 0.0007);
    compare_with_draws(points, 32, 0.0, 0.0220);
    compare_with_draws(points, 32, 0.3, 0.0225);
    make_rising(points, 12, 0.012, 0.00011);
    compare_with_draws(points, 12, 0.0, 0.0149);
    points[5].std_error = 0.0005;
    compare_with_draws(points, 12, 0.0, 0.0150);
    compare_with_draws(points, 12, 0.6, 0.0149);
    compare_with_draws(points, 2, 0.0, 0.01225);
}

static void points_without_an_error_are_sure(void **state)
{
    (void)state;
    struct pp_reading points[3] = {{.value = 0.01, .std_error = 0.0},
                                   {.value = 0.03, .std_error = 0.0},
                                   {.value = 0.02, .std_error = 0.001}};
    assert_near(share_of(points, 3, 1.0 / 3.0, 0.025).probability, 1.0, 0.0);
    assert_near(share_of(points, 3, 1.0, 0.015).probability, 0.0, 0.0);
    assert_near(share_of(points, 3, 2.0 / 3.0, 0.02).probability, 0.5, 1e-12);
}

static void many_points_are_quick_and_as_sure(void **state)
{
    (void)state;
    struct pp_reading points[MOST];
    for (int i = 0; i < MOST; i++)
        points[i] = (struct pp_reading){.value = 0.02, .std_error = 0.0003};
    /* Equal probabilities: 200 or more of 399. */
    assert_near(share_of(points, MOST - 1, 0.5, 0.02).probability, 0.5, 1e-9);
    /* The median of 400 is above or below with equal probability; its error is that of
     * 399. */
    struct pp_plane_share even = share_of(points, MOST, 0.5, 0.02);
    assert_near(even.probability, 0.5, 1e-3);
    assert_relative(even.std_error, share_of(points, MOST - 1, 0.5, 0.02).std_error,
                    0.01);
}

/* Probability that at least `wanted` points reach the target, by adding one point after
 * the other to the distribution of their number. */
static double reached_by(const struct pp_reading *points, int count, int wanted,
                         double target)
{
    double odds[MOST + 1] = {1.0}, sum = 0.0;
    for (int i = 0; i < count; i++) {
        double z = (target - points[i].value) / points[i].std_error;
        double p = 0.5 * erfc(z / sqrt(2.0));
        for (int k = i + 1; k > 0; k--)
            odds[k] = odds[k] * (1.0 - p) + odds[k - 1] * p;
        odds[0] *= 1.0 - p;
    }
    for (int k = wanted; k <= count; k++)
        sum += odds[k];
    return sum;
}

/* More points than are calculated without approximation, with different values and
 * errors. */
static void many_points_are_normal_to_two_thousandths(void **state)
{
    (void)state;
    struct pp_reading points[MOST];
    for (int i = 0; i < MOST; i++)
        points[i] = (struct pp_reading){.value = 0.019 + 5e-6 * i,
                                        .std_error = 0.0008 + 2e-6 * i};
    int count = MOST - 1;
    static const double targets[] = {0.0198, 0.0199, 0.02, 0.0201, 0.0202};
    for (int i = 0; i < 5; i++) {
        double exact = reached_by(points, count, (count + 1) / 2, targets[i]);
        assert_near(share_of(points, count, 0.5, targets[i]).probability, exact, 0.002);
        /* Above one half, the level of an even number of points is not the median. */
        exact = reached_by(points, MOST, 240, targets[i]);
        assert_near(share_of(points, MOST, 0.6, targets[i]).probability, exact, 0.002);
    }
}

static void verdicts_need_ninety_five_per_cent(void **state)
{
    (void)state;
    static const struct {
        double probability;
        enum pp_verdict verdict;
        double confidence;
    } cases[] = {{0.9999, PP_MET, 0.9999},     {0.951, PP_MET, 0.951},
                 {0.949, PP_UNDECIDED, 0.949}, {0.5, PP_UNDECIDED, 0.5},
                 {0.051, PP_UNDECIDED, 0.051}, {0.049, PP_NOT_MET, 0.951},
                 {0.0001, PP_NOT_MET, 0.9999}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_finding finding =
            pp_finding_of(PP_FIGURE_FACTOR, 0.021, 0.02, false, "test");
        assert_int_equal(finding.verdict, PP_MET);
        pp_finding_sampled(&finding, 0.001, cases[i].probability);
        assert_int_equal(finding.verdict, cases[i].verdict);
        assert_near(finding.confidence, cases[i].confidence, 1e-12);
    }
}

static void a_figure_nearer_than_its_error_decides_nothing(void **state)
{
    (void)state;
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_SHARE, 0.803, 0.8, false, "seen");
    pp_finding_within(&finding, 0.002);
    assert_int_equal(finding.verdict, PP_MET);
    pp_finding_within(&finding, 0.004);
    assert_int_equal(finding.verdict, PP_UNDECIDED);
    struct pp_finding stated =
        pp_finding_of(PP_FIGURE_AREA, 12.0, NAN, false, "%s", "area");
    pp_finding_within(&stated, 1e9);
    assert_int_equal(stated.verdict, PP_STATED);
}

/* Points whose errors are entirely in common act as one point: half of them reach a
 * target with the probability of the middle one, and the level has its error. */
static void points_that_go_wrong_together_are_as_one(void **state)
{
    (void)state;
    struct pp_reading points[101];
    for (int i = 0; i < 101; i++)
        points[i] = (struct pp_reading){.value = 0.02 + 1e-7 * i, .std_error = 0.0004};
    struct pp_plane_share alone, together;
    assert_int_equal(pp_plane_share(&alone, points, NULL, 101, 0.0, 0.5, 0.0198, NULL),
                     PP_OK);
    assert_int_equal(
        pp_plane_share(&together, points, NULL, 101, 1.0, 0.5, 0.0198, NULL), PP_OK);
    assert_true(alone.probability > 0.9999);
    /* Phi((0.020005 - 0.0198) / 0.0004) */
    assert_near(together.probability, 0.6958, 2e-3);
    assert_relative(together.std_error, 0.0004, 0.01);
    /* Median of 101 normal numbers: sqrt(pi/2)/sqrt(101) of the error of one. */
    assert_relative(alone.std_error, 0.1247 * 0.0004, 0.03);
}

/* Between these limits: the median of a hundred equal points with the share c of the
 * variance in common has the error sqrt(c + (1 - c) pi/2/100), in a normal
 * approximation. */
static void a_share_in_common_adds_to_the_levels_error(void **state)
{
    (void)state;
    struct pp_reading points[101];
    for (int i = 0; i < 101; i++)
        points[i] = (struct pp_reading){.value = 0.02, .std_error = 0.0004};
    for (int i = 1; i < 10; i += 2) {
        double c = 0.1 * i;
        struct pp_plane_share share;
        assert_int_equal(pp_plane_share(&share, points, NULL, 101, c, 0.5, 0.02, NULL),
                         PP_OK);
        assert_relative(share.std_error, 0.0004 * sqrt(c + (1.0 - c) * 0.1247 * 0.1247),
                        0.04);
        assert_near(share.probability, 0.5, 0.01);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(computed_points_are_counted),
        cmocka_unit_test(median_of_an_even_number_is_the_mean_of_the_middle_two),
        cmocka_unit_test(one_point_is_as_sure_as_the_normal_distribution),
        cmocka_unit_test(sums_of_unlike_areas_are_what_enumeration_gives),
        cmocka_unit_test(sums_of_unlike_tosses_are_what_enumeration_gives),
        cmocka_unit_test(probability_and_error_are_what_drawing_gives),
        cmocka_unit_test(median_of_an_even_number_is_as_sure_as_drawing_says),
        cmocka_unit_test(points_without_an_error_are_sure),
        cmocka_unit_test(many_points_are_quick_and_as_sure),
        cmocka_unit_test(many_points_are_normal_to_two_thousandths),
        cmocka_unit_test(verdicts_need_ninety_five_per_cent),
        cmocka_unit_test(a_figure_nearer_than_its_error_decides_nothing),
        cmocka_unit_test(points_that_go_wrong_together_are_as_one),
        cmocka_unit_test(a_share_in_common_adds_to_the_levels_error),
    };
    add_tests(tests, NULL, NULL);
}
