/* spread.h - the value and the standard error from the randomisations.
 *
 * The value is the mean of R randomisations, and its standard error is
 *
 *     sqrt(s^2/R (R - 1)/(R - 3) + b^2)
 *
 * with s their standard deviation. The fraction is the variance of Student's t with R -
 * 1 degrees of freedom; with it, intervals of one and two standard errors cover 69 and
 * 95 % although s is itself estimated. b is the sampler's bound on light that no path
 * has found and that no spread shows.
 *
 * If the planner has added randomisations to one half (those with even or those with
 * odd numbers) by the variance of the other half, the value is the mean of the means of
 * the halves, whatever their sizes, so that the weight of a half does not depend on its
 * own value.
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

/* Statistics over the randomisations that have paths of all estimators: the value, the
 * variance and third central moment of one, their number, and the standard error
 * without b (NAN for fewer than four). */
struct pp_spread {
    double mean, variance, third, std_error;
    int count;
};

struct pp_spread pp_spread_of_value(const struct pp_sampled *sampled, int value);
struct pp_spread pp_spread_of_part(const struct pp_sampled *sampled, int estimator);

/* Variance of the last value over the randomisations of even (0) or odd number, all
 * finished. */
double pp_spread_variance_of_half(const struct pp_sampled *sampled, int half);

/* Bits of the values whose randomisations differ, for pp_sampler.bound; and all their
 * paths by estimator. */
unsigned pp_spread_found(const struct pp_sampled *sampled);
void pp_spread_paths(const struct pp_sampled *sampled, double *paths);

/* Work that was done. A leak is a ray that left a room between the edges of two surfaces
 * and was given up. */
struct pp_path_work {
    long long paths, rays, leaks;
};

/* Adds the work of all randomisations. */
void pp_spread_add_work(const struct pp_sampled *sampled, struct pp_path_work *work);

/* Correlated share, 0 to 1, of the variance of the last value over `count` points
 * (common_error.h), from the randomisations that all points have. 0 with fewer than
 * eight of these or fewer than two points. */
double pp_spread_common(const struct pp_sampled *points, int count);

/* The factor sqrt((R - 1)/(R - 3)) above, for R > 3. */
double pp_spread_student(int count);

/* All values with their standard errors, which are NAN if fewer than four
 * randomisations are requested. Values are NAN with a reason until four (or as many as
 * requested) are begun. */
void pp_spread_readings(const struct pp_sampled *sampled,
                        struct pp_reading readings[PP_VALUES_MOST]);

#endif
