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

/* Values and targets are computed: a difference of this share is rounding. */
static const double rounding = 1e-9;

static int compare_falling(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

/* The probability that a point reaches the target; of a point that was not sampled 0 or
 * 1. */
static double probability_of_point(const struct pp_reading *point, double target)
{
    if (!(point->std_error > 0.0))
        return point->value >= target - rounding * fabs(target) ? 1.0 : 0.0;
    return pp_finding_probability_at_least(point->value, point->std_error, target);
}

/* Probability that `wanted` points or more reach the level. `odds` has space for count +
 * 1 numbers: odds[k] is the probability that k of the uncertain points taken so far reach
 * the level. */
static double probability_of(const struct pp_reading *points, int count, int wanted,
                             double level, double *odds)
{
    int uncertain = 0, sure = 0;
    odds[0] = 1.0;
    for (int i = 0; i < count; i++) {
        double p = probability_of_point(&points[i], level);
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

/* The level that `wanted` points reach with the given probability, by bisection between
 * a level that all points reach and one that none reaches: 8 standard errors off. */
static double level_of(const struct pp_reading *points, int count, int wanted,
                       double probability, double *odds)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < count; i++) {
        double spread = points[i].std_error > 0.0 ? 8.0 * points[i].std_error : 0.0;
        low = fmin(low, points[i].value - spread);
        high = fmax(high, points[i].value + spread);
    }
    for (int step = 0; step < 50; step++) {
        double middle = 0.5 * (low + high);
        if (probability_of(points, count, wanted, middle, odds) > probability)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

enum pp_status pp_plane_share(struct pp_plane_share *share,
                              const struct pp_reading *points, int count, double part,
                              double target, struct pp_error *err)
{
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
        share->probability = probability_of(points, count, wanted, target, values);
        share->std_error = 0.5
                           * (level_of(points, count, wanted, 0.1587, values)
                              - level_of(points, count, wanted, 0.8413, values));
    }
    free(values);
    return PP_OK;
}
