/* planner_readings.c - the progress of a planner, and the current values of its
 * points. */
#include <math.h>

#include "simulate/estimate/planner_parts.h"

double pp_planner_progress(const struct pp_planner *planner)
{
    if (planner->stage == PP_FINISHED)
        return 1.0;
    if (!pp_planner_by_error(planner) && !pp_planner_by_samples(planner))
        return 0.0;
    double wanted = 0.0, done = 0.0;
    for (int i = 0; i < planner->point_count; i++) {
        const struct pp_planned_point *point = &planner->points[i];
        struct pp_sampled sampled = pp_planner_stage(planner, i, planner->stage);
        for (int r = 0; r < sampled.count; r++) {
            if (planner->topped_up && r / 2 >= point->halves[r % 2])
                continue;
            for (int k = 0; k < planner->sampler->estimators; k++) {
                double each = point->counts.of[k];
                wanted += each;
                done += fmin(sampled.randomisations[r].done.of[k], each);
            }
        }
    }
    double share = wanted > 0.0 ? done / wanted : 1.0;
    if (pp_planner_by_samples(planner))
        return share;
    return planner->stage == PP_PILOT ? 0.1 * share : 0.1 + 0.9 * share;
}

struct pp_sampled pp_planner_sampled(const struct pp_planner *planner, int point)
{
    return pp_planner_stage(planner, point, PP_FINAL);
}

void pp_planner_read(const struct pp_planner *planner, int point,
                     struct pp_reading readings[PP_VALUES_MOST])
{
    for (int i = 0; i < planner->sampler->values; i++)
        readings[i] = pp_reading_none("not simulated yet");
    for (int stage = PP_FINAL; isnan(readings[0].value) && stage >= PP_PILOT; stage--) {
        struct pp_sampled sampled =
            pp_planner_stage(planner, point, (enum pp_planner_stage)stage);
        if (sampled.count > 0)
            pp_spread_readings(&sampled, readings);
    }
}

double pp_planner_error(const struct pp_planner *planner)
{
    double largest = NAN;
    for (int i = 0; i < planner->point_count; i++) {
        struct pp_reading readings[PP_VALUES_MOST];
        pp_planner_read(planner, i, readings);
        const struct pp_reading *last = &readings[planner->sampler->values - 1];
        if (last->value > 0.0)
            largest = fmax(largest, last->std_error / last->value);
    }
    return largest;
}

struct pp_path_work pp_planner_work(const struct pp_planner *planner)
{
    struct pp_path_work work = planner->forgotten;
    for (int i = 0; i < planner->point_count; i++)
        for (int stage = PP_PILOT; stage < PP_FINISHED; stage++) {
            struct pp_sampled sampled =
                pp_planner_stage(planner, i, (enum pp_planner_stage)stage);
            pp_spread_add_work(&sampled, &work);
        }
    return work;
}
