/* engine_path.c - adapts the unbiased path tracer (simulate/fast) as an engine. */
#include "simulate/fast/tracer.h"
#include "studies/engines/engine.h"

static enum pp_status create_path_engine(void **run, const struct pp_light_scene *scene,
                                         const struct pp_environment *environment,
                                         const struct pp_report *report,
                                         const struct pp_engine_options *options,
                                         struct pp_error *err)
{
    const struct pp_tracer_options wanted = {.error = options->error,
                                             .samples = options->samples,
                                             .seed = options->seed,
                                             .threads = options->threads,
                                             .average = true,
                                             .alone = options->alone,
                                             .direct = options->direct};
    struct pp_tracer *solver;
    enum pp_status status =
        pp_tracer_create(&solver, scene, environment, report->receivers,
                         report->receiver_count, &wanted, err);
    if (status == PP_OK)
        *run = solver;
    return status;
}

static enum pp_status advance_path_engine(void *run, double seconds,
                                          struct pp_error *err)
{
    return pp_tracer_advance(run, seconds, err);
}

static bool path_engine_done(const void *run)
{
    return pp_tracer_done(run);
}

static double path_engine_progress(const void *run)
{
    return pp_tracer_progress(run);
}

static double path_engine_error(const void *run)
{
    return pp_tracer_error(run);
}

static void read_path_engine(const void *run, int index,
                             struct pp_reading readings[PP_COMPONENT_COUNT])
{
    pp_tracer_read(run, index, readings);
}

static double common(const void *run)
{
    return pp_tracer_common(run);
}

static double common_near(const void *run)
{
    return pp_tracer_common_near(run);
}

static void destroy_path_engine(void *run)
{
    pp_tracer_destroy(run);
}

const struct pp_engine pp_engine_path = {
    .name = "path",
    .column = "traced",
    .summary = "light paths from the points, unbiased",
    .said = "by simulation",
    .deviation = "one standard error",
    .from = "from traced, %",
    .is_truth = true,
    .is_sampled = true,
    .plain = &pp_engine_plain,
    .create = create_path_engine,
    .advance = advance_path_engine,
    .done = path_engine_done,
    .progress = path_engine_progress,
    .error = path_engine_error,
    .read = read_path_engine,
    .common = common,
    .common_near = common_near,
    .destroy = destroy_path_engine,
};
