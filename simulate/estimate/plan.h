/* plan.h - number of paths that a point needs, estimated from a pilot.
 *
 * The plan is the number of paths of each estimator for which the value's variance
 * reaches the target at the lowest cost. Two more conditions make the standard error
 * reliable:
 *
 *     - the randomisations are nearly normal: their skewness is below 1.2. With
 *       more, the mean and the standard deviation of 32 are so correlated that
 *       intervals of two standard errors cover less than 94 %
 *     - the bound on light not found is below half of the target error
 *
 * If a pilot is too small for a plan, it is enlarged first. These decisions are based
 * on paths that do not enter the value, so that values are not selected by their size.
 * If the error is still too large, even-numbered randomisations are added, as many as
 * the variance of the odd-numbered ones requires, and vice versa. The number of
 * randomisations in each half is then independent of the mean of that half.
 */
#ifndef PP_SIMULATE_ESTIMATE_PLAN_H
#define PP_SIMULATE_ESTIMATE_PLAN_H

#include "simulate/estimate/spread.h"

enum {
    PP_RANDOMISATIONS = 32, /* least number for a point; even */
    PP_MOST_PATHS = 1 << 24 /* most paths of one estimator in one randomisation */
};

/* Number of paths of each estimator, and the number of randomisations. */
struct pp_plan {
    struct pp_counts counts;
    int randomisations;
};

/* Greatest number of paths of an estimator in a randomisation. */
static inline uint32_t pp_plan_most(const struct pp_sampler *sampler, int estimator)
{
    uint32_t most = sampler->most.of[estimator];
    return most > 0 ? most : PP_MOST_PATHS;
}

/* Allocates samples from a pilot run, for the standard error `wanted` of the last
 * value. Returns true if the pilot is too small and may_grow; *grown is then a larger
 * pilot. Otherwise returns false, with the plan in *plan. */
bool pp_plan_grows(const struct pp_sampled *pilot, double wanted, bool may_grow,
                   struct pp_counts *grown, struct pp_plan *plan);

/* Numbers of randomisations that the two halves (spread.h) need for the error
 * `wanted`. */
void pp_plan_halves(const struct pp_sampled *done, double wanted, int halves[2]);

#endif
