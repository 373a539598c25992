/* planner.c - the stages and passes of a sampler's calculation.
 *
 * A stage consists of passes. In a pass every unfinished randomisation gets a step, in
 * any order and on any thread. Each randomisation has its own sums, which are added in
 * index order.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/error.h"
#include "simulate/estimate/planner_parts.h"
#include "model/base/array.h"
#include "model/base/clock.h"
#include "simulate/sampling/hash.h"

enum {
    STEP = 1024, /* most paths of a randomisation at a time */
    BLOCK = 64,  /* randomisations processed together if points share samples */
    APART = 64   /* bytes between data written by two threads: a cache line */
};

/* Ratio of a round's target error to that of the previous round, if run by the
 * clock. */
static const double ROUND_SHARE = 0.7;

/* ---- making ---- */

/* Allocates randomisations of a stage, `count` in total; existing ones are kept. */
static enum pp_status make_randomisations(struct pp_planned_point *point,
                                          enum pp_planner_stage stage, int count,
                                          struct pp_error *err)
{
    int there = point->randomisations[stage];
    if (count <= there)
        return PP_OK;
    struct pp_randomisation *more =
        realloc(point->stages[stage], (size_t)count * sizeof *more);
    if (!more)
        return pp_fail_memory(err);
    memset(more + there, 0, (size_t)(count - there) * sizeof *more);
    point->stages[stage] = more;
    point->randomisations[stage] = count;
    return PP_OK;
}

static enum pp_status begin_planned_points(struct pp_planner *planner,
                                           struct pp_error *err)
{
    const struct pp_planner_options *options = &planner->options;
    planner->stage = pp_planner_by_samples(planner) ? PP_FINAL : PP_PILOT;
    planner->round = 1.0;
    planner->unit_count = planner->next_unit = 0;
    int asked = pp_planner_by_samples(planner) ? options->randomisations
                : pp_planner_by_error(planner) ? planner->sampler->pilot_randomisations
                                               : 0;
    int count = asked > 0 ? asked : PP_RANDOMISATIONS;
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < planner->point_count; i++) {
        struct pp_planned_point *point = &planner->points[i];
        point->seed = planner->sampler->seed(planner->client, i);
        point->counts = planner->sampler->pilot;
        for (int k = 0; pp_planner_by_samples(planner) && k < PP_ESTIMATORS_MOST; k++)
            point->counts.of[k] = (uint32_t)fmin((double)options->samples,
                                                 pp_plan_most(planner->sampler, k));
        status = make_randomisations(point, planner->stage, count, err);
    }
    return status;
}

static void *state_of(const struct pp_planner *planner, int worker)
{
    return planner->states + (size_t)worker * planner->state_step;
}

/* PP_BAD_INPUT if an option is out of range. */
static enum pp_status check_planner_options(const struct pp_planner_options *options,
                                            struct pp_error *err)
{
    if (!(options->error >= 0.0 && options->error <= 1.0))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the target standard error is %g; expected a fraction from 0 to 1",
            options->error);
    if (options->samples < 0 || options->samples > PP_MOST_PATHS)
        return pp_fail(err, PP_BAD_INPUT,
                       "the number of samples per point is %ld; expected at most %d",
                       options->samples, (int)PP_MOST_PATHS);
    if (options->threads < 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the number of threads is %d; expected 0 or more",
                       options->threads);
    return PP_OK;
}

enum pp_status pp_planner_create(struct pp_planner **result,
                                 const struct pp_sampler *sampler, const void *client,
                                 int points, const struct pp_planner_options *options,
                                 struct pp_error *err)
{
    *result = NULL;
    enum pp_status status = check_planner_options(options, err);
    if (status != PP_OK)
        return status;
    struct pp_planner *planner = calloc(1, sizeof *planner);
    if (!planner)
        return pp_fail_memory(err);
    planner->sampler = sampler;
    planner->client = client;
    planner->options = *options;
    planner->point_count = planner->most_points = points;
    pp_sobol_init(&planner->sobol);
    planner->points = calloc((size_t)points + 1, sizeof *planner->points);
    status = planner->points ? begin_planned_points(planner, err) : pp_fail_memory(err);
    if (status == PP_OK)
        status = pp_thread_pool_create(&planner->pool, options->threads, err);
    int workers = status == PP_OK ? pp_thread_pool_size(planner->pool) : 0;
    planner->state_step = (sampler->state_size / APART + 2) * APART;
    planner->states = calloc((size_t)workers + 1, planner->state_step);
    if (status == PP_OK && !planner->states)
        status = pp_fail_memory(err);
    if (status != PP_OK) {
        pp_planner_destroy(planner);
        return status;
    }
    for (int i = 0; i < workers; i++)
        sampler->begin(client, state_of(planner, i));
    *result = planner;
    return PP_OK;
}

void pp_planner_destroy(struct pp_planner *planner)
{
    if (!planner)
        return;
    for (int i = 0; planner->points && i < planner->most_points; i++)
        for (int stage = 0; stage < PP_FINISHED; stage++)
            free(planner->points[i].stages[stage]);
    free(planner->points);
    pp_thread_pool_destroy(planner->pool);
    free(planner->states);
    free(planner->units);
    free(planner);
}

void pp_planner_restart(struct pp_planner *planner, int points)
{
    planner->forgotten = pp_planner_work(planner);
    for (int i = 0; i < planner->point_count; i++)
        memset(planner->points[i].stages[PP_FINAL], 0,
               (size_t)planner->points[i].randomisations[PP_FINAL]
                   * sizeof **planner->points[i].stages);
    planner->point_count = points;
    begin_planned_points(planner, NULL); /* creates only what is missing */
}

/* ---- stages ---- */

static double pilot_value(const struct pp_planner *planner, int index)
{
    struct pp_sampled pilot = pp_planner_stage(planner, index, PP_PILOT);
    return fabs(pp_spread_of_value(&pilot, planner->sampler->values - 1).mean);
}

/* Target standard error. If run by error, it follows from the options and the pilot's
 * value. If run by the clock, it is a fraction of the pilot's error. */
static double wanted_error(const struct pp_planner *planner, int index)
{
    const struct pp_planner_options *options = &planner->options;
    if (pp_planner_by_error(planner)) {
        double least = options->least_share * planner->greatest;
        return fmax(options->error * fmax(pilot_value(planner, index), least),
                    options->least_error);
    }
    struct pp_sampled pilot = pp_planner_stage(planner, index, PP_PILOT);
    struct pp_reading readings[PP_VALUES_MOST];
    pp_spread_readings(&pilot, readings);
    return fmax(planner->round * readings[planner->sampler->values - 1].std_error,
                1e-12);
}

/* Plans a point from its pilot. */
static bool foresee(void *data, int worker, int index)
{
    (void)worker;
    struct pp_planner *planner = data;
    struct pp_planned_point *point = &planner->points[index];
    struct pp_sampled pilot = pp_planner_stage(planner, index, PP_PILOT);
    double wanted = wanted_error(planner, index);
    bool may_grow = planner->stage == PP_PILOT && pp_planner_by_error(planner);
    point->grows =
        pp_plan_grows(&pilot, wanted, may_grow, &point->counts, &point->plan);
    return true;
}

/* Plans all points, on all threads. Returns true if a pilot has to grow first. */
static bool foresee_all(struct pp_planner *planner)
{
    bool grows = false;
    planner->greatest = 0.0;
    for (int i = 0; i < planner->point_count && planner->options.least_share > 0.0; i++)
        planner->greatest = fmax(planner->greatest, pilot_value(planner, i));
    pp_thread_pool_run_small(planner->pool, 0, planner->point_count, foresee, planner);
    for (int i = 0; i < planner->point_count; i++)
        grows |= planner->points[i].grows;
    return grows;
}

/* Starts the final stage with the planned paths of each point. If run by the clock,
 * each call starts a further round with more paths, until all points have as many as
 * possible. */
static enum pp_status plan_final(struct pp_planner *planner, struct pp_error *err)
{
    bool again = planner->stage == PP_FINAL, grows = !again;
    planner->stage = PP_FINAL;
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < planner->point_count; i++) {
        struct pp_planned_point *point = &planner->points[i];
        struct pp_plan plan = point->plan;
        bool more = plan.randomisations > point->randomisations[PP_FINAL];
        for (int k = 0; again && k < planner->sampler->estimators; k++) {
            more = more || plan.counts.of[k] > point->counts.of[k];
            if (plan.counts.of[k] < point->counts.of[k])
                plan.counts.of[k] = point->counts.of[k];
        }
        grows |= more;
        for (int k = 0; !more && k < planner->sampler->estimators; k++)
            if (plan.counts.of[k] < pp_plan_most(planner->sampler, k)) {
                plan.counts.of[k] *= 2;
                grows = true;
            }
        point->counts = plan.counts;
        status = make_randomisations(point, PP_FINAL, plan.randomisations, err);
    }
    if (!grows)
        planner->stage = PP_FINISHED;
    return status;
}

/* Plans each half of a point's randomisations from the variance of the other half. */
static bool foresee_halves(void *data, int worker, int index)
{
    (void)worker;
    struct pp_planner *planner = data;
    struct pp_sampled done = pp_planner_stage(planner, index, PP_FINAL);
    pp_plan_halves(&done, wanted_error(planner, index), planner->points[index].halves);
    return true;
}

static int larger_half(const struct pp_planned_point *point)
{
    return point->halves[0] > point->halves[1] ? point->halves[0] : point->halves[1];
}

/* Adds randomisations once if the error exceeds the target. The variance of each half
 * determines how many the other half gets. */
static enum pp_status top_up(struct pp_planner *planner, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    planner->topped_up = true;
    pp_thread_pool_run_small(planner->pool, 0, planner->point_count, foresee_halves,
                             planner);
    for (int i = 0; status == PP_OK && i < planner->point_count; i++) {
        struct pp_planned_point *point = &planner->points[i];
        status = make_randomisations(point, PP_FINAL, 2 * larger_half(point), err);
    }
    return status;
}

static enum pp_status end_stage(struct pp_planner *planner, struct pp_error *err)
{
    if (planner->stage == PP_PILOT
        || (!pp_planner_by_error(planner) && !pp_planner_by_samples(planner))) {
        if (!pp_planner_by_error(planner))
            planner->round *= ROUND_SHARE;
        return foresee_all(planner) ? PP_OK : plan_final(planner, err);
    }
    if (pp_planner_by_error(planner) && !planner->topped_up)
        return top_up(planner, err);
    planner->stage = PP_FINISHED;
    return PP_OK;
}

/* ---- passes ---- */

static bool is_done(const struct pp_planner *planner, int index, int r)
{
    const struct pp_planned_point *point = &planner->points[index];
    const struct pp_randomisation *randomisation = &point->stages[planner->stage][r];
    if (planner->topped_up && r / 2 >= point->halves[r % 2])
        return true;
    for (int k = 0; k < planner->sampler->estimators; k++)
        if (randomisation->done.of[k] < point->counts.of[k])
            return false;
    return true;
}

/* Lists the unfinished randomisations of the block. *most: greatest number of
 * randomisations of any point. */
static enum pp_status list_block(struct pp_planner *planner, int *most,
                                 struct pp_error *err)
{
    planner->unit_count = planner->next_unit = *most = 0;
    for (int i = 0; i < planner->point_count; i++) {
        struct pp_sampled sampled = pp_planner_stage(planner, i, planner->stage);
        enum pp_status status = pp_array_reserve(
            &planner->units, &planner->unit_capacity,
            planner->unit_count + sampled.count, sizeof *planner->units, err);
        if (status != PP_OK)
            return status;
        *most = sampled.count > *most ? sampled.count : *most;
        int end = planner->sampler->prepare ? planner->block + BLOCK : sampled.count;
        for (int k = planner->block; k < sampled.count && k < end; k++)
            if (!is_done(planner, i, k))
                planner->units[planner->unit_count++] = (struct pp_planner_unit){i, k};
    }
    return PP_OK;
}

/* Prepares the samples shared by the units of this pass. */
static enum pp_status prepare_shared_samples(const struct pp_planner *planner,
                                             struct pp_error *err)
{
    struct pp_counts wanted[BLOCK] = {{{0}}};
    for (int i = 0; i < planner->unit_count; i++) {
        struct pp_planner_unit unit = planner->units[i];
        const uint32_t *of = planner->points[unit.point].counts.of;
        uint32_t *most = wanted[unit.randomisation - planner->block].of;
        for (int k = 0; k < planner->sampler->estimators; k++)
            most[k] = of[k] > most[k] ? of[k] : most[k];
    }
    return planner->sampler->prepare(planner->client, (int)planner->stage,
                                     planner->block, BLOCK, wanted, planner->pool, err);
}

/* Lists the unfinished randomisations of the next block that has any, and prepares
 * their shared samples. unit_count is 0 if the stage has none left. */
static enum pp_status list_units(struct pp_planner *planner, struct pp_error *err)
{
    int most;
    enum pp_status status = list_block(planner, &most, err);
    for (; status == PP_OK && planner->unit_count == 0 && planner->block + BLOCK < most;
         status = list_block(planner, &most, err))
        planner->block += BLOCK;
    if (planner->unit_count == 0)
        planner->block = 0;
    else if (status == PP_OK && planner->sampler->prepare)
        status = prepare_shared_samples(planner, err);
    return status;
}

/* Runs a step of one randomisation; the sums do not depend on the lengths of steps. */
static void run_planned_unit(const struct pp_planner *planner,
                             struct pp_planner_unit unit, void *state)
{
    struct pp_planned_point *point = &planner->points[unit.point];
    struct pp_randomisation *randomisation =
        &point->stages[planner->stage][unit.randomisation];
    uint64_t seed = pp_hash(pp_hash(point->seed, (uint64_t)planner->stage),
                            (uint64_t)unit.randomisation);
    for (int k = 0; k < planner->sampler->estimators; k++) {
        struct pp_path_range range = {.point = unit.point,
                                      .randomisation = unit.randomisation,
                                      .estimator = k,
                                      .first = randomisation->done.of[k],
                                      .end = point->counts.of[k]};
        if (range.end <= range.first)
            continue;
        if (range.end - range.first > STEP)
            range.end = range.first + STEP;
        pp_sobol_sequence_init(&range.sequence, &planner->sobol,
                               pp_hash(seed, (uint64_t)k));
        planner->sampler->follow(planner->client, state, &range, randomisation);
        randomisation->done.of[k] = range.end;
    }
}

/* Units that are run until the caller's time is used up. */
struct slice {
    struct pp_planner *planner;
    double end_s;
};

static bool run_unit(void *data, int worker, int index)
{
    const struct slice *slice = data;
    struct pp_planner *planner = slice->planner;
    run_planned_unit(planner, planner->units[index], state_of(planner, worker));
    return pp_clock_s() < slice->end_s;
}

enum pp_status pp_planner_advance(struct pp_planner *planner, double seconds,
                                  struct pp_error *err)
{
    struct slice slice = {planner, pp_clock_s() + seconds};
    while (planner->stage != PP_FINISHED) {
        if (planner->next_unit == planner->unit_count) {
            enum pp_status status = list_units(planner, err);
            if (status == PP_OK && planner->point_count == 0)
                planner->stage = PP_FINISHED;
            else if (status == PP_OK && planner->unit_count == 0)
                status = end_stage(planner, err);
            if (status != PP_OK)
                return status;
            continue;
        }
        planner->next_unit = pp_thread_pool_run_small(
            planner->pool, planner->next_unit, planner->unit_count, run_unit, &slice);
        if (pp_clock_s() >= slice.end_s)
            break;
    }
    return PP_OK;
}

struct pp_thread_pool *pp_planner_crew(const struct pp_planner *planner)
{
    return planner->pool;
}

bool pp_planner_done(const struct pp_planner *planner)
{
    return planner->stage == PP_FINISHED;
}
