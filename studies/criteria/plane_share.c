/* plane_share.c - the Poisson binomial distribution of the number of points that reach a
 * level, and levels of given probability by bisection.
 */
#include "studies/criteria/plane_share.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "studies/criteria/finding.h"

/* A point whose probability is this near to 0 or 1 is taken as certain. */
static const double surely = 1e-12;

/* Beyond so many standard errors it is: normal_below(-7.04) = 0.96e-12. */
static const double surely_off = 7.04;

/* Values and targets are computed: a difference of this share is rounding. */
static const double rounding = 1e-9;

static int compare_falling(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

/* Points, the share of their variance that is common, and the root of the rest. */
struct plane_points {
    const struct pp_reading *list;
    int count;
    double common, own;
};

/* The probability that a point reaches the target, with all of them `shift` standard
 * errors off by what they have in common; of a point that was not sampled 0 or 1. */
static double probability_of_point(const struct plane_points *points, int i,
                                   double target, double shift)
{
    const struct pp_reading *point = &points->list[i];
    if (!(point->std_error > 0.0))
        return point->value >= target - rounding * fabs(target) ? 1.0 : 0.0;
    double value = point->value + shift * point->std_error;
    double std_error = points->own * point->std_error;
    if (fabs(value - target) > surely_off * std_error)
        return value > target ? 1.0 : 0.0;
    return pp_finding_probability_at_least(value, std_error, target);
}

/* Probability that `wanted` points or more reach the level, with such a shift. `odds` has
 * space for count + 1 numbers: odds[k] is the probability that k of the uncertain points
 * taken so far reach the level. */
static double probability_with(const struct plane_points *points, int wanted,
                               double level, double shift, double *odds)
{
    int uncertain = 0, sure = 0;
    odds[0] = 1.0;
    for (int i = 0; i < points->count; i++) {
        double p = probability_of_point(points, i, level, shift);
        if (p > 1.0 - surely) {
            sure++;
            continue;
        }
        if (p < surely)
            continue;
        odds[uncertain + 1] = 0.0;
        for (int k = ++uncertain; k > 0; k--)
            odds[k] = odds[k] * (1.0 - p) + odds[k - 1] * p;
        odds[0] *= 1.0 - p;
    }
    double sum = 0.0;
    for (int k = uncertain; k >= 0 && sure + k >= wanted; k--)
        sum += odds[k];
    return fmin(sum, 1.0);
}

/* Of a shift that is less than this the normal probability. */
static double normal_below(double z)
{
    return 0.5 * erfc(-z / sqrt(2.0));
}

/* Shifts of so many standard deviations, and no finer than this. */
static const double shift_most = 4.0, shift_least = 0.01;

/* A probability rises with the shift; where by more than this between two, they are
 * taken apart. */
static const double steep = 0.05;

struct shifted {
    double z, probability;
};

struct shifting {
    const struct plane_points *points;
    int wanted;
    double level;
    double *odds;
};

static struct shifted at_shift(const struct shifting *by, double z)
{
    double shift = sqrt(by->points->common) * z;
    return (struct shifted){
        z, probability_with(by->points, by->wanted, by->level, shift, by->odds)};
}

/* The part of the mean over all shifts that those between two have. */
static double mean_between(const struct shifting *by, struct shifted low,
                           struct shifted high)
{
    if (high.probability - low.probability > steep && high.z - low.z > shift_least) {
        struct shifted middle = at_shift(by, 0.5 * (low.z + high.z));
        return mean_between(by, low, middle) + mean_between(by, middle, high);
    }
    return 0.5 * (low.probability + high.probability)
           * (normal_below(high.z) - normal_below(low.z));
}

/* The same over all shifts, which are normal. */
static double probability_of(const struct plane_points *points, int wanted,
                             double level, double *odds)
{
    if (!(points->common > 0.0))
        return probability_with(points, wanted, level, 0.0, odds);
    const struct shifting by = {points, wanted, level, odds};
    struct shifted low = at_shift(&by, -shift_most), high = at_shift(&by, shift_most);
    double sum = low.probability * normal_below(low.z)
                 + high.probability * normal_below(-high.z);
    struct shifted middle = at_shift(&by, 0.0);
    return sum + mean_between(&by, low, middle) + mean_between(&by, middle, high);
}

/* The level that `wanted` points reach with the given probability, by bisection between
 * a level that all points reach and one that none reaches: 8 standard errors off. */
static double level_of(const struct plane_points *points, int wanted,
                       double probability, double *odds)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < points->count; i++) {
        const struct pp_reading *point = &points->list[i];
        double spread = point->std_error > 0.0 ? 8.0 * point->std_error : 0.0;
        low = fmin(low, point->value - spread);
        high = fmax(high, point->value + spread);
    }
    double enough = 1e-7 * (high - low);
    while (high - low > enough) {
        double middle = 0.5 * (low + high);
        if (probability_of(points, wanted, middle, odds) > probability)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

enum pp_status pp_plane_share(struct pp_plane_share *share,
                              const struct pp_reading *points, int count, double common,
                              double part, double target, struct pp_error *err)
{
    struct plane_points all = {.list = points, .count = count};
    all.common = fmin(common, 1.0 - 1e-9);
    all.own = sqrt(1.0 - all.common);
    double *values = malloc(((size_t)count + 1) * sizeof *values);
    if (!values)
        return pp_fail_memory(err);
    bool sampled = false;
    int over = 0, wanted = (int)fmax(ceil(part * count - rounding * count), 1.0);
    for (int i = 0; i < count; i++) {
        values[i] = points[i].value;
        sampled |= isfinite(points[i].std_error);
        over += points[i].value >= target - rounding * fabs(target);
    }
    qsort(values, (size_t)count, sizeof *values, compare_falling);
    *share = (struct pp_plane_share){.level = values[wanted - 1],
                                     .std_error = NAN,
                                     .over = (double)over / count,
                                     .probability = NAN};
    if (sampled) {
        share->probability = probability_of(&all, wanted, target, values);
        share->std_error = 0.5
                           * (level_of(&all, wanted, 0.1587, values)
                              - level_of(&all, wanted, 0.8413, values));
    }
    free(values);
    return PP_OK;
}
