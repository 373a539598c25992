/* cached_points.c - points sampled in rounds of doubled paths, once the cache has
 * grown. */
#include "simulate/cache/cached_points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/clock.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/cache/cache_parts.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/processors.h"
#include "simulate/scene/light_scene_parts.h"

enum {
    RANDOMISATIONS = 32,
    FIRST_PATHS = 16,
    MOST_PATHS = 1 << 16,
    PLANE_REQUESTS = 16, /* points of the plane whose surroundings are requested */
};

/* The least standard error that is asked for, as the tracer's: 0.002 % daylight
 * factor. */
static const double LEAST_ERROR = 2e-5;

/* The standard error is widened for the number of randomisations (estimate.h). */
static const double STUDENT = 31.0 / 29.0;

/* How the internally reflected light at a point is found. */
enum reflected_by {
    BY_SAMPLES,  /* rays from the point */
    BY_RECORDS,  /* the cache, interpolated there */
    BY_CONSTANT, /* the ambient constant: there are no bounces */
};

/* One randomisation of one point: sums over its paths. */
struct sum {
    double part[3]; /* PP_SC, PP_ERC, PP_IRC without decorations */
    uint32_t paths;
};

struct cached_point {
    bool plane; /* the average over the working plane */
    struct pp_vec3 position, normal;
    enum pp_space space;
    uint64_t seed;
    enum reflected_by by;
    double reflected; /* where it is not by samples */
    uint32_t wanted;  /* paths in each randomisation */
    struct sum sums[RANDOMISATIONS];
};

struct pp_cached_points {
    const struct pp_light_scene *scene;
    const struct pp_window_store *store;
    struct pp_irradiance_cache *cache;
    struct pp_cached_options options;
    struct pp_sobol sobol;
    struct cached_point *points; /* the receivers, then the average if it is wanted */
    int point_count, receiver_count;
    bool grown;      /* is the cache done, and what is interpolated read? */
    int *unfinished; /* of the round at hand */
    int unfinished_count, next;
};

struct pp_radiance_options pp_cached_points_light(void)
{
    struct pp_radiance_options light = pp_radiance_options_defaults();
    light.source_most = 1; /* a point has many paths: one direction each */
    return light;
}

/* ---- making ---- */

static struct pp_vec3 plane_point(const struct pp_cached_points *points, double u,
                                  double v)
{
    return pp_vec_add(pp_ray_scene_plane_point(points->scene->room, u, v),
                      points->scene->centre);
}

static enum pp_status request(struct pp_cached_points *points,
                              const struct cached_point *point, struct pp_error *err)
{
    if (!point->plane)
        return point->by == BY_RECORDS
                   ? pp_cache_grow_request_point(points->cache, point->position,
                                                 point->normal, point->space, err)
                   : pp_cache_grow_request_hemisphere(points->cache, point->position,
                                                      point->normal, point->space, err);
    struct pp_sobol_sequence sequence;
    pp_sobol_sequence_init(&sequence, &points->sobol, point->seed);
    enum pp_status status = PP_OK;
    for (uint32_t i = 0; status == PP_OK && i < PLANE_REQUESTS; i++) {
        double u[2];
        pp_sobol_sequence_draw(&sequence, i, 0, 2, u);
        struct pp_vec3 there = plane_point(points, u[0], u[1]);
        status = pp_cache_grow_request_hemisphere(
            points->cache, there, point->normal,
            pp_light_scene_space(points->scene, there), err);
    }
    return status;
}

static enum reflected_by reflected_by(const struct pp_cached_points *points, bool plane)
{
    if (points->cache->options.bounces == 0)
        return BY_CONSTANT;
    return points->options.interpolate && !plane ? BY_RECORDS : BY_SAMPLES;
}

static struct cached_point point_of(const struct pp_cached_points *points,
                                    const struct pp_receiver *receiver)
{
    struct cached_point point = {.position = receiver->position,
                                 .normal = receiver->normal,
                                 .seed = points->options.seed,
                                 .by = reflected_by(points, false)};
    point.seed = pp_hash_vec(pp_hash_vec(point.seed, point.position), point.normal);
    point.space = pp_light_scene_space(points->scene, point.position);
    return point;
}

static enum pp_status make(struct pp_cached_points *points,
                           const struct pp_receiver *receivers, int receiver_count,
                           struct pp_error *err)
{
    bool average = points->options.average && points->scene->room->plane_count > 0;
    points->receiver_count = receiver_count;
    points->point_count = receiver_count + average;
    size_t count = (size_t)points->point_count + 1;
    points->points = calloc(count, sizeof *points->points);
    points->unfinished = calloc(count, sizeof *points->unfinished);
    if (!points->points || !points->unfinished)
        return pp_fail_memory(err);
    pp_sobol_init(&points->sobol);
    long samples = points->options.samples;
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < points->point_count; i++) {
        struct cached_point *point = &points->points[i];
        if (i < receiver_count)
            *point = point_of(points, &receivers[i]);
        else
            *point =
                (struct cached_point){.plane = true,
                                      .normal = {0.0, 0.0, 1.0},
                                      .seed = pp_hash(points->options.seed, UINT64_MAX),
                                      .by = reflected_by(points, true)};
        point->wanted = samples > 0 ? (uint32_t)samples : FIRST_PATHS;
        status = request(points, point, err);
    }
    return status;
}

enum pp_status pp_cached_points_create(
    struct pp_cached_points **result, const struct pp_light_scene *scene,
    const struct pp_window_store *store, struct pp_irradiance_cache *cache,
    const struct pp_receiver *receivers, int receiver_count,
    const struct pp_cached_options *options, struct pp_error *err)
{
    *result = NULL;
    if (options->samples < 0 || options->samples > MOST_PATHS)
        return pp_fail(err, PP_BAD_INPUT,
                       "%ld samples a point are not possible with the cache; expected "
                       "up to %d",
                       options->samples, (int)MOST_PATHS);
    struct pp_cached_points *points = calloc(1, sizeof *points);
    if (!points)
        return pp_fail_memory(err);
    points->scene = scene;
    points->store = store;
    points->cache = cache;
    points->options = *options;
    if (points->options.threads <= 0)
        points->options.threads = pp_processors();
    enum pp_status status = make(points, receivers, receiver_count, err);
    if (status != PP_OK) {
        pp_cached_points_destroy(points);
        return status;
    }
    *result = points;
    return PP_OK;
}

void pp_cached_points_destroy(struct pp_cached_points *points)
{
    if (!points)
        return;
    free(points->points);
    free(points->unfinished);
    free(points);
}

/* ---- one point ---- */

static void one_path(const struct pp_cached_points *points, struct cached_point *point,
                     struct pp_radiance_state *state, uint32_t index, struct sum *sum)
{
    struct pp_vec3 position = point->position;
    enum pp_space space = point->space;
    state->index = index;
    if (point->plane) {
        double u[2];
        pp_sobol_sequence_draw(&state->sequence, index, INT32_MAX / 8, 2, u);
        position = plane_point(points, u[0], u[1]);
        space = pp_light_scene_space(points->scene, position);
    }
    struct pp_irradiance e =
        point->by == BY_SAMPLES
            ? pp_radiance_irradiance(state, position, point->normal, space)
            : pp_radiance_direct(state, position, point->normal, space);
    sum->part[PP_SC] += pp_rgb_luminance(e.sky);
    sum->part[PP_ERC] += pp_rgb_luminance(e.outside);
    sum->part[PP_IRC] += pp_rgb_luminance(pp_rgb_add(e.sources, e.rest));
    sum->paths = index + 1;
}

static void run_randomisation(const struct pp_cached_points *points,
                              struct cached_point *point, int k)
{
    struct sum *sum = &point->sums[k];
    struct pp_radiance_state state = {.scene = points->scene,
                                      .options = pp_cached_points_light(),
                                      .store = points->store,
                                      .ambient =
                                          pp_irradiance_cache_ambient(points->cache)};
    pp_sobol_sequence_init(&state.sequence, &points->sobol,
                           pp_hash(point->seed, (uint64_t)k));
    for (uint32_t i = sum->paths; i < point->wanted; i++)
        one_path(points, point, &state, i, sum);
}

static double value_of(const struct pp_cached_points *points,
                       const struct cached_point *point, int k, int component)
{
    double decorations = points->scene->room->decorations, value[3];
    for (int i = 0; i < 3; i++)
        value[i] = point->sums[k].part[i] / point->sums[k].paths;
    value[PP_IRC] = decorations * (value[PP_IRC] + point->reflected);
    return component == PP_DF ? value[PP_SC] + value[PP_ERC] + value[PP_IRC]
                              : value[component];
}

/* With the standard error of what is sampled. */
static struct pp_reading sampled_of(const struct pp_cached_points *points,
                                    const struct cached_point *point, int component)
{
    double mean = 0.0, square = 0.0;
    if (!points->grown || point->sums[RANDOMISATIONS - 1].paths == 0)
        return pp_reading_none("not reached before the simulation ended");
    for (int k = 0; k < RANDOMISATIONS; k++)
        mean += value_of(points, point, k, component) / RANDOMISATIONS;
    for (int k = 0; k < RANDOMISATIONS; k++) {
        double off = value_of(points, point, k, component) - mean;
        square += off * off;
    }
    struct pp_reading reading = pp_reading_of(mean);
    reading.std_error = sqrt(STUDENT * square / (RANDOMISATIONS - 1) / RANDOMISATIONS);
    return reading;
}

static struct pp_reading reading_of(const struct pp_cached_points *points,
                                    const struct cached_point *point, int component)
{
    struct pp_reading reading = sampled_of(points, point, component);
    if (point->by == BY_RECORDS && (component == PP_IRC || component == PP_DF))
        reading.std_error = NAN;
    return reading;
}

void pp_cached_points_read(const struct pp_cached_points *points, int index,
                           struct pp_reading readings[PP_COMPONENT_COUNT])
{
    int at = index < 0 ? points->receiver_count : index;
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        readings[i] =
            at < points->point_count
                ? reading_of(points, &points->points[at], i)
                : pp_reading_none("the room has no working plane to average over");
}

/* ---- the loop ---- */

/* Lists the points whose error is too large, and doubles their paths, from the
 * second round on. */
static void plan_round(struct pp_cached_points *points)
{
    points->unfinished_count = points->next = 0;
    for (int i = 0; i < points->point_count; i++) {
        struct cached_point *point = &points->points[i];
        if (point->sums[RANDOMISATIONS - 1].paths > 0) {
            struct pp_reading df = sampled_of(points, point, PP_DF);
            double wanted = fmax(points->options.error * df.value, LEAST_ERROR);
            if (points->options.samples > 0 || df.std_error <= wanted
                || point->wanted >= MOST_PATHS)
                continue;
            point->wanted *= 2;
        }
        points->unfinished[points->unfinished_count++] = i;
    }
}

/* Once the cache is done, what is not sampled; where it has no record after all, that
 * is sampled too. */
static void read_cache(struct pp_cached_points *points)
{
    for (int i = 0; i < points->point_count; i++) {
        struct cached_point *point = &points->points[i];
        struct pp_rgb value;
        if (point->by == BY_SAMPLES)
            continue;
        if (pp_irradiance_cache_value(points->cache, point->position, point->normal,
                                      point->space, 0, &value))
            point->reflected = pp_rgb_luminance(value);
        else
            point->by = BY_SAMPLES;
    }
    points->grown = true;
    plan_round(points);
}

enum pp_status pp_cached_points_advance(struct pp_cached_points *points, double seconds,
                                        struct pp_error *err)
{
    double end = pp_clock_s() + seconds;
    if (!points->grown) {
        enum pp_status status = pp_cache_grow(points->cache, seconds, err);
        if (status != PP_OK || !pp_cache_grow_done(points->cache))
            return status;
        read_cache(points);
    }
    while (!pp_cached_points_done(points) && pp_clock_s() < end) {
        int left = points->unfinished_count - points->next;
        int count = left < 8 ? left : 8;
        const int *at = points->unfinished + points->next;
#pragma omp parallel for num_threads(points->options.threads) schedule(dynamic, 1)
        for (int i = 0; i < count * RANDOMISATIONS; i++)
            run_randomisation(points, &points->points[at[i / RANDOMISATIONS]],
                              i % RANDOMISATIONS);
        points->next += count;
        if (points->next == points->unfinished_count)
            plan_round(points);
    }
    return PP_OK;
}

bool pp_cached_points_done(const struct pp_cached_points *points)
{
    return points->grown && points->next >= points->unfinished_count;
}

double pp_cached_points_progress(const struct pp_cached_points *points)
{
    if (!points->grown)
        return 0.5 * pp_cache_grow_progress(points->cache);
    double left = points->unfinished_count - points->next;
    return 1.0 - 0.5 * left / (points->point_count > 0 ? points->point_count : 1);
}

double pp_cached_points_error(const struct pp_cached_points *points)
{
    double most = NAN;
    for (int i = 0; i < points->point_count; i++) {
        struct pp_reading df = sampled_of(points, &points->points[i], PP_DF);
        if (df.value > 0.0)
            most = fmax(most, df.std_error / df.value);
    }
    return most;
}
