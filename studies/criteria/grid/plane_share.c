/* plane_share.c - the Poisson binomial distribution of the number of points that reach
 * a level, and levels of given probability by bisection.
 *
 * The median of 2 m points is half way between the m-th and the next value. The median
 * reaches a level if m + 1 points reach the level. It also reaches the level if m
 * points do, and the gap from the level up to the lowest of these points is not less
 * than the gap down to the highest of the other points. The joint distribution of the
 * two gaps comes from the same sums, with two levels in place of one.
 *
 * Where points represent unequal areas, each counts as several: as many as its area has
 * sixteenths of the mean area. All of these reach a level if the point does.
 */
#include "studies/criteria/grid/plane_share.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "model/results/common_error.h"
#include "model/results/sheets/point_areas.h"
#include "studies/criteria/finding.h"

/* Distance of a probability from 0 or 1 within which the point counts as certain. */
static const double surely = 1e-12;

/* Distance from a level, in standard errors, beyond which a point is certainly on one
 * side of the level: normal_below(-7.04) = 0.96e-12. */
static const double surely_off = 7.04;

/* Relative difference that is attributed to rounding when a value is compared with a
 * target. */
static const double rounding = 1e-9;

/* Greatest number of equal points near the figure for which the distribution is
 * computed exactly: the time grows with the product of points and units, or faster. */
enum { EXACT_MOST = 200 };

/* Units of the mean area, for points of unequal areas. */
static const double units_of_mean = 16.0;

/* A value and the units of the plane that have it. */
struct ranked_value {
    double value;
    int units;
};

static int compare_falling(const void *a, const void *b)
{
    double x = ((const struct ranked_value *)a)->value;
    double y = ((const struct ranked_value *)b)->value;
    return (x < y) - (x > y);
}

/* Points, the units that each represents (1 if all areas are equal), the correlated
 * fraction of the variance of their values, and the square root of the uncorrelated
 * rest. The figure is the value of the wanted-th unit in descending order, or half way
 * between that and the next. */
struct plane_points {
    struct pp_reading *list;
    int *units;
    int count, wanted;
    bool half_way;
    double common, own;
};

/* Probability that a point reaches the target, if all points share an error of `shift`
 * standard errors; 0 or 1 for a point that was not sampled. */
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

/* odds[k], 0 <= k <= *uncertain: probability that k units of the uncertain points reach
 * `high` and all others stay below `low` <= `high`. Returns the number of units
 * that surely reach `high`, which are not in k; -1 if some point surely lies between
 * both. */
static int odds_of(const struct plane_points *points, double high, double low,
                   double shift, double *odds, int *uncertain)
{
    int sure = 0;
    *uncertain = 0;
    odds[0] = 1.0;
    for (int i = 0; i < points->count; i++) {
        double p = probability_of_point(points, i, high, shift);
        double q = 1.0 - (low < high ? probability_of_point(points, i, low, shift) : p);
        if (p > 1.0 - surely) {
            sure += points->units[i];
            continue;
        }
        if (q > 1.0 - surely)
            continue;
        if (p < surely && q < surely)
            return -1;
        int units = points->units[i];
        for (int k = 1; k <= units; k++)
            odds[*uncertain + k] = 0.0;
        *uncertain += units;
        for (int k = *uncertain; k >= units; k--)
            odds[k] = odds[k] * q + odds[k - units] * p;
        for (int k = 0; k < units; k++)
            odds[k] *= q;
    }
    return sure;
}

/* Joint distribution of two gaps: from the level up to the least of the `wanted` units
 * above it, and down to the greatest of the points below. corner[i][j]: the probability
 * that the first is at least low (i = 0) or high (i = 1), and the second at least low
 * (j = 0) or high (j = 1). */
struct gap_square {
    double low, high;
    double corner[2][2];
};

static double gaps_probability(const struct plane_points *points, double level,
                               double shift, double above, double below, double *odds)
{
    int uncertain,
        sure = odds_of(points, level + above, level - below, shift, odds, &uncertain);
    int k = points->wanted - sure;
    return sure >= 0 && k >= 0 && k <= uncertain ? odds[k] : 0.0;
}

/* Probability that the second gap is in the square's range and the first is greater. If
 * both are in the range, half of the probability is counted; the square is halved until
 * that case is rare. */
static double gap_above_is_greater(const struct plane_points *points, double level,
                                   double shift, const struct gap_square *square,
                                   double *odds)
{
    static const double seldom = 0.01;
    double second = square->corner[0][0] - square->corner[0][1];
    double both = second - square->corner[1][0] + square->corner[1][1];
    double middle = 0.5 * (square->low + square->high);
    if (both < seldom || middle <= square->low || middle >= square->high)
        return second - 0.5 * both;
    double high = square->high, low = square->low, across[2][2];
    across[0][0] = gaps_probability(points, level, shift, low, middle, odds);
    across[0][1] = gaps_probability(points, level, shift, middle, low, odds);
    across[1][0] = gaps_probability(points, level, shift, middle, high, odds);
    across[1][1] = gaps_probability(points, level, shift, high, middle, odds);
    double centre = gaps_probability(points, level, shift, middle, middle, odds);
    const struct gap_square near = {
        low, middle, {{square->corner[0][0], across[0][0]}, {across[0][1], centre}}};
    const struct gap_square far = {
        middle, high, {{centre, across[1][0]}, {across[1][1], square->corner[1][1]}}};
    return gap_above_is_greater(points, level, shift, &near, odds)
           + gap_above_is_greater(points, level, shift, &far, odds);
}

/* Probability that exactly the wanted number of units reach the level, and that the
 * figure also reaches it. The figure is half way between the lowest of these units and
 * the next value. `reach`: an upper bound on gaps. */
static double tie_probability(const struct plane_points *points, double level,
                              double shift, double *odds)
{
    double reach = 0.0;
    for (int i = 0; i < points->count; i++) {
        const struct pp_reading *point = &points->list[i];
        double spread =
            point->std_error > 0.0 ? (8.0 + fabs(shift)) * point->std_error : 0.0;
        reach = fmax(reach, fabs(point->value - level) + spread);
    }
    reach *= 1.0 + 4.0 * rounding; /* so that no gap equals a corner */
    struct gap_square all = {0.0, reach, {{0.0}}};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            all.corner[i][j] =
                gaps_probability(points, level, shift, i * reach, j * reach, odds);
    return gap_above_is_greater(points, level, shift, &all, odds);
}

/* Standard normal distribution function. */
static double normal_below(double z)
{
    return 0.5 * erfc(-z / sqrt(2.0));
}

/* Probability that the figure reaches the level, given the shift, if many points are
 * uncertain. The number of units that reach the level is approximated by a normal
 * distribution, with a correction of half a unit. */
static double probability_of_many(const struct plane_points *points, double level,
                                  double shift)
{
    double mean = 0.0, variance = 0.0;
    for (int i = 0; i < points->count; i++) {
        double p = probability_of_point(points, i, level, shift);
        double units = points->units[i];
        mean += units * p;
        variance += units * units * (p * (1.0 - p));
    }
    double least = points->wanted + (points->half_way ? 0.5 : 0.0);
    return normal_below((mean - least + 0.5) / sqrt(fmax(variance, surely)));
}

/* True if the time for the exact distribution would be too long. */
static bool has_many_points(const struct plane_points *points)
{
    double units = 0.0;
    for (int i = 0; i < points->count; i++)
        units += points->units[i];
    return points->count * units > (double)EXACT_MOST * EXACT_MOST;
}

/* Probability that the figure reaches the level, given the shift. `odds` has space for
 * as many numbers as the points have units, and one more. */
static double probability_with(const struct plane_points *points, double level,
                               double shift, double *odds)
{
    if (has_many_points(points))
        return probability_of_many(points, level, shift);
    int uncertain, sure = odds_of(points, level, level, shift, odds, &uncertain);
    int least = points->wanted + (points->half_way ? 1 : 0);
    double sum = 0.0;
    for (int k = uncertain; k >= 0 && sure + k >= least; k--)
        sum += odds[k];
    int tie = points->wanted - sure;
    if (points->half_way && tie >= 0 && tie <= uncertain && odds[tie] > surely)
        sum += tie_probability(points, level, shift, odds);
    return fmin(sum, 1.0);
}

/* Largest shift, and smallest step, in standard deviations. */
static const double shift_most = 4.0, shift_least = 0.01;

/* Probabilities rise with the shift; an interval over which they rise by more than this
 * is halved. */
static const double steep = 0.05;

struct shifted {
    double z, probability;
};

struct shifting {
    const struct plane_points *points;
    double level;
    double *odds;
};

static struct shifted at_shift(const struct shifting *by, double z)
{
    double shift = sqrt(by->points->common) * z;
    return (struct shifted){z,
                            probability_with(by->points, by->level, shift, by->odds)};
}

/* Contribution to the mean over all shifts of the interval between two shifts. */
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

/* Mean probability over all shifts, which are normally distributed. */
static double probability_of(const struct plane_points *points, double level,
                             double *odds)
{
    if (!(points->common > 0.0))
        return probability_with(points, level, 0.0, odds);
    const struct shifting by = {points, level, odds};
    struct shifted low = at_shift(&by, -shift_most), high = at_shift(&by, shift_most);
    double sum = low.probability * normal_below(low.z)
                 + high.probability * normal_below(-high.z);
    struct shifted middle = at_shift(&by, 0.0);
    return sum + mean_between(&by, low, middle) + mean_between(&by, middle, high);
}

static double lower_end(const struct pp_reading *point)
{
    return point->value - (point->std_error > 0.0 ? 8.0 * point->std_error : 0.0);
}

static double point_value(const struct pp_reading *point)
{
    return point->value;
}

static double upper_end(const struct pp_reading *point)
{
    return point->value + (point->std_error > 0.0 ? 8.0 * point->std_error : 0.0);
}

/* Level that the figure reaches with the given probability. Found by bisection between
 * two levels 8 standard errors away, one that all points reach and one that none
 * reaches. */
static double level_of(const struct plane_points *points, double probability,
                       double *odds)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < points->count; i++) {
        low = fmin(low, lower_end(&points->list[i]));
        high = fmax(high, upper_end(&points->list[i]));
    }
    double enough = 1e-7 * (high - low);
    while (high - low > enough) {
        double middle = 0.5 * (low + high);
        if (probability_of(points, middle, odds) > probability)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* Ranks the ends of the points, or their values, in descending order. */
static void rank_points(struct ranked_value *values, const struct plane_points *points,
                        double (*end_of)(const struct pp_reading *point))
{
    for (int i = 0; i < points->count; i++)
        values[i] = (struct ranked_value){end_of(&points->list[i]), points->units[i]};
    qsort(values, (size_t)points->count, sizeof *values, compare_falling);
}

/* Value of the n-th unit of ranked values. */
static double value_of_unit(const struct ranked_value *values, int count, int n)
{
    int i = 0;
    for (int units = values[0].units; units < n && i < count - 1;
         units += values[i].units)
        i++;
    return values[i].value;
}

/* Leaves out points that are surely above or surely below the figure: they do not
 * change its distribution. values: space for count values. */
static void leave_out_distant(struct plane_points *points, struct ranked_value *values)
{
    int count = points->count, next = points->wanted + (points->half_way ? 1 : 0);
    rank_points(values, points, upper_end);
    double highest = value_of_unit(values, count, points->wanted);
    rank_points(values, points, lower_end);
    double lowest = value_of_unit(values, count, next);
    points->count = 0;
    for (int i = 0; i < count; i++) {
        const struct pp_reading *point = &points->list[i];
        if (lower_end(point) > highest)
            points->wanted -= points->units[i];
        else if (upper_end(point) >= lowest) {
            points->units[points->count] = points->units[i];
            points->list[points->count++] = *point;
        }
    }
}

/* The figure of the points. values: space for count values. */
static double figure_of(const struct plane_points *points, struct ranked_value *values)
{
    rank_points(values, points, point_value);
    double here = value_of_unit(values, points->count, points->wanted);
    return points->half_way
               ? 0.5 * (here + value_of_unit(values, points->count, points->wanted + 1))
               : here;
}

/* Sets share->over, the fraction of the plane whose points reach the target, and its
 * standard error. The number of points is a sum of Bernoulli variables; the fraction
 * `common` of the variance is common to all points. */
static void find_over(struct pp_plane_share *share, const struct pp_reading *points,
                      const struct pp_receiver *receivers, int count, double common,
                      double target)
{
    double area_m2 = pp_point_areas_sum(receivers, count);
    double over = 0.0, whole = 0.0, sum = 0.0, squares = 0.0;
    bool sampled = false;
    for (int i = 0; i < count; i++) {
        double weight = pp_point_areas_weight(receivers, area_m2, i);
        sampled |= isfinite(points[i].std_error);
        whole += weight;
        if (points[i].value >= target - rounding * fabs(target))
            over += weight;
        if (!(points[i].std_error > 0.0))
            continue;
        double p = pp_finding_probability_at_least(points[i].value, points[i].std_error,
                                                   target);
        sum += weight * sqrt(p * (1.0 - p));
        squares += weight * weight * (p * (1.0 - p));
    }
    share->over = over / whole;
    share->over_error = sampled ? pp_common_error(sum, squares, common) / whole : NAN;
}

struct pp_reading pp_plane_share_mean(const struct pp_reading *points,
                                      const struct pp_receiver *receivers, int count,
                                      double common)
{
    double area_m2 = pp_point_areas_sum(receivers, count);
    double whole = pp_point_areas_whole(receivers, count);
    double sum = 0.0, errors = 0.0, squares = 0.0;
    for (int i = 0; i < count; i++) {
        double weight = pp_point_areas_weight(receivers, area_m2, i);
        double error = weight * points[i].std_error / whole;
        sum += weight * points[i].value / whole;
        errors += error;
        squares += error * error;
    }
    struct pp_reading mean = pp_reading_of(sum);
    mean.std_error = pp_common_error(errors, squares, common);
    return mean;
}

/* Units of a point: sixteenths of the mean area; 1 if all areas are equal. */
static int units_of_point(const struct pp_receiver *receivers, bool differ,
                          double mean_m2, int point)
{
    if (!differ)
        return 1;
    return (int)fmax(round(units_of_mean * receivers[point].area_m2 / mean_m2), 1.0);
}

/* Copies the points and finds the units of each. Returns the sum of the units; -1 if
 * memory runs out. The caller frees the lists. */
static int copy_points(struct plane_points *all, const struct pp_reading *points,
                       const struct pp_receiver *receivers, int count)
{
    bool differ = pp_point_areas_differ(receivers, count);
    double mean_m2 = differ ? pp_point_areas_sum(receivers, count) / count : NAN;
    int units = 0;
    all->count = count;
    all->list = malloc(((size_t)count + 1) * sizeof *all->list);
    all->units = malloc(((size_t)count + 1) * sizeof *all->units);
    if (!all->list || !all->units)
        return -1;
    for (int i = 0; i < count; i++) {
        all->list[i] = points[i];
        all->units[i] = units_of_point(receivers, differ, mean_m2, i);
        units += all->units[i];
    }
    return units;
}

enum pp_status pp_plane_share(struct pp_plane_share *share,
                              const struct pp_reading *points,
                              const struct pp_receiver *receivers, int count,
                              double common, double part, double target,
                              struct pp_error *err)
{
    struct plane_points all = {.common = fmin(common, 1.0 - 1e-9)};
    all.own = sqrt(1.0 - all.common);
    int units = copy_points(&all, points, receivers, count);
    struct ranked_value *values = malloc(((size_t)count + 1) * sizeof *values);
    double *odds = units < 0 ? NULL : malloc(((size_t)units + 1) * sizeof *odds);
    enum pp_status status = values && odds ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        all.wanted = (int)fmax(ceil(part * units - rounding * units), 1.0);
        all.half_way = part == 0.5 && units % 2 == 0;
        *share = (struct pp_plane_share){
            .level = figure_of(&all, values), .std_error = NAN, .probability = NAN};
        find_over(share, points, receivers, count, all.common, target);
    }
    if (status == PP_OK && isfinite(share->over_error)) {
        leave_out_distant(&all, values);
        share->probability = probability_of(&all, target, odds);
        share->std_error =
            0.5 * (level_of(&all, 0.1587, odds) - level_of(&all, 0.8413, odds));
    }
    free(odds);
    free(values);
    free(all.units);
    free(all.list);
    return status;
}
