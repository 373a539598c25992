/* planner_parts.h - members of a planner. Inside simulate/estimate/ only. */
#ifndef PP_SIMULATE_ESTIMATE_PLANNER_PARTS_H
#define PP_SIMULATE_ESTIMATE_PLANNER_PARTS_H

#include "simulate/estimate/planner.h"

enum pp_planner_stage { PP_PILOT, PP_FINAL, PP_FINISHED };

struct pp_planned_point {
    uint64_t seed;
    struct pp_counts counts;            /* number of paths for each randomisation of the
                                         * stage */
    struct pp_plan plan;                /* plan from the pilot; not valid if `grows` */
    bool grows;                         /* the pilot must be enlarged first */
    struct pp_randomisation *stages[2]; /* randomisations of the pilot, and final
                                         * ones */
    int randomisations[2];
    int halves[2]; /* target numbers of final randomisations, even and odd */
};

struct pp_planner_unit {
    int point, randomisation;
};

struct pp_planner {
    const struct pp_sampler *sampler; /* not owned */
    const void *client;               /* not owned */
    struct pp_planner_options options;
    struct pp_sobol sobol;
    struct pp_thread_pool *pool;
    char *states; /* thread states, `state_step` bytes apart */
    size_t state_step;
    struct pp_planned_point *points;
    int point_count, most_points;

    enum pp_planner_stage stage;
    bool topped_up;
    double greatest; /* greatest value of the pilots, if options.least_share is set */
    double round;    /* by the clock: the target as a fraction of the pilot's error */
    struct pp_planner_unit *units; /* units of this pass */
    int unit_count, unit_capacity, next_unit;
    int block; /* if points share samples: first randomisation of this pass */
    struct pp_path_work forgotten; /* work before the last restart */
};

static inline bool pp_planner_by_samples(const struct pp_planner *planner)
{
    return planner->options.samples > 0;
}

static inline bool pp_planner_by_error(const struct pp_planner *planner)
{
    return planner->options.error > 0.0 && !pp_planner_by_samples(planner);
}

/* Samples of a point in a stage. */
static inline struct pp_sampled pp_planner_stage(const struct pp_planner *planner,
                                                 int index, enum pp_planner_stage stage)
{
    const struct pp_planned_point *point = &planner->points[index];
    return (struct pp_sampled){planner->sampler, planner->client, index,
                               point->stages[stage], point->randomisations[stage]};
}

#endif
