/* sampler.h - interface of sampled quantities: points whose values are sums of
 * expectations, each the mean over random paths. The daylight factors of a room's
 * points, the irradiances of sensors and the pixels of a picture are samplers; the
 * planner (planner.h) assigns paths to each.
 *
 * A randomisation of a point is one scramble of the Sobol sequence (sobol.h) for each
 * estimator. Randomisations are independent and identically distributed, so that their
 * spread gives the standard error. The unit of work is one randomisation of one point.
 */
#ifndef PP_SIMULATE_ESTIMATE_SAMPLER_H
#define PP_SIMULATE_ESTIMATE_SAMPLER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/base/thread_pool.h"
#include "simulate/sampling/sobol.h"

enum { PP_ESTIMATORS_MOST = 4, PP_VALUES_MOST = 4, PP_SUMS_MOST = 7 };

/* Numbers of paths, by estimator. */
struct pp_counts {
    uint32_t of[PP_ESTIMATORS_MOST];
};

/* The sums over the paths of one randomisation. */
struct pp_randomisation {
    double sums[PP_SUMS_MOST];
    struct pp_counts done;
    long rays[PP_ESTIMATORS_MOST]; /* traced, by estimator */
    long leaks;                    /* rays lost between the edges of two surfaces */
};

/* Range of requested paths of a sequence: from `first` up to, but not including,
 * `end`. */
struct pp_path_range {
    int point, randomisation, estimator;
    struct pp_sobol_sequence sequence;
    uint32_t first, end;
};

struct pp_sampler {
    int estimators; /* number of estimators of each point */
    int values;     /* number of values that are read from the sums; the target error
                     * applies to the last one */

    /* The variance of an estimator's mean over n paths falls as n to the power
     * -fall. */
    double fall[PP_ESTIMATORS_MOST];

    /* Numbers of paths of each estimator in a randomisation: in the pilot, and the
     * least in the final stage. */
    struct pp_counts pilot, least;

    /* Number of randomisations of the pilot, if run by error: even; 0:
     * PP_RANDOMISATIONS (plan.h). Fewer are enough if values have little skew. */
    int pilot_randomisations;

    /* Greatest number of paths of each estimator in a randomisation; 0: no limit. */
    struct pp_counts most;

    /* Cost of a path in addition to its rays, in rays; 0: 1. */
    double cost[PP_ESTIMATORS_MOST];

    /* Cost, in rays, of each randomisation beyond PP_RANDOMISATIONS (plan.h), in
     * addition to its paths. */
    double cost_of_more;

    /* Makes the samples that points share, before paths are followed. The samples are
     * for randomisations `first` to first + count - 1 of a stage, each with its own
     * seed, and for the greatest number of paths of each estimator. Earlier samples are
     * no longer needed, except for the same `first` of the same stage. pool: the
     * threads to use. The callback is NULL if points share no samples. */
    enum pp_status (*prepare)(const void *client, int stage, int first, int count,
                              const struct pp_counts *wanted,
                              struct pp_thread_pool *pool, struct pp_error *err);

    /* A thread's own state. */
    size_t state_size;
    void (*begin)(const void *client, void *state);

    /* Seed of the point's random numbers. */
    uint64_t (*seed)(const void *client, int point);

    /* Adds the paths to the randomisation's sums, rays and leaks. */
    void (*follow)(const void *client, void *state, const struct pp_path_range *range,
                   struct pp_randomisation *randomisation);

    /* A value from one randomisation that has paths of all estimators. */
    double (*value)(const void *client, int point,
                    const struct pp_randomisation *randomisation, int value);

    /* The contribution of one estimator to the last value; NULL if there is only one
     * estimator. */
    double (*part)(const void *client, int point,
                   const struct pp_randomisation *randomisation, int estimator);

    /* Upper bound on light that the paths may have missed, which the spread of a value
     * does not show. paths: numbers of paths of each estimator, over all
     * randomisations. found: bit i is set if the randomisations of value i differ.
     * NULL: no bound. */
    double (*bound)(const void *client, int point, int value, unsigned found,
                    const double *paths);
};

#endif
