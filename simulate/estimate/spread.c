/* spread.c - means, variances and standard errors over randomisations. */
#include "simulate/estimate/spread.h"

#include <math.h>

/* Values with a smaller relative difference count as equal (rounding errors). */
static const double ROUNDING = 1e-14;

static bool is_begun(const struct pp_sampler *sampler,
                     const struct pp_randomisation *randomisation)
{
    for (int k = 0; k < sampler->estimators; k++)
        if (randomisation->done.of[k] == 0)
            return false;
    return true;
}

static double figure(const struct pp_sampled *sampled, int i, int value, int estimator)
{
    const struct pp_sampler *sampler = sampled->sampler;
    const struct pp_randomisation *randomisation = &sampled->randomisations[i];
    if (estimator >= 0 && sampler->part)
        return sampler->part(sampled->client, sampled->point, randomisation, estimator);
    return sampler->value(sampled->client, sampled->point, randomisation, value);
}

/* Statistics of the randomisations with even numbers (half 0) or odd numbers (half
 * 1). */
struct half {
    double mean, squares, cubes; /* sums of squares and cubes of the deviations from the
                                  * mean of both halves */
    int count;
};

/* Variance of a half's mean, multiplied by the variance of Student's t for its number
 * of randomisations. */
static double variance_of_mean(const struct half *half, double mean)
{
    double off = half->mean - mean, n = half->count;
    return (half->squares - n * off * off) / (n - 3.0) / n;
}

/* Spread of a value; or, if `estimator` is 0 or more, of this estimator's contribution
 * to the last value. */
static struct pp_spread spread_of(const struct pp_sampled *sampled, int value,
                                  int estimator)
{
    enum { KEPT = 64 }; /* values stored, so as not to be calculated twice */
    double kept[KEPT];
    struct half halves[2] = {{.count = 0}, {.count = 0}};
    struct pp_spread spread = {.std_error = NAN};
    for (int i = 0; i < sampled->count; i++)
        if (is_begun(sampled->sampler, &sampled->randomisations[i])) {
            double one = figure(sampled, i, value, estimator);
            halves[i % 2].mean += one;
            halves[i % 2].count++;
            if (i < KEPT)
                kept[i] = one;
        }
    spread.count = halves[0].count + halves[1].count;
    if (spread.count == 0)
        return spread;
    double n = spread.count, mean = (halves[0].mean + halves[1].mean) / n;
    for (int h = 0; h < 2 && spread.count > 1; h++)
        halves[h].mean /= halves[h].count;
    spread.mean = mean;
    if (spread.count < 2)
        return spread;
    for (int i = 0; i < sampled->count; i++)
        if (is_begun(sampled->sampler, &sampled->randomisations[i])) {
            double one = i < KEPT ? kept[i] : figure(sampled, i, value, estimator);
            double off = one - mean;
            halves[i % 2].squares += off * off;
            halves[i % 2].cubes += off * off * off;
        }
    spread.variance = (halves[0].squares + halves[1].squares) / (n - 1.0);
    spread.third = (halves[0].cubes + halves[1].cubes) / n;
    if (spread.count > 3)
        spread.std_error = sqrt(spread.variance / n) * pp_spread_student(spread.count);
    int least = halves[0].count < halves[1].count ? halves[0].count : halves[1].count;
    if (spread.count - 2 * least < 2 || least < 4)
        return spread;
    spread.mean = 0.5 * (halves[0].mean + halves[1].mean);
    spread.std_error =
        0.5
        * sqrt(variance_of_mean(&halves[0], mean) + variance_of_mean(&halves[1], mean));
    return spread;
}

struct pp_spread pp_spread_of_value(const struct pp_sampled *sampled, int value)
{
    return spread_of(sampled, value, -1);
}

struct pp_spread pp_spread_of_part(const struct pp_sampled *sampled, int estimator)
{
    return spread_of(sampled, sampled->sampler->values - 1, estimator);
}

double pp_spread_variance_of_half(const struct pp_sampled *sampled, int half)
{
    double mean = 0.0, squares = 0.0;
    int value = sampled->sampler->values - 1, n = (sampled->count + 1 - half) / 2;
    for (int i = half; i < sampled->count; i += 2)
        mean += figure(sampled, i, value, -1) / n;
    for (int i = half; i < sampled->count; i += 2) {
        double off = figure(sampled, i, value, -1) - mean;
        squares += off * off;
    }
    return squares / (n - 1.0);
}

/* True if the value differs between randomisations. Usually the second randomisation
 * already shows a difference. */
static bool differs(const struct pp_sampled *sampled, int value)
{
    double first = NAN;
    for (int i = 0; i < sampled->count; i++) {
        if (!is_begun(sampled->sampler, &sampled->randomisations[i]))
            continue;
        double one = figure(sampled, i, value, -1);
        if (isnan(first))
            first = one;
        if (fabs(one - first) > ROUNDING * fabs(first))
            return true;
    }
    return false;
}

/* Number of randomisations, from the first, that all points have begun. */
static int begun_by_all(const struct pp_sampled *points, int count)
{
    int all = points[0].count;
    for (int i = 0; i < count; i++) {
        int begun = 0;
        while (begun < points[i].count && begun < all
               && is_begun(points[i].sampler, &points[i].randomisations[begun]))
            begun++;
        all = begun;
    }
    return all;
}

/* Mean and sum of squared deviations over the first randomisations, for a point or for
 * the sum of all points. */
struct moments {
    double mean, squares;
};

static void add_to_moments(struct moments *moments, double value, int before)
{
    double off = value - moments->mean;
    moments->mean += off / (before + 1);
    moments->squares += off * (value - moments->mean);
}

double pp_spread_common(const struct pp_sampled *points, int count)
{
    enum { LEAST = 8 };
    int all = count > 1 ? begun_by_all(points, count) : 0;
    if (all < LEAST)
        return 0.0;
    int last = points[0].sampler->values - 1;
    struct moments of_sum = {0.0, 0.0};
    for (int r = 0; r < all; r++) {
        double sum = 0.0;
        for (int i = 0; i < count; i++)
            sum += figure(&points[i], r, last, -1);
        add_to_moments(&of_sum, sum, r);
    }
    double squares = 0.0, errors = 0.0;
    for (int i = 0; i < count; i++) {
        struct moments own = {0.0, 0.0};
        for (int r = 0; r < all; r++)
            add_to_moments(&own, figure(&points[i], r, last, -1), r);
        squares += own.squares;
        errors += sqrt(own.squares);
    }
    double apart = squares, together = errors * errors;
    if (!(together > apart))
        return 0.0;
    return fmin(fmax((of_sum.squares - apart) / (together - apart), 0.0), 1.0);
}

unsigned pp_spread_found(const struct pp_sampled *sampled)
{
    unsigned found = 0;
    for (int i = 0; i < sampled->sampler->values; i++)
        found |= (unsigned)differs(sampled, i) << i;
    return found;
}

void pp_spread_paths(const struct pp_sampled *sampled, double *paths)
{
    for (int k = 0; k < sampled->sampler->estimators; k++) {
        paths[k] = 0.0;
        for (int i = 0; i < sampled->count; i++)
            paths[k] += sampled->randomisations[i].done.of[k];
    }
}

void pp_spread_add_work(const struct pp_sampled *sampled, struct pp_path_work *work)
{
    for (int r = 0; r < sampled->count; r++) {
        const struct pp_randomisation *one = &sampled->randomisations[r];
        work->leaks += one->leaks;
        for (int k = 0; k < sampled->sampler->estimators; k++) {
            work->paths += one->done.of[k];
            work->rays += one->rays[k];
        }
    }
}

double pp_spread_student(int count)
{
    return sqrt((count - 1.0) / (count - 3.0));
}

void pp_spread_readings(const struct pp_sampled *sampled,
                        struct pp_reading readings[PP_VALUES_MOST])
{
    const struct pp_sampler *sampler = sampled->sampler;
    double paths[PP_ESTIMATORS_MOST];
    unsigned found = pp_spread_found(sampled);
    pp_spread_paths(sampled, paths);
    for (int i = 0; i < sampler->values; i++) {
        struct pp_spread spread = spread_of(sampled, i, -1);
        readings[i] = pp_reading_none("not simulated yet");
        if (spread.count < (sampled->count < 4 ? sampled->count : 4))
            continue;
        readings[i] = pp_reading_of(spread.mean);
        if (spread.count < 4)
            continue;
        double bound = 0.0;
        if (sampler->bound)
            bound = sampler->bound(sampled->client, sampled->point, i, found, paths);
        readings[i].std_error = hypot(spread.std_error, bound);
    }
}
