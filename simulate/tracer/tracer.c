/* tracer.c - the tracer's points, and the stages and passes of its work.
 *
 * To reach an error, a pilot of a few paths at every point shows how variable the point
 * is and is thrown away; the paths that it asks for are then run with fresh seeds, so
 * that no value was ever chosen for its error. Where the outcome falls short all the
 * same, randomisations are added. By the caller's clock, rounds double the paths.
 *
 * A stage goes by passes: every randomisation that is not done gets a step, in any
 * order and by any thread. Its sum is its own, and readings are added up in index
 * order. */
#include "simulate/tracer/tracer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/clock.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/processors.h"
#include "simulate/tracer/estimate.h"
#include "simulate/tracer/radiosity_solve.h"

enum {
    STEP = 1024, /* most paths of a randomisation at a time */
    FIRST_BATCH = 64,
    MOST_BATCH = 8192
};

/* Paths of each estimator in a randomisation: of the pilot, and at least in the end. */
static const struct pp_counts PILOT_COUNTS = {{8, 8, 2}};
static const struct pp_counts LEAST_COUNTS = {{16, 8, 2}};

enum stage { PILOT, FINAL, FINISHED };

/* A receiver, or the working plane as a whole, with its randomisations. */
struct traced_point {
    struct pp_start start;
    struct pp_component_bound most;
    uint64_t seed;
    struct pp_counts counts; /* wanted of each randomisation */
    struct pp_randomisation *pilot, *randomisations;
    int randomisation_count;
};

struct tracer_unit {
    int point, randomisation;
};

struct pp_tracer {
    struct pp_tracer_options options;
    int threads;
    struct pp_sobol sobol;
    struct pp_ray_scene *scene;
    struct pp_radiosity *radiosity;
    struct traced_point *points; /* the receivers, then the average if it is wanted */
    int point_count, receiver_count;

    enum stage stage;
    struct tracer_unit *units; /* of this pass */
    int unit_count, unit_capacity, next_unit;
    int batch; /* units at a time */
};

static bool goes_by_error(const struct pp_tracer *tracer)
{
    return tracer->options.error > 0.0 && tracer->options.samples == 0;
}

static struct pp_counts all_of(uint32_t paths)
{
    return (struct pp_counts){{paths, paths, paths}};
}

/* ---- making ---- */

static uint64_t seed_of_room(uint64_t seed, const struct pp_world *world)
{
    for (const char *c = world->name ? world->name : ""; *c; c++)
        seed = pp_hash(seed, (unsigned char)*c);
    return pp_hash(seed, 0);
}

/* Random numbers depend on where a receiver is, not on which others there are. */
static uint64_t seed_of_receiver(uint64_t seed, const struct pp_receiver *receiver)
{
    return pp_hash_vec(pp_hash_vec(seed, receiver->position), receiver->normal);
}

static void make_points(struct pp_tracer *tracer, const struct pp_receiver *receivers,
                        uint64_t seed)
{
    for (int i = 0; i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        if (i < tracer->receiver_count) {
            point->start.position =
                pp_vec_sub(receivers[i].position, tracer->scene->centre);
            point->start.normal = receivers[i].normal;
            point->seed = seed_of_receiver(seed, &receivers[i]);
        } else {
            point->start = (struct pp_start){true, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
            point->seed = pp_hash(seed, UINT64_MAX);
        }
        point->most = pp_estimate_bound(tracer->scene, &point->start);
    }
}

/* `count` fresh randomisations in *randomisations; those that are there stay. */
static enum pp_status make_randomisations(struct pp_randomisation **randomisations,
                                          int there, int count, uint64_t seed,
                                          struct pp_error *err)
{
    struct pp_randomisation *more =
        realloc(*randomisations, (size_t)count * sizeof *more);
    if (!more)
        return pp_fail_memory(err);
    *randomisations = more;
    for (int i = there; i < count; i++)
        more[i] = (struct pp_randomisation){.seed = pp_hash(seed, (uint64_t)i)};
    return PP_OK;
}

static uint64_t stage_seed(const struct traced_point *point, enum stage stage)
{
    return pp_hash(point->seed, (uint64_t)stage);
}

/* The first stage: the pilot where an error is wanted, else the paths themselves. */
static enum pp_status begin(struct pp_tracer *tracer, struct pp_error *err)
{
    tracer->stage = goes_by_error(tracer) ? PILOT : FINAL;
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        point->randomisation_count = PP_RANDOMISATIONS;
        point->counts = PILOT_COUNTS;
        if (tracer->options.samples > 0)
            point->counts = all_of((uint32_t)tracer->options.samples);
        struct pp_randomisation **randomisations =
            tracer->stage == PILOT ? &point->pilot : &point->randomisations;
        status = make_randomisations(randomisations, 0, point->randomisation_count,
                                     stage_seed(point, tracer->stage), err);
    }
    return status;
}

static enum pp_status check_options(const struct pp_tracer_options *options,
                                    struct pp_error *err)
{
    if (!(options->error >= 0.0 && options->error < 1.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "a standard error of %g cannot be aimed at; expected a fraction "
                       "from 0 to 1",
                       options->error);
    if (options->samples < 0 || options->samples > PP_MOST_PATHS)
        return pp_fail(err, PP_BAD_INPUT,
                       "%ld samples a point are not possible; expected up to %d",
                       options->samples, (int)PP_MOST_PATHS);
    if (options->threads < 0)
        return pp_fail(err, PP_BAD_INPUT, "%d threads are not possible",
                       options->threads);
    return PP_OK;
}

enum pp_status pp_tracer_create(struct pp_tracer **result, const struct pp_world *world,
                                const struct pp_receiver *receivers, int receiver_count,
                                const struct pp_tracer_options *options,
                                struct pp_error *err)
{
    *result = NULL;
    enum pp_status status = check_options(options, err);
    if (status != PP_OK)
        return status;
    struct pp_tracer *tracer = calloc(1, sizeof *tracer);
    if (!tracer)
        return pp_fail_memory(err);
    tracer->options = *options;
    tracer->threads = options->threads > 0 ? options->threads : pp_processors();
    tracer->batch = FIRST_BATCH;
    tracer->receiver_count = receiver_count;
    pp_sobol_init(&tracer->sobol);

    uint64_t seed = seed_of_room(options->seed, world);
    status = pp_ray_scene_create(&tracer->scene, world, err);
    if (status == PP_OK)
        status =
            pp_radiosity_solve(&tracer->radiosity, tracer->scene, world, &tracer->sobol,
                               pp_hash(seed, 1), tracer->threads, err);
    if (status == PP_OK) {
        bool average = options->average && tracer->scene->plane_count > 0;
        tracer->point_count = receiver_count + average;
        tracer->points =
            calloc((size_t)tracer->point_count + 1, sizeof *tracer->points);
        status = tracer->points ? PP_OK : pp_fail_memory(err);
    }
    if (status == PP_OK) {
        make_points(tracer, receivers, seed);
        status = begin(tracer, err);
    }
    if (status != PP_OK) {
        pp_tracer_destroy(tracer);
        return status;
    }
    *result = tracer;
    return PP_OK;
}

void pp_tracer_destroy(struct pp_tracer *tracer)
{
    if (!tracer)
        return;
    for (int i = 0; tracer->points && i < tracer->point_count; i++) {
        free(tracer->points[i].pilot);
        free(tracer->points[i].randomisations);
    }
    free(tracer->points);
    free(tracer->units);
    pp_radiosity_destroy(tracer->radiosity);
    pp_ray_scene_destroy(tracer->scene);
    free(tracer);
}

/* ---- stages ---- */

static struct pp_randomisation *randomisations_of(const struct pp_tracer *tracer,
                                                  struct traced_point *point)
{
    return tracer->stage == PILOT ? point->pilot : point->randomisations;
}

static double wanted_error(const struct pp_tracer *tracer, double daylight_factor)
{
    return fmax(tracer->options.error * fabs(daylight_factor), PP_LEAST_ERROR);
}

/* The paths that each point needs, planned from its pilot. */
static enum pp_status plan_final(struct pp_tracer *tracer, struct pp_error *err)
{
    for (int i = 0; i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        struct pp_reading df =
            pp_estimate(point->pilot, point->randomisation_count, PP_DF, &point->most);
        struct pp_plan plan =
            pp_estimate_plan(point->pilot, point->randomisation_count,
                             wanted_error(tracer, df.value), LEAST_COUNTS);
        point->counts = plan.counts;
        point->randomisation_count = plan.randomisations;
        enum pp_status status =
            make_randomisations(&point->randomisations, 0, plan.randomisations,
                                stage_seed(point, FINAL), err);
        if (status != PP_OK)
            return status;
    }
    tracer->stage = FINAL;
    return PP_OK;
}

/* More randomisations where the error is above what was asked for. */
static enum pp_status top_up(struct pp_tracer *tracer, struct pp_error *err)
{
    tracer->stage = FINISHED;
    for (int i = 0; i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        struct pp_reading df = pp_estimate(
            point->randomisations, point->randomisation_count, PP_DF, &point->most);
        double ratio = df.std_error / wanted_error(tracer, df.value);
        if (!(ratio > 1.0))
            continue;
        int there = point->randomisation_count;
        int count = (int)ceil(there * fmin(ratio * ratio, 4.0)) + 2;
        enum pp_status status = make_randomisations(
            &point->randomisations, there, count, stage_seed(point, FINAL), err);
        if (status != PP_OK)
            return status;
        point->randomisation_count = count;
        tracer->stage = FINAL;
    }
    return PP_OK;
}

/* Half the variance everywhere, by the clock for as long as the caller likes. */
static void go_on(struct pp_tracer *tracer)
{
    for (int i = 0; i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        struct pp_reading df = pp_estimate(
            point->randomisations, point->randomisation_count, PP_DF, &point->most);
        struct pp_plan plan =
            pp_estimate_plan(point->randomisations, point->randomisation_count,
                             fmax(df.std_error * 0.7, 1e-12), point->counts);
        point->counts = plan.counts;
    }
}

static enum pp_status end_stage(struct pp_tracer *tracer, struct pp_error *err)
{
    if (tracer->stage == PILOT)
        return plan_final(tracer, err);
    if (tracer->options.samples > 0)
        tracer->stage = FINISHED;
    else if (goes_by_error(tracer))
        return top_up(tracer, err);
    else
        go_on(tracer);
    return PP_OK;
}

/* ---- passes ---- */

static double cost_to_do(const struct pp_randomisation *randomisation,
                         struct pp_counts wanted)
{
    double cost = 0.0;
    for (int k = 0; k < PP_ESTIMATORS; k++)
        if (wanted.of[k] > randomisation->done.of[k])
            cost += wanted.of[k] - randomisation->done.of[k];
    return cost;
}

/* Lists the randomisations that are not done in this stage; none: unit_count 0. */
static enum pp_status list_units(struct pp_tracer *tracer, struct pp_error *err)
{
    tracer->unit_count = tracer->next_unit = 0;
    for (int i = 0; i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        const struct pp_randomisation *randomisations =
            randomisations_of(tracer, point);
        enum pp_status status =
            pp_array_reserve(&tracer->units, &tracer->unit_capacity,
                             tracer->unit_count + point->randomisation_count,
                             sizeof *tracer->units, err);
        if (status != PP_OK)
            return status;
        for (int k = 0; k < point->randomisation_count; k++)
            if (!pp_randomisation_is_done(&randomisations[k], point->counts))
                tracer->units[tracer->unit_count++] = (struct tracer_unit){i, k};
    }
    return PP_OK;
}

static void run_batch(struct pp_tracer *tracer, int first, int end)
{
#pragma omp parallel num_threads(tracer->threads)
    {
        struct pp_path_state state = {.scene = tracer->scene,
                                      .radiosity = tracer->radiosity,
                                      .every_ray = tracer->options.every_ray};
#pragma omp for schedule(dynamic, 1)
        for (int i = first; i < end; i++) {
            struct tracer_unit unit = tracer->units[i];
            struct traced_point *point = &tracer->points[unit.point];
            pp_randomisation_run(&randomisations_of(tracer, point)[unit.randomisation],
                                 &state, &tracer->sobol, &point->start, point->counts,
                                 STEP);
        }
    }
}

enum pp_status pp_tracer_advance(struct pp_tracer *tracer, double seconds,
                                 struct pp_error *err)
{
    double start = pp_clock_s(), before = start;
    while (tracer->stage != FINISHED) {
        if (tracer->next_unit == tracer->unit_count) {
            enum pp_status status = list_units(tracer, err);
            if (status == PP_OK && tracer->unit_count == 0) {
                if (tracer->point_count == 0)
                    tracer->stage = FINISHED;
                else
                    status = end_stage(tracer, err);
            }
            if (status != PP_OK)
                return status;
            continue;
        }
        int end = tracer->next_unit + tracer->batch;
        if (end > tracer->unit_count)
            end = tracer->unit_count;
        run_batch(tracer, tracer->next_unit, end);
        tracer->next_unit = end;

        /* Batches of a few milliseconds: long enough to share out, short enough to
         * stop. */
        double after = pp_clock_s();
        if (after - before < 0.002 && tracer->batch < MOST_BATCH)
            tracer->batch *= 2;
        if (after - before > 0.02 && tracer->batch > FIRST_BATCH)
            tracer->batch /= 2;
        before = after;
        if (after - start >= seconds)
            break;
    }
    return PP_OK;
}

/* ---- readings ---- */

bool pp_tracer_done(const struct pp_tracer *tracer)
{
    return tracer->stage == FINISHED;
}

double pp_tracer_progress(const struct pp_tracer *tracer)
{
    if (tracer->stage == FINISHED)
        return 1.0;
    if (!goes_by_error(tracer) && tracer->options.samples == 0)
        return 0.0;
    double wanted = 0.0, to_do = 0.0;
    for (int i = 0; i < tracer->point_count; i++) {
        struct traced_point *point = &tracer->points[i];
        const struct pp_randomisation *randomisations =
            randomisations_of(tracer, point);
        for (int k = 0; k < point->randomisation_count; k++) {
            struct pp_randomisation nothing = {.seed = 0};
            wanted += cost_to_do(&nothing, point->counts);
            to_do += cost_to_do(&randomisations[k], point->counts);
        }
    }
    double share = wanted > 0.0 ? 1.0 - to_do / wanted : 1.0;
    if (!goes_by_error(tracer))
        return share;
    return tracer->stage == PILOT ? 0.1 * share : 0.1 + 0.9 * share;
}

static struct pp_reading reading_of(const struct traced_point *point, int component)
{
    struct pp_reading reading = pp_reading_none("not sampled yet");
    if (point->randomisations)
        reading = pp_estimate(point->randomisations, point->randomisation_count,
                              component, &point->most);
    if (isnan(reading.value) && point->pilot)
        reading = pp_estimate(point->pilot, PP_RANDOMISATIONS, component, &point->most);
    return reading;
}

double pp_tracer_error(const struct pp_tracer *tracer)
{
    double largest = NAN;
    for (int i = 0; i < tracer->point_count; i++) {
        struct pp_reading df = reading_of(&tracer->points[i], PP_DF);
        if (df.value > 0.0)
            largest = fmax(largest, df.std_error / df.value);
    }
    return largest;
}

void pp_tracer_read(const struct pp_tracer *tracer, int index,
                    struct pp_reading readings[PP_COMPONENT_COUNT])
{
    if (index < 0)
        index = tracer->receiver_count;
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        readings[i] = index < tracer->point_count
                          ? reading_of(&tracer->points[index], i)
                          : pp_reading_none("no average was asked for");
}

struct pp_tracer_work pp_tracer_work(const struct pp_tracer *tracer)
{
    struct pp_tracer_work work = {0, 0, 0};
    for (int i = 0; i < tracer->point_count; i++) {
        const struct traced_point *point = &tracer->points[i];
        const struct pp_randomisation *lists[2] = {point->pilot, point->randomisations};
        const int counts[2] = {PP_RANDOMISATIONS, point->randomisation_count};
        for (int list = 0; list < 2; list++)
            for (int k = 0; lists[list] && k < counts[list]; k++)
                for (int e = 0; e < PP_ESTIMATORS; e++) {
                    work.paths += lists[list][k].done.of[e];
                    work.rays += lists[list][k].rays[e];
                    work.leaks += e == 0 ? lists[list][k].leaks : 0;
                }
    }
    return work;
}
