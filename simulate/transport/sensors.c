/* sensors.c - randomisations of each sensor point, planned and run in passes.
 *
 * Work goes by passes: every randomisation of every point that wants more paths gets
 * them, in steps, in any order and by any thread; its sum is its own. Between passes,
 * by one thread, each point's spread says how many it is to have in the next. */
#include "simulate/transport/sensors.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/processors.h"
#include "simulate/scene/unsampled.h"
#include "simulate/tracer/estimate.h"
#include "simulate/transport/radiance.h"

enum {
    RANDOMISATIONS = 32,
    FIRST_PATHS = 64,
    MOST_PATHS = 1 << 26, /* of a randomisation */
    BOUND_PATHS =
        1 << 11,      /* from this many on, the bound of unsampled.h asks for no more */
    MOST_GROWTH = 16, /* of a point's paths, from one pass to the next */
    STEP = 256,       /* most paths at a time */
    BATCH = 64        /* steps between looks at the clock */
};

static const double OPEN_SKY_SHARE = 0.00002;
static const double LARGEST_SHARE = 0.001;

struct sensor_randomisation {
    struct pp_rgb sum;
    long paths;
};

struct sensor_state {
    struct sensor_randomisation randomisations[RANDOMISATIONS];
    enum pp_space space;
    long wanted; /* paths of each */
    bool done;
};

struct sensor_unit {
    int point, randomisation;
};

struct pp_sensors {
    const struct pp_light_scene *scene; /* not owned */
    const struct pp_sensor *list;       /* not owned */
    int count;
    struct pp_sensors_options options;
    struct pp_sobol sobol;
    struct sensor_state *points;
    struct sensor_unit *units; /* of this pass */
    int unit_count, next_unit;
};

/* ---- reading ---- */

/* Mean over the randomisations, and its standard error: s / sqrt(R), widened by the
 * spread of Student's t, as estimate.h has it. */
static double mean_of(const double *values, int count, double *error)
{
    double sum = 0.0, off = 0.0;
    for (int i = 0; i < count; i++)
        sum += values[i];
    double mean = sum / count;
    for (int i = 0; i < count; i++)
        off += (values[i] - mean) * (values[i] - mean);
    *error = sqrt(off / (count - 1) / count) * pp_estimate_student_factor(count);
    return mean;
}

static struct pp_sensor_reading read(const struct pp_sensors *sensors, int index,
                                     bool with_unsampled)
{
    const struct sensor_state *point = &sensors->points[index];
    double values[4][RANDOMISATIONS], means[4], errors[4];
    int count = 0;
    long paths = 0;
    for (int i = 0; i < RANDOMISATIONS; i++) {
        const struct sensor_randomisation *randomisation = &point->randomisations[i];
        if (randomisation->paths == 0)
            continue;
        struct pp_rgb mean =
            pp_rgb_scale(randomisation->sum, 1.0 / (double)randomisation->paths);
        values[0][count] = mean.r;
        values[1][count] = mean.g;
        values[2][count] = mean.b;
        values[3][count++] = pp_rgb_luminance(mean);
        paths += randomisation->paths;
    }
    for (int k = 0; k < 4; k++) {
        means[k] = errors[k] = NAN;
        if (count < 4)
            continue;
        means[k] = mean_of(values[k], count, &errors[k]);
        /* Where all agree but for rounding, one path of all might still have brought as
         * much. */
        if (!(errors[k] > 1e-12 * means[k]))
            errors[k] = fmax(means[k], sensors->options.horizontal) / (double)paths;
    }
    if (with_unsampled && count >= 4) {
        struct pp_rgb bound =
            pp_unsampled_bound(sensors->scene, sensors->list[index].position,
                               sensors->options.by_chance, paths);
        const double of[] = {bound.r, bound.g, bound.b, pp_rgb_luminance(bound)};
        for (int k = 0; k < 4; k++)
            errors[k] = fmax(errors[k], of[k]);
    }
    return (struct pp_sensor_reading){.irradiance = {means[0], means[1], means[2]},
                                      .std_error = {errors[0], errors[1], errors[2]},
                                      .grey = means[3],
                                      .grey_error = errors[3]};
}

struct pp_sensor_reading pp_sensors_read(const struct pp_sensors *sensors, int index)
{
    return read(sensors, index, true);
}

double pp_sensors_error(const struct pp_sensors *sensors)
{
    double worst = NAN;
    for (int i = 0; i < sensors->count; i++) {
        struct pp_sensor_reading reading = pp_sensors_read(sensors, i);
        if (reading.grey > 0.0)
            worst = fmax(worst, reading.grey_error / reading.grey);
    }
    return worst;
}

/* ---- planning ---- */

static double largest_value(const struct pp_sensors *sensors)
{
    double largest = 0.0;
    for (int i = 0; i < sensors->count; i++)
        largest = fmax(largest, pp_sensors_read(sensors, i).grey);
    return largest;
}

/* Sets how many paths the point is to have: more by a power of two, or no more. */
static void plan_point(struct pp_sensors *sensors, int index, double largest)
{
    const struct pp_sensors_options *options = &sensors->options;
    struct sensor_state *point = &sensors->points[index];
    struct pp_sensor_reading reading =
        read(sensors, index, point->wanted < BOUND_PATHS);
    double goal = fmax(options->error * fmax(reading.grey, LARGEST_SHARE * largest),
                       OPEN_SKY_SHARE * options->horizontal);
    if (options->error <= 0.0)
        goal = 0.0; /* the caller's clock says when to stop */
    point->done = reading.grey_error <= goal || point->wanted >= MOST_PATHS;
    if (point->done)
        return;
    double growth = 2.0;
    if (goal > 0.0)
        growth = reading.grey_error / goal * (reading.grey_error / goal);
    long times = 2;
    while (times < MOST_GROWTH && (double)times < growth)
        times *= 2;
    point->wanted *= times;
}

/* The next pass; none where all is done. */
static void plan(struct pp_sensors *sensors)
{
    bool first = sensors->unit_count == 0;
    double largest = first ? 0.0 : largest_value(sensors);
    for (int i = 0; i < sensors->count && !first; i++) {
        struct sensor_state *point = &sensors->points[i];
        if (sensors->options.samples > 0)
            point->done = true;
        if (!point->done)
            plan_point(sensors, i, largest);
    }
    sensors->unit_count = sensors->next_unit = 0;
    for (int i = 0; i < sensors->count; i++)
        for (int k = 0; k < RANDOMISATIONS && !sensors->points[i].done; k++)
            sensors->units[sensors->unit_count++] = (struct sensor_unit){i, k};
}

bool pp_sensors_done(const struct pp_sensors *sensors)
{
    return sensors->unit_count == 0;
}

double pp_sensors_progress(const struct pp_sensors *sensors)
{
    double done = 0.0, all = 0.0;
    for (int i = 0; i < sensors->count; i++)
        for (int k = 0; k < RANDOMISATIONS; k++) {
            done += (double)sensors->points[i].randomisations[k].paths;
            all += (double)sensors->points[i].wanted;
        }
    return all > 0.0 ? done / all : 1.0;
}

/* ---- working ---- */

/* Up to STEP more paths of one randomisation. */
static void step(struct pp_sensors *sensors, struct sensor_unit unit)
{
    struct sensor_state *point = &sensors->points[unit.point];
    struct sensor_randomisation *randomisation =
        &point->randomisations[unit.randomisation];
    const struct pp_sensor *sensor = &sensors->list[unit.point];
    struct pp_radiance_state state = {.scene = sensors->scene,
                                      .options = pp_radiance_options_defaults()};
    state.options.sources = !sensors->options.by_chance;
    uint64_t seed = pp_hash(pp_hash(sensors->options.seed, (uint64_t)unit.point),
                            (uint64_t)unit.randomisation);
    pp_sobol_sequence_init(&state.sequence, &sensors->sobol, seed);
    long end = randomisation->paths + STEP < point->wanted ? randomisation->paths + STEP
                                                           : point->wanted;
    for (; randomisation->paths < end; randomisation->paths++) {
        state.index = (uint32_t)randomisation->paths;
        struct pp_irradiance e = pp_radiance_irradiance(&state, sensor->position,
                                                        sensor->normal, point->space);
        randomisation->sum = pp_rgb_add(randomisation->sum, pp_irradiance_sum(&e));
    }
}

/* The units that still want paths, in their order. */
static void leave_out_done(struct pp_sensors *sensors)
{
    int kept = 0;
    for (int i = 0; i < sensors->unit_count; i++) {
        const struct sensor_state *point = &sensors->points[sensors->units[i].point];
        if (point->randomisations[sensors->units[i].randomisation].paths
            < point->wanted)
            sensors->units[kept++] = sensors->units[i];
    }
    sensors->next_unit = 0;
    sensors->unit_count = kept;
}

void pp_sensors_advance(struct pp_sensors *sensors, double seconds)
{
    double until = pp_clock_s() + seconds;
    int threads =
        sensors->options.threads > 0 ? sensors->options.threads : pp_processors();
    do {
        int left = sensors->unit_count - sensors->next_unit;
        int count = left < BATCH ? left : BATCH;
        const struct sensor_unit *units = sensors->units + sensors->next_unit;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
        for (int i = 0; i < count; i++)
            step(sensors, units[i]);
        sensors->next_unit += count;
        if (sensors->next_unit < sensors->unit_count)
            continue;
        int all = sensors->unit_count;
        leave_out_done(sensors);
        if (sensors->unit_count == 0) {
            sensors->unit_count = all; /* a pass is over */
            plan(sensors);
        }
    } while (sensors->unit_count > 0 && pp_clock_s() < until);
}

enum pp_status pp_sensors_create(struct pp_sensors **result,
                                 const struct pp_light_scene *scene,
                                 const struct pp_sensor *list, int count,
                                 const struct pp_sensors_options *options,
                                 struct pp_error *err)
{
    *result = NULL;
    struct pp_sensors *sensors = calloc(1, sizeof *sensors);
    if (!sensors)
        return pp_fail_memory(err);
    sensors->scene = scene;
    sensors->list = list;
    sensors->count = count;
    sensors->options = *options;
    pp_sobol_init(&sensors->sobol);
    sensors->points = calloc((size_t)count + 1, sizeof *sensors->points);
    sensors->units = calloc((size_t)count * RANDOMISATIONS + 1, sizeof *sensors->units);
    if (!sensors->points || !sensors->units) {
        pp_sensors_destroy(sensors);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < count; i++) {
        sensors->points[i].space = pp_light_scene_space(scene, list[i].position);
        sensors->points[i].wanted = FIRST_PATHS;
        if (options->samples > 0)
            sensors->points[i].wanted = options->samples;
    }
    plan(sensors);
    *result = sensors;
    return PP_OK;
}

void pp_sensors_destroy(struct pp_sensors *sensors)
{
    if (!sensors)
        return;
    free(sensors->points);
    free(sensors->units);
    free(sensors);
}
