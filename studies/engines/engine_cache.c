/* engine_cache.c - adapts the irradiance cache (simulate/cache) as an engine for
 * daylight factors at points.
 */
#include <stdlib.h>

#include "simulate/cache/cache_file.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/cache/cached_points.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/opening_store.h"
#include "studies/engines/cache_records.h"
#include "studies/engines/engine.h"

/* Objects made for a run, in the order of their creation. */
struct cache_run {
    struct pp_opening_store *store;
    struct pp_irradiance_cache *cache;
    struct pp_cached_points *points;
};

static void destroy_cache_engine(void *data)
{
    struct cache_run *run = data;
    if (!run)
        return;
    pp_cached_points_destroy(run->points);
    pp_irradiance_cache_destroy(run->cache);
    pp_opening_store_destroy(run->store);
    free(run);
}

static enum pp_status make_cache_run(struct cache_run *run,
                                     const struct pp_light_scene *scene,
                                     const struct pp_environment *environment,
                                     const struct pp_report *report,
                                     const struct pp_engine_options *options,
                                     struct pp_error *err)
{
    const struct pp_radiance_options light = pp_cached_points_light();
    const struct pp_cached_options wanted = {.error = options->error,
                                             .samples = options->samples,
                                             .average = true,
                                             .interpolate = options->interpolate,
                                             .seed = options->seed,
                                             .threads = options->threads};
    struct pp_cache_options records = options->cache;
    records.seed = options->seed;
    records.threads = options->threads;
    enum pp_status status = pp_opening_store_create(
        &run->store, scene, environment, options->seed, options->threads, err);
    if (status == PP_OK)
        status = pp_cache_records_open(&run->cache, options->cache_file, scene,
                                       environment, run->store, &light, &records, err);
    if (status == PP_OK)
        status = pp_cached_points_create(&run->points, scene, run->store, run->cache,
                                         report->receivers, report->receiver_count,
                                         &wanted, err);
    return status;
}

static enum pp_status create_cache_engine(void **data,
                                          const struct pp_light_scene *scene,
                                          const struct pp_environment *environment,
                                          const struct pp_report *report,
                                          const struct pp_engine_options *options,
                                          struct pp_error *err)
{
    struct cache_run *run = calloc(1, sizeof *run);
    if (!run)
        return pp_fail_memory(err);
    enum pp_status status =
        make_cache_run(run, scene, environment, report, options, err);
    if (status != PP_OK) {
        destroy_cache_engine(run);
        run = NULL;
    }
    *data = run;
    return status;
}

static enum pp_status advance_cache_engine(void *data, double seconds,
                                           struct pp_error *err)
{
    struct cache_run *run = data;
    return pp_cached_points_advance(run->points, seconds, err);
}

static bool cache_engine_done(const void *data)
{
    const struct cache_run *run = data;
    return pp_cached_points_done(run->points);
}

static double cache_engine_progress(const void *data)
{
    const struct cache_run *run = data;
    return pp_cached_points_progress(run->points);
}

static double cache_engine_error(const void *data)
{
    const struct cache_run *run = data;
    return pp_cached_points_error(run->points);
}

static void read_cache_engine(const void *data, int index,
                              struct pp_reading readings[PP_COMPONENT_COUNT])
{
    const struct cache_run *run = data;
    pp_cached_points_read(run->points, index, readings);
}

static enum pp_status keep_cache_records(const void *data, char **bytes, size_t *length,
                                         struct pp_error *err)
{
    const struct cache_run *run = data;
    *bytes = NULL;
    return pp_cache_grow_done(run->cache)
               ? pp_cache_file_pack(run->cache, bytes, length, err)
               : PP_OK;
}

const struct pp_engine pp_engine_cache = {
    .name = "cache",
    .column = "cached",
    .summary = "irradiance cache, for reflected light",
    .said = "through the irradiance cache",
    .deviation = "the standard error of the sampling",
    .is_sampled = true,
    .create = create_cache_engine,
    .advance = advance_cache_engine,
    .done = cache_engine_done,
    .progress = cache_engine_progress,
    .error = cache_engine_error,
    .read = read_cache_engine,
    .keep = keep_cache_records,
    .destroy = destroy_cache_engine,
};
