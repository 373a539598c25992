/* spread.h - from randomisations to a value and its standard error.
 *
 * The value is the mean of R randomisations, and its standard error
 *
 *     sqrt(s^2/R (R - 1)/(R - 3) + b^2),
 *
 * s their standard deviation: the fraction is the variance of Student's t with R - 1
 * degrees of freedom, so that one and two standard errors hold 69 and 95 % although s
 * is itself estimated. b is the sampler's bound on light that no path has found, which
 * no spread shows.
 *
 * If the planner has added to one half of the randomisations, those of even or of odd
 * number, by the variance of the other half, the value is the mean of the two halves'
 * means, whatever their sizes: so neither half's weight depends on its own value.
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

/* Correlated share of the variance of the last value over `count` points, 0 to 1
 * (common_error.h), by the randomisations that all of them have: 0 for fewer than eight
 * of these or fewer than two points. */
double pp_spread_common(const struct pp_sampled *points, int count);

/* The factor sqrt((R - 1)/(R - 3)) above, for R > 3. */
double pp_spread_student(int count);

/* All values with their standard errors, which are NAN if fewer than four
 * randomisations are requested. Values are NAN with a reason until four (or as many as
 * requested) are begun. */
void pp_spread_readings(const struct pp_sampled *sampled,
                        struct pp_reading readings[PP_VALUES_MOST]);

#endif
