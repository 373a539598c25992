/* spread.h - the value and the standard error from the randomisations.
 *
 * The value is the mean of R randomisations, and its standard error is
 *
 *     sqrt(s^2/R (R - 1)/(R - 3) + b^2)
 *
 * where s is the standard deviation of the randomisations. (R - 1)/(R - 3) is the
 * variance of Student's t with R - 1 degrees of freedom. With this factor, intervals of
 * one and two standard errors cover 69 and 95 %, although s is itself an estimate. b is
 * the sampler's bound on light that no path has found, and that no spread shows.
 *
 * The randomisations form two halves, with even and with odd numbers. The planner may
 * add randomisations to one half because of the variance of the other half. The value
 * is then the mean of the two halves' means, whatever their sizes. The weight of a half
 * therefore does not depend on its own value.
 */
#ifndef PP_SIMULATE_ESTIMATE_SPREAD_H
#define PP_SIMULATE_ESTIMATE_SPREAD_H

#include "model/results/reading.h"
#include "simulate/estimate/sampler.h"

/* A point of a sampler with its randomisations; not owned. */
struct pp_sampled {
    const struct pp_sampler *sampler;
    const void *client;
    int point;
    const struct pp_randomisation *randomisations;
    int count;
};

/* Statistics over those randomisations that have paths of all estimators: the mean, the
 * variance and third central moment of one randomisation, the number of randomisations,
 * and the standard error without b (NAN for fewer than four). */
struct pp_spread {
    double mean, variance, third, std_error;
    int count;
};

struct pp_spread pp_spread_of_value(const struct pp_sampled *sampled, int value);
struct pp_spread pp_spread_of_part(const struct pp_sampled *sampled, int estimator);

/* Variance of the last value over the randomisations with even (half 0) or odd (half 1)
 * numbers; all must be finished. */
double pp_spread_variance_of_half(const struct pp_sampled *sampled, int half);

/* pp_spread_found returns a bit set for pp_sampler.bound: bit i is set if the
 * randomisations of value i differ. pp_spread_paths sums the paths of all
 * randomisations by estimator. */
unsigned pp_spread_found(const struct pp_sampled *sampled);
void pp_spread_paths(const struct pp_sampled *sampled, double *paths);

/* Amount of work done. A leak is a ray that left a room through a gap between the edges
 * of two surfaces and was abandoned. */
struct pp_path_work {
    long long paths, rays, leaks;
};

/* Adds the work of all randomisations. */
void pp_spread_add_work(const struct pp_sampled *sampled, struct pp_path_work *work);

/* Correlated fraction, 0 to 1, of the variance of the last value over `count` points
 * (common_error.h). Uses the randomisations that all points have; 0 with fewer than
 * eight of these randomisations or fewer than two points. */
double pp_spread_common(const struct pp_sampled *points, int count);

/* The factor sqrt((R - 1)/(R - 3)) of the standard error, for R = count > 3. */
double pp_spread_student(int count);

/* All values with their standard errors, which are NAN if fewer than four
 * randomisations are requested. Values are NAN, with a reason, until four
 * randomisations (or as many as requested) have begun. */
void pp_spread_readings(const struct pp_sampled *sampled,
                        struct pp_reading readings[PP_VALUES_MOST]);

#endif
