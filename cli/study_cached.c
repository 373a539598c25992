/* study_cached.c - see study_cached.h. */
#include "cli/study_cached.h"

#include <math.h>
#include <string.h>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "model/base/clock.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/cache/cached_points.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/window_store.h"

static const double slice_s = 0.1;

static enum pp_status read_engines(const char *text, void *place, struct pp_error *err)
{
    static const char *const lists[] = {"path", "cache", "path,cache", "cache,path"};
    for (int i = 0; i < 4; i++)
        if (strcmp(text, lists[i]) == 0) {
            *(const char **)place = lists[i];
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "path, cache or path,cache");
}

const struct pp_option pp_engine_options[] = {
    {"engine", 0, "LIST",
     "What simulates: path (default), without bias; cache, through an irradiance "
     "cache; or path,cache, and how far they are apart.",
     read_engines, offsetof(struct pp_engine_choice, engines)},
    {"interpolate", 0, NULL,
     "Interpolate what is reflected at the points, too, from the cache.", NULL,
     offsetof(struct pp_engine_choice, interpolate)},
    {0},
};

enum pp_status pp_study_cached_settle(struct pp_engine_choice *words, bool simulate,
                                      struct pp_error *err)
{
    words->cached = words->engines && strstr(words->engines, "cache");
    words->path = !words->engines || strstr(words->engines, "path");
    if (words->engines && !simulate)
        return pp_fail(err, PP_BAD_INPUT,
                       "--engine says what simulates; it needs --simulate");
    if (words->interpolate && !words->cached)
        return pp_fail(err, PP_BAD_INPUT, "--interpolate needs --engine cache");
    const char *used = pp_cache_choice_used(&words->cache);
    if (!used && words->cache.options.bounces != pp_irradiance_cache_defaults().bounces)
        used = "--bounces"; /* the tracer has no limit */
    if (used && !words->cached)
        return pp_fail(err, PP_BAD_INPUT, "%s needs --engine cache", used);
    return pp_cache_choice_settle(&words->cache, err);
}

static enum pp_status add_columns(struct pp_report *report,
                                  const struct pp_cached_points *points,
                                  struct pp_error *err)
{
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        struct pp_reading readings[PP_COMPONENT_COUNT];
        struct pp_column *column = pp_report_add(report, component, "cached", true);
        if (!column)
            return pp_fail_memory(err);
        pp_cached_points_read(points, -1, readings);
        column->average = readings[component];
        for (int i = 0; i < report->receiver_count; i++) {
            pp_cached_points_read(points, i, readings);
            column->points[i] = readings[component];
        }
    }
    return PP_OK;
}

static enum pp_status sample(struct pp_cached_points *points, struct pp_report *report,
                             const struct pp_room_options *options, bool *by_clock,
                             struct pp_error *err)
{
    struct pp_progress progress;
    const char *name = report->world->name;
    enum pp_status status = PP_OK;
    pp_progress_begin(&progress, name ? name : "room", options->quiet);
    while (status == PP_OK && !pp_cached_points_done(points)) {
        double spent = pp_clock_s() - progress.started_s;
        if (pp_interrupt_came()) {
            report->finished = false;
            break;
        }
        if (options->seconds > 0.0 && spent >= options->seconds) {
            *by_clock = true;
            break;
        }
        status = pp_cached_points_advance(points, slice_s, err);
        pp_progress_show(&progress, pp_cached_points_progress(points),
                         pp_cached_points_error(points));
    }
    pp_progress_end(&progress);
    return status;
}

/* With scene, store and cache made. */
static enum pp_status gather(struct pp_report *report,
                             const struct pp_room_options *options,
                             const struct pp_engine_choice *words,
                             const struct pp_light_scene *scene,
                             const struct pp_window_store *store,
                             struct pp_irradiance_cache *cache, bool *by_clock,
                             struct pp_error *err)
{
    const struct pp_cached_options wanted = {.error = options->error,
                                             .samples = options->samples,
                                             .average = true,
                                             .interpolate = words->interpolate,
                                             .seed = options->seed,
                                             .threads = options->threads};
    struct pp_cached_points *points;
    enum pp_status status =
        pp_cached_points_create(&points, scene, store, cache, report->receivers,
                                report->receiver_count, &wanted, err);
    if (status == PP_OK)
        status = sample(points, report, options, by_clock, err);
    if (status == PP_OK)
        status = add_columns(report, points, err);
    pp_cached_points_destroy(points);
    if (status == PP_OK && report->finished && pp_cache_grow_done(cache))
        status = pp_cache_choice_save(&words->cache, cache, err);
    return status;
}

enum pp_status pp_study_cached_add(struct pp_report *report,
                                   const struct pp_room_options *options,
                                   const struct pp_engine_choice *words, bool *by_clock,
                                   struct pp_error *err)
{
    const struct pp_radiance_options light = pp_cached_points_light();
    struct pp_light_scene *scene;
    struct pp_window_store *store = NULL;
    struct pp_irradiance_cache *cache = NULL;
    enum pp_status status = pp_light_scene_of_world_matt(&scene, report->world, err);
    if (status == PP_OK)
        status =
            pp_window_store_create(&store, scene, options->seed, options->threads, err);
    if (status == PP_OK)
        status = pp_cache_choice_open(&cache, &words->cache, scene, store, &light,
                                      options->seed, options->threads, err);
    if (status == PP_OK)
        status = gather(report, options, words, scene, store, cache, by_clock, err);
    pp_irradiance_cache_destroy(cache);
    pp_window_store_destroy(store);
    pp_light_scene_destroy(scene);
    return status;
}
