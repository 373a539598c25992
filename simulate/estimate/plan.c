/* plan.c - predicts the variance, the skewness and the bound on light not found. Adds
 * paths where they reduce these statistics most for their cost. */
#include "simulate/estimate/plan.h"

#include <math.h>

/* Fraction of the target error at which a plan aims, since the variances are only
 * estimates. Chosen by trial. */
static const double PLANNED_SHARE = 0.92;

/* Cost of a path in addition to its rays, in rays. */
static const double PATH_COST = 1.0;

/* Greatest squared skewness allowed for a randomisation. By the Edgeworth expansion of
 * Student's t, an interval of two standard errors from 32 values then contains the true
 * value in about 1 % fewer cases than it should. */
static const double SKEWNESS_SQUARED = 1.5;

/* Exponent with which the third moment of a mean falls as the number of paths grows;
 * conservative. */
static const double THIRD_FALL = 2.0;

/* SURE_PATHS: most paths that a randomisation gets because of skewness or of the bound
 * on light not found. A pilot that is too small grows by the factor GROWTH, up to
 * PILOT_PATHS. */
enum { SURE_PATHS = 1 << 11, PILOT_PATHS = 1 << 9, GROWTH = 4 };

/* A pilot is too small if its error exceeds the target by this factor: the target is
 * relative to a value that is then itself uncertain. A pilot at the limit takes a sixth
 * of the work of a good plan. */
static const double VAGUE = 5.0;

/* Least and greatest factor by which the number of randomisations of a half grows, if
 * at all. A variance from 16 values has a standard error of 36 %. */
static const double LEAST_ADDED = 1.5, MOST_ADDED = 4.0;

/* Predicted statistics of randomisations with certain numbers of paths. */
struct outlook {
    const struct pp_sampled *pilot;
    struct pp_counts counts;
    double variance[PP_ESTIMATORS_MOST], third[PP_ESTIMATORS_MOST];
    double cost[PP_ESTIMATORS_MOST]; /* cost of one path */
    unsigned found;
};

static struct outlook outlook_of(const struct pp_sampled *pilot)
{
    struct outlook outlook = {.pilot = pilot, .found = pp_spread_found(pilot)};
    double paths[PP_ESTIMATORS_MOST];
    pp_spread_paths(pilot, paths);
    for (int k = 0; k < pilot->sampler->estimators; k++) {
        struct pp_spread spread = pp_spread_of_part(pilot, k);
        double rays = 0.0;
        for (int i = 0; i < pilot->count; i++)
            rays += (double)pilot->randomisations[i].rays[k];
        outlook.counts.of[k] = pilot->randomisations[0].done.of[k];
        outlook.variance[k] = spread.variance;
        outlook.third[k] = fabs(spread.third);
        double beside = pilot->sampler->cost[k];
        outlook.cost[k] = rays / paths[k] + (beside > 0.0 ? beside : PATH_COST);
    }
    return outlook;
}

static double sum_of(const struct outlook *outlook, const double *list)
{
    double sum = 0.0;
    for (int k = 0; k < outlook->pilot->sampler->estimators; k++)
        sum += list[k];
    return sum;
}

static double total_cost(const struct outlook *outlook)
{
    double sum = 0.0;
    for (int k = 0; k < outlook->pilot->sampler->estimators; k++)
        sum += outlook->cost[k] * outlook->counts.of[k];
    return sum;
}

static double skewness_squared(const struct outlook *outlook)
{
    double variance = sum_of(outlook, outlook->variance);
    double third = sum_of(outlook, outlook->third);
    return variance > 0.0 ? third * third / (variance * variance * variance) : 0.0;
}

/* Upper bound on the light that the planned paths may miss, for the value that has the
 * target error. */
static double unfound_bound(const struct outlook *outlook)
{
    const struct pp_sampler *sampler = outlook->pilot->sampler;
    double paths[PP_ESTIMATORS_MOST];
    for (int k = 0; k < sampler->estimators; k++)
        paths[k] = (double)PP_RANDOMISATIONS * outlook->counts.of[k];
    return sampler->bound
               ? sampler->bound(outlook->pilot->client, outlook->pilot->point,
                                sampler->values - 1, outlook->found, paths)
               : 0.0;
}

/* The same outlook with twice the paths of estimator k. */
static struct outlook doubled(const struct outlook *outlook, int k)
{
    struct outlook more = *outlook;
    more.counts.of[k] *= 2;
    more.variance[k] *= pow(2.0, -outlook->pilot->sampler->fall[k]);
    more.third[k] *= pow(2.0, -THIRD_FALL);
    return more;
}

/* The statistic that additional paths should reduce. */
enum aim { VARIANCE, SKEWNESS, BOUND };

static double height(const struct outlook *outlook, enum aim aim)
{
    return aim == VARIANCE   ? sum_of(outlook, outlook->variance)
           : aim == SKEWNESS ? sum_of(outlook, outlook->third)
                             : unfound_bound(outlook);
}

/* Doubles the paths of the estimator that reduces the statistic most for its cost;
 * false if none does. For skewness and bound, false also if that estimator is at its
 * limit of paths, since a reduction by other estimators would cost too much. */
static bool double_best(struct outlook *outlook, enum aim aim)
{
    const struct pp_sampler *sampler = outlook->pilot->sampler;
    double most = 0.0, now = height(outlook, aim);
    bool found = false;
    struct outlook best;
    for (int k = 0; k < sampler->estimators; k++) {
        struct outlook next = doubled(outlook, k);
        uint32_t limit = pp_plan_most(sampler, k);
        if (aim != VARIANCE && limit > SURE_PATHS)
            limit = SURE_PATHS;
        double gain =
            (now - height(&next, aim)) / (outlook->cost[k] * outlook->counts.of[k]);
        bool may = next.counts.of[k] <= limit;
        if (gain > most && (may || aim != VARIANCE)) {
            most = gain;
            best = next;
            found = may;
        }
    }
    if (found)
        *outlook = best;
    return found;
}

/* Variance that each of PP_RANDOMISATIONS randomisations may have if the target is to
 * be reached, given the bound. */
static double allowed_variance(const struct outlook *outlook, double wanted)
{
    double planned = PLANNED_SHARE * wanted, bound = unfound_bound(outlook);
    double left = fmax(planned * planned - bound * bound, 0.25 * planned * planned);
    double student = pp_spread_student(PP_RANDOMISATIONS);
    return left * PP_RANDOMISATIONS / (student * student);
}

/* True if an estimator has reached its limit of paths. */
static bool is_limited(const struct outlook *outlook)
{
    const struct pp_sampler *sampler = outlook->pilot->sampler;
    for (int k = 0; k < sampler->estimators; k++)
        if (2 * outlook->counts.of[k] > pp_plan_most(sampler, k))
            return true;
    return false;
}

/* Searches, from this outlook, for the cheapest numbers of paths and randomisations
 * that reach the allowed variance. Ignores skewness and bound. */
static struct outlook reach_variance(struct outlook at, double allowed,
                                     int *randomisations)
{
    struct outlook best = at;
    double cheapest = INFINITY;
    for (;;) {
        double more = fmax(1.0, height(&at, VARIANCE) / allowed);
        struct outlook next = at;
        bool last = more <= 1.0 || !double_best(&next, VARIANCE);
        int count = 2 * (int)ceil(0.5 * PP_RANDOMISATIONS * fmin(more, 1000.0));
        double cost = count * total_cost(&at)
                      + (count - PP_RANDOMISATIONS) * at.pilot->sampler->cost_of_more;
        if ((more <= 2.0 || last || is_limited(&at)) && cost < cheapest) {
            cheapest = cost;
            best = at;
            *randomisations = count;
        }
        if (last)
            return best;
        at = next;
    }
}

static struct pp_plan plan_by(struct outlook outlook, double wanted)
{
    const struct pp_sampler *sampler = outlook.pilot->sampler;
    struct pp_plan plan;
    for (int k = 0; k < sampler->estimators; k++)
        while (outlook.counts.of[k] < sampler->least.of[k])
            outlook = doubled(&outlook, k);
    outlook = reach_variance(outlook, allowed_variance(&outlook, wanted),
                             &plan.randomisations);
    while (skewness_squared(&outlook) > SKEWNESS_SQUARED
           && double_best(&outlook, SKEWNESS))
        ;
    while (unfound_bound(&outlook) > 0.5 * wanted && double_best(&outlook, BOUND))
        ;
    plan.counts = outlook.counts;
    return plan;
}

/* True if the pilot is too small; *counts is then the size of a larger one. */
static bool is_too_little(const struct outlook *now, double wanted,
                          struct pp_counts *counts)
{
    const struct pp_sampler *sampler = now->pilot->sampler;
    struct outlook more = *now;
    bool may = false;
    for (int k = 0; k < sampler->estimators; k++) {
        uint32_t most = pp_plan_most(sampler, k);
        more.counts.of[k] *= GROWTH;
        if (more.counts.of[k] > PILOT_PATHS)
            return false;
        if (more.counts.of[k] > most)
            more.counts.of[k] = most;
        may |= more.counts.of[k] > now->counts.of[k];
    }
    if (!may)
        return false;
    int randomisations;
    struct outlook planned =
        reach_variance(*now, allowed_variance(now, wanted), &randomisations);
    bool skewed = skewness_squared(&planned) > SKEWNESS_SQUARED;
    bool vague =
        height(now, VARIANCE) > VAGUE * VAGUE * PP_RANDOMISATIONS * wanted * wanted;
    bool blind =
        unfound_bound(now) > 2.0 * wanted && unfound_bound(&more) < unfound_bound(now);
    bool grows = skewed || vague || blind;
    if (grows)
        *counts = more.counts;
    return grows;
}

bool pp_plan_grows(const struct pp_sampled *pilot, double wanted, bool may_grow,
                   struct pp_counts *grown, struct pp_plan *plan)
{
    struct outlook outlook = outlook_of(pilot);
    bool grows = may_grow && is_too_little(&outlook, wanted, grown);
    if (!grows)
        *plan = plan_by(outlook, wanted);
    return grows;
}

void pp_plan_halves(const struct pp_sampled *done, double wanted, int halves[2])
{
    int n = done->count / 2;
    for (int h = 0; h < 2; h++) {
        double student = pp_spread_student(done->count);
        double variance = pp_spread_variance_of_half(done, 1 - h);
        double more = variance * student * student / (2.0 * n * wanted * wanted);
        halves[h] = more > LEAST_ADDED ? (int)ceil(n * fmin(more, MOST_ADDED)) : n;
    }
}
