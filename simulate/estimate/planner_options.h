/* planner_options.h - how far a sampler's work is to go. */
#ifndef PP_SIMULATE_ESTIMATE_PLANNER_OPTIONS_H
#define PP_SIMULATE_ESTIMATE_PLANNER_OPTIONS_H

#include "model/base/error.h"

struct pp_planner_options {
    double error; /* target standard error over the last value. 0: by samples or the
                   * caller's clock alone */
    double least_error; /* least standard error aimed at */
    double least_share; /* least relative error, of this share of the greatest value of
                         * all points */
    long samples;       /* paths of each estimator in a randomisation; 0: not set */
    int randomisations; /* by samples; 0: PP_RANDOMISATIONS */
    int threads;        /* 0: one for each processor */
};

/* PP_BAD_INPUT where one is out of range. */
enum pp_status pp_planner_options_check(const struct pp_planner_options *options,
                                        struct pp_error *err);

#endif
