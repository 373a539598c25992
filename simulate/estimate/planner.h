/* planner.h - the stages, passes and threads of a sampler's calculation.
 *
 * To reach a target error, a pilot of a few paths at every point estimates the
 * variance. A pilot that is too small is enlarged. All pilots are discarded, and the
 * planned paths (plan.h) are run with fresh seeds. Values are therefore not selected by
 * their own error, and neither the values nor the stated errors are biased. The error
 * may be larger or smaller than the target. If the calculation is limited by the
 * caller's clock, further rounds of twice the paths follow as long as the caller
 * continues. Each round is planned from the pilot alone.
 *
 * The caller runs the loop: advance until done. With a target error or a number of
 * samples, the values depend on the sampler alone. They are bit-identical for any
 * number of threads and any duration of the calls. A point's values do not depend on
 * the other points, except through the greatest value if least_share is set.
 */
#ifndef PP_SIMULATE_ESTIMATE_PLANNER_H
#define PP_SIMULATE_ESTIMATE_PLANNER_H

#include "model/base/thread_pool.h"
#include "simulate/estimate/plan.h"

/* Condition for the end of a sampler's calculation: an error, a number of samples, or
 * the caller's clock. */
struct pp_planner_options {
    double error; /* target standard error relative to the last value. 0: by samples or
                   * by the caller's clock alone */
    double least_error; /* lower limit of the target (in units of the value) */
    double least_share; /* the target is relative to at least this fraction of the
                         * greatest value of all points */
    long samples;       /* paths of each estimator in a randomisation; 0: not set */
    int randomisations; /* by samples; 0: PP_RANDOMISATIONS */
    int threads;        /* 0: as many as there are processors */
};

struct pp_planner;

/* The sampler and its client must outlive the planner. PP_BAD_INPUT if an option is out
 * of range. */
enum pp_status pp_planner_create(struct pp_planner **planner,
                                 const struct pp_sampler *sampler, const void *client,
                                 int points, const struct pp_planner_options *options,
                                 struct pp_error *err);
void pp_planner_destroy(struct pp_planner *planner); /* NULL is allowed */

/* Resets the planner to other points, at most as many as at its creation. Keeps only
 * the work counters. Only for a planner that is run by samples. */
void pp_planner_restart(struct pp_planner *planner, int points);

/* Calculates for about `seconds` (by the clock; at least one step of one
 * randomisation). */
enum pp_status pp_planner_advance(struct pp_planner *planner, double seconds,
                                  struct pp_error *err);
bool pp_planner_done(const struct pp_planner *planner);

/* The pool of worker threads, for other work of the same run. */
struct pp_thread_pool *pp_planner_crew(const struct pp_planner *planner);

/* Fraction of the present plan's work that is done, 0 to 1. */
double pp_planner_progress(const struct pp_planner *planner);

/* Largest relative standard error of any point so far; NAN if no value is known yet. */
double pp_planner_error(const struct pp_planner *planner);

/* All values of a point so far. */
void pp_planner_read(const struct pp_planner *planner, int point,
                     struct pp_reading readings[PP_VALUES_MOST]);

/* The randomisations from which the point's values are calculated. */
struct pp_sampled pp_planner_sampled(const struct pp_planner *planner, int point);

/* The work done so far. */
struct pp_path_work pp_planner_work(const struct pp_planner *planner);

#endif
