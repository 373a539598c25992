/* cached_points.c - a room's points as a sampler that reads the cache once it is
 * complete. */
#include "simulate/cache/cached_points.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/cache/cache_parts.h"
#include "simulate/estimate/planner.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/unsampled.h"

enum {
    MOST_PATHS = 1 << 16,
    PLANE_REQUESTS = 16, /* points of the plane whose surroundings are requested */
    PLANE_VERTEX = INT32_MAX / 8, /* vertex of the random numbers that select a point of
                                   * the plane */
};

/* Least standard error aimed at, as in the tracer: a daylight factor of 0.002 %. */
static const double LEAST_ERROR = 2e-5;

/* Estimator of the internally reflected light at a point. */
enum reflected_by {
    BY_SAMPLES,  /* rays from the point */
    BY_RECORDS,  /* records of the cache, interpolated at the point */
    BY_CONSTANT, /* the ambient constant, if there are no bounces */
};

struct cached_point {
    bool plane; /* the average over the working plane */
    struct pp_vec3 position, normal;
    enum pp_space space;
    uint64_t seed;
    enum reflected_by by;
    double reflected; /* value, if not by samples */
    struct pp_room_bound most;
};

struct pp_cached_points {
    const struct pp_light_scene *scene;
    const struct pp_opening_store *store;
    struct pp_irradiance_cache *cache;
    struct pp_cached_options options;
    struct cached_point *points; /* the receivers, then the average if requested */
    int point_count, receiver_count;
    bool grown; /* true once the cache is done and interpolated values are read */
    struct pp_planner *planner;
};

struct pp_radiance_options pp_cached_points_light(void)
{
    struct pp_radiance_options light = pp_radiance_state_defaults();
    light.source_most = 1; /* many paths per point: one direction to each source is
                            * enough */
    return light;
}

/* ---- the sampler ---- */

static struct pp_vec3 plane_point(const struct pp_cached_points *points, double u,
                                  double v)
{
    return pp_vec_add(pp_light_scene_of_world_plane_point(points->scene, u, v),
                      points->scene->centre);
}

static void begin_cached_state(const void *client, void *state)
{
    const struct pp_cached_points *points = client;
    *(struct pp_radiance_state *)state = (struct pp_radiance_state){
        .scene = points->scene,
        .environment = points->cache->environment,
        .options = pp_cached_points_light(),
        .store = points->store,
        .ambient = pp_irradiance_cache_ambient(points->cache)};
}

static uint64_t cached_point_seed(const void *client, int point)
{
    return ((const struct pp_cached_points *)client)->points[point].seed;
}

static void follow_cached_paths(const void *client, void *state,
                                const struct pp_path_range *range,
                                struct pp_randomisation *randomisation)
{
    const struct pp_cached_points *points = client;
    const struct cached_point *point = &points->points[range->point];
    struct pp_radiance_state *radiance = state;
    struct pp_vec3 position = point->position;
    enum pp_space space = point->space;
    long rays = radiance->rays, leaks = radiance->leaks;
    radiance->sequence = range->sequence;
    for (uint32_t i = range->first; i < range->end; i++) {
        radiance->index = i;
        if (point->plane) {
            double u[2];
            pp_sobol_sequence_draw(&radiance->sequence, i, PLANE_VERTEX, 2, u);
            position = plane_point(points, u[0], u[1]);
            space = pp_light_scene_space(points->scene, position);
        }
        struct pp_irradiance e =
            point->by == BY_SAMPLES
                ? pp_radiance_irradiance(radiance, position, point->normal, space)
                : pp_radiance_direct(radiance, position, point->normal, space);
        randomisation->sums[PP_SC] += pp_rgb_luminance(e.sky);
        randomisation->sums[PP_ERC] += pp_rgb_luminance(e.outside);
        randomisation->sums[PP_IRC] += pp_rgb_luminance(pp_rgb_add(e.sources, e.rest));
    }
    randomisation->rays[0] += radiance->rays - rays;
    randomisation->leaks += radiance->leaks - leaks;
}

static double cached_point_value(const void *client, int index,
                                 const struct pp_randomisation *randomisation,
                                 int component)
{
    const struct pp_cached_points *points = client;
    double value[3];
    for (int i = PP_SC; i <= PP_IRC; i++)
        value[i] = randomisation->sums[i] / randomisation->done.of[0];
    value[PP_IRC] =
        points->scene->decorations * (value[PP_IRC] + points->points[index].reflected);
    return component == PP_DF ? value[PP_SC] + value[PP_ERC] + value[PP_IRC]
                              : value[component];
}

static double cached_point_bound(const void *client, int index, int component,
                                 unsigned found, const double *paths)
{
    const struct cached_point *point =
        &((const struct pp_cached_points *)client)->points[index];
    if (point->by != BY_SAMPLES)
        found |= 1U << PP_IRC;
    return pp_unsampled_of_component(&point->most, component, found, paths[0],
                                     paths[0]);
}

static const struct pp_sampler sampler = {
    .estimators = 1,
    .values = PP_COMPONENT_COUNT,
    .fall = {1.2}, /* conservative */
    .pilot = {{8}},
    .least = {{16}},
    .state_size = sizeof(struct pp_radiance_state),
    .begin = begin_cached_state,
    .seed = cached_point_seed,
    .follow = follow_cached_paths,
    .value = cached_point_value,
    .bound = cached_point_bound,
};

/* ---- making ---- */

static enum pp_status request(struct pp_cached_points *points,
                              const struct cached_point *point, struct pp_error *err)
{
    if (!point->plane)
        return point->by == BY_RECORDS
                   ? pp_cache_grow_request_point(points->cache, point->position,
                                                 point->normal, point->space, err)
                   : pp_cache_grow_request_hemisphere(points->cache, point->position,
                                                      point->normal, point->space, err);
    struct pp_sobol sobol;
    struct pp_sobol_sequence sequence;
    pp_sobol_init(&sobol);
    pp_sobol_sequence_init(&sequence, &sobol, point->seed);
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

/* The point of a receiver; with NULL, the point for the average over the working
 * plane. */
static struct cached_point cached_point_of(const struct pp_cached_points *points,
                                           const struct pp_receiver *receiver)
{
    struct cached_point point = {.plane = !receiver,
                                 .normal = {0.0, 0.0, 1.0},
                                 .seed = pp_hash(points->options.seed, UINT64_MAX),
                                 .by = reflected_by(points, !receiver)};
    struct pp_vec3 from = {0.0, 0.0, 0.0};
    if (receiver) {
        point.position = receiver->position;
        point.normal = receiver->normal;
        point.seed = pp_hash_vec(pp_hash_vec(points->options.seed, point.position),
                                 point.normal);
        point.space = pp_light_scene_space(points->scene, point.position);
        from = pp_vec_sub(point.position, points->scene->centre);
    }
    point.most =
        pp_unsampled_of_room(points->scene, receiver ? &from : NULL, point.normal);
    return point;
}

static enum pp_status make_cached_points(struct pp_cached_points *points,
                                         const struct pp_receiver *receivers,
                                         int receiver_count, struct pp_error *err)
{
    bool average = points->options.average && points->scene->plane_count > 0;
    points->receiver_count = receiver_count;
    points->point_count = receiver_count + average;
    points->points = calloc((size_t)points->point_count + 1, sizeof *points->points);
    enum pp_status status = points->points ? PP_OK : pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < points->point_count; i++) {
        points->points[i] =
            cached_point_of(points, i < receiver_count ? &receivers[i] : NULL);
        status = request(points, &points->points[i], err);
    }
    const struct pp_planner_options planned = {.error = points->options.error,
                                               .least_error = LEAST_ERROR,
                                               .samples = points->options.samples,
                                               .threads = points->options.threads};
    if (status == PP_OK)
        status = pp_planner_create(&points->planner, &sampler, points,
                                   points->point_count, &planned, err);
    return status;
}

enum pp_status pp_cached_points_create(
    struct pp_cached_points **result, const struct pp_light_scene *scene,
    const struct pp_opening_store *store, struct pp_irradiance_cache *cache,
    const struct pp_receiver *receivers, int receiver_count,
    const struct pp_cached_options *options, struct pp_error *err)
{
    *result = NULL;
    if (options->samples < 0 || options->samples > MOST_PATHS)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%ld samples per point are too many for the cache; expected at most %d",
            options->samples, (int)MOST_PATHS);
    struct pp_cached_points *points = calloc(1, sizeof *points);
    if (!points)
        return pp_fail_memory(err);
    points->scene = scene;
    points->store = store;
    points->cache = cache;
    points->options = *options;
    enum pp_status status = make_cached_points(points, receivers, receiver_count, err);
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
    pp_planner_destroy(points->planner);
    free(points->points);
    free(points);
}

/* ---- readings and the loop ---- */

void pp_cached_points_read(const struct pp_cached_points *points, int index,
                           struct pp_reading readings[PP_COMPONENT_COUNT])
{
    int at = index < 0 ? points->receiver_count : index;
    const char *why =
        at >= points->point_count ? "the room has no working plane for an average"
        : !points->grown          ? "the simulation ended before it reached this point"
                                  : NULL;
    for (int i = 0; i < PP_COMPONENT_COUNT && why; i++)
        readings[i] = pp_reading_none(why);
    if (why)
        return;
    pp_planner_read(points->planner, at, readings);
    if (points->points[at].by == BY_RECORDS)
        readings[PP_IRC].std_error = readings[PP_DF].std_error = NAN;
}

/* Reads interpolated values once the cache is complete; points without a record are
 * sampled instead. */
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
    return pp_planner_advance(points->planner, end - pp_clock_s(), err);
}

bool pp_cached_points_done(const struct pp_cached_points *points)
{
    return points->grown && pp_planner_done(points->planner);
}

double pp_cached_points_progress(const struct pp_cached_points *points)
{
    return points->grown ? 0.5 + 0.5 * pp_planner_progress(points->planner)
                         : 0.5 * pp_cache_grow_progress(points->cache);
}

double pp_cached_points_error(const struct pp_cached_points *points)
{
    return pp_planner_error(points->planner);
}
