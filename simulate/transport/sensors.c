/* sensors.c - sensor points as a sampler of irradiance. */
#include "simulate/transport/sensors.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/estimate/planner.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/unsampled.h"
#include "simulate/transport/radiance.h"

/* The values; the last is the luminance-weighted one. */
enum { RED, GREEN, BLUE, GREY, VALUES };

static const double OPEN_SKY_SHARE = 0.00002;
static const double LARGEST_SHARE = 0.001;

struct sensor_point {
    struct pp_vec3 position, normal;
    enum pp_space space;
    uint64_t seed;
    struct pp_unsampled unsampled;
};

struct pp_sensors {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_environment *environment; /* not owned */
    struct sensor_point *points;
    int count;
    bool by_chance;
    int bounces; /* -1: no limit */
    bool ground_counts;
    struct pp_planner *planner;
};

/* ---- the sampler ---- */

static void begin_sensor_state(const void *client, void *state)
{
    const struct pp_sensors *sensors = client;
    struct pp_radiance_state *radiance = state;
    *radiance = (struct pp_radiance_state){.scene = sensors->scene,
                                           .environment = sensors->environment,
                                           .options = pp_radiance_state_defaults()};
    radiance->options.sources = !sensors->by_chance;
    radiance->options.bounces = sensors->bounces;
    radiance->options.ground_counts = sensors->ground_counts;
}

static uint64_t sensor_seed(const void *client, int point)
{
    return ((const struct pp_sensors *)client)->points[point].seed;
}

static void follow_sensor_paths(const void *client, void *state,
                                const struct pp_path_range *range,
                                struct pp_randomisation *randomisation)
{
    const struct pp_sensors *sensors = client;
    const struct sensor_point *point = &sensors->points[range->point];
    struct pp_radiance_state *radiance = state;
    long rays = radiance->rays, leaks = radiance->leaks;
    radiance->sequence = range->sequence;
    for (uint32_t i = range->first; i < range->end; i++) {
        radiance->index = i;
        struct pp_irradiance e = pp_radiance_irradiance(radiance, point->position,
                                                        point->normal, point->space);
        struct pp_rgb sum = pp_irradiance_sum(&e);
        randomisation->sums[RED] += sum.r;
        randomisation->sums[GREEN] += sum.g;
        randomisation->sums[BLUE] += sum.b;
    }
    randomisation->rays[0] += radiance->rays - rays;
    randomisation->leaks += radiance->leaks - leaks;
}

static double of_channel(struct pp_rgb light, int value)
{
    return value == RED     ? light.r
           : value == GREEN ? light.g
           : value == BLUE  ? light.b
                            : pp_rgb_luminance(light);
}

static double sensor_value(const void *client, int point,
                           const struct pp_randomisation *randomisation, int value)
{
    (void)client, (void)point;
    const double *sums = randomisation->sums;
    return of_channel(pp_rgb(sums[RED], sums[GREEN], sums[BLUE]), value)
           / randomisation->done.of[0];
}

static double sensor_bound(const void *client, int point, int value, unsigned found,
                           const double *paths)
{
    const struct pp_sensors *sensors = client;
    return of_channel(pp_unsampled_bound(&sensors->points[point].unsampled,
                                         found >> value & 1, paths[0]),
                      value);
}

static const struct pp_sampler sampler = {
    .estimators = 1,
    .values = VALUES,
    .fall = {1.1}, /* conservative */
    .pilot = {{32}},
    .least = {{64}},
    .state_size = sizeof(struct pp_radiance_state),
    .begin = begin_sensor_state,
    .seed = sensor_seed,
    .follow = follow_sensor_paths,
    .value = sensor_value,
    .bound = sensor_bound,
};

/* ---- the caller's loop ---- */

enum pp_status pp_sensors_create(struct pp_sensors **result,
                                 const struct pp_light_scene *scene,
                                 const struct pp_environment *environment,
                                 const struct pp_sensor *list, int count,
                                 const struct pp_sensors_options *options,
                                 struct pp_error *err)
{
    *result = NULL;
    struct pp_sensors *sensors = calloc(1, sizeof *sensors);
    if (!sensors)
        return pp_fail_memory(err);
    sensors->scene = scene;
    sensors->environment = environment;
    sensors->count = count;
    sensors->by_chance = options->by_chance;
    sensors->bounces = options->limited ? options->bounces : -1;
    sensors->ground_counts = options->limited && options->ground_counts;
    sensors->points = calloc((size_t)count + 1, sizeof *sensors->points);
    double *shares = calloc((size_t)scene->emitter_count + 1, sizeof *shares);
    enum pp_status status = sensors->points && shares ? PP_OK : pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < scene->emitter_count; i++)
        shares[i] = pp_unsampled_probe(scene, &scene->emitters[i]);
    for (int i = 0; status == PP_OK && i < count; i++) {
        struct pp_vec3 position = list[i].position, normal = list[i].normal;
        sensors->points[i] = (struct sensor_point){
            .position = position,
            .normal = normal,
            .space = pp_light_scene_space(scene, position),
            .seed = pp_hash_vec(pp_hash_vec(options->seed, position), normal),
            .unsampled = pp_unsampled_at(scene, position, options->by_chance, shares)};
    }
    free(shares);
    const struct pp_planner_options planned = {.error = options->error,
                                               .least_error =
                                                   OPEN_SKY_SHARE * options->horizontal,
                                               .least_share = LARGEST_SHARE,
                                               .samples = options->samples,
                                               .threads = options->threads};
    if (status == PP_OK)
        status = pp_planner_create(&sensors->planner, &sampler, sensors, count,
                                   &planned, err);
    if (status != PP_OK) {
        pp_sensors_destroy(sensors);
        return status;
    }
    *result = sensors;
    return PP_OK;
}

void pp_sensors_destroy(struct pp_sensors *sensors)
{
    if (!sensors)
        return;
    pp_planner_destroy(sensors->planner);
    free(sensors->points);
    free(sensors);
}

enum pp_status pp_sensors_advance(struct pp_sensors *sensors, double seconds,
                                  struct pp_error *err)
{
    return pp_planner_advance(sensors->planner, seconds, err);
}

bool pp_sensors_done(const struct pp_sensors *sensors)
{
    return pp_planner_done(sensors->planner);
}

double pp_sensors_progress(const struct pp_sensors *sensors)
{
    return pp_planner_progress(sensors->planner);
}

double pp_sensors_error(const struct pp_sensors *sensors)
{
    return pp_planner_error(sensors->planner);
}

struct pp_sensor_reading pp_sensors_read(const struct pp_sensors *sensors, int index)
{
    struct pp_reading of[PP_VALUES_MOST];
    pp_planner_read(sensors->planner, index, of);
    return (struct pp_sensor_reading){
        .irradiance = {of[RED].value, of[GREEN].value, of[BLUE].value},
        .std_error = {of[RED].std_error, of[GREEN].std_error, of[BLUE].std_error},
        .grey = of[GREY].value,
        .grey_error = of[GREY].std_error};
}
