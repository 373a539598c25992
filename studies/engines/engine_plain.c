/* engine_plain.c - the plain path tracer of simulate/path_tracer as an engine: the
 * results of engine_path.c by the textbook algorithm. */
#include <stdlib.h>

#include "simulate/path_tracer/path_tracer.h"
#include "studies/engines/engine.h"

/* The light on the scene, and the tracer. */
struct plain_run {
    struct pp_environment *environment;
    struct pp_path_tracer *tracer;
};

static void destroy_plain_engine(void *data)
{
    struct plain_run *run = data;
    if (!run)
        return;
    pp_path_tracer_destroy(run->tracer);
    pp_environment_destroy(run->environment);
    free(run);
}

static enum pp_status make_plain_engine(struct plain_run *run,
                                        const struct pp_light_scene *scene,
                                        const struct pp_report *report,
                                        const struct pp_engine_options *options,
                                        struct pp_error *err)
{
    const struct pp_path_tracer_options wanted = {.error = options->error,
                                                  .samples = options->samples,
                                                  .seed = options->seed,
                                                  .threads = options->threads,
                                                  .average = true};
    enum pp_status status =
        pp_light_scene_under(&run->environment, scene, &report->light, err);
    if (status == PP_OK)
        status = pp_path_tracer_create(&run->tracer, scene, run->environment,
                                       report->receivers, report->receiver_count,
                                       &wanted, err);
    return status;
}

static enum pp_status create_plain_engine(void **data,
                                          const struct pp_light_scene *scene,
                                          const struct pp_report *report,
                                          const struct pp_engine_options *options,
                                          struct pp_error *err)
{
    struct plain_run *run = calloc(1, sizeof *run);
    if (!run)
        return pp_fail_memory(err);
    enum pp_status status = make_plain_engine(run, scene, report, options, err);
    if (status != PP_OK) {
        destroy_plain_engine(run);
        run = NULL;
    }
    *data = run;
    return status;
}

static enum pp_status advance_plain_engine(void *data, double seconds,
                                           struct pp_error *err)
{
    struct plain_run *run = data;
    return pp_path_tracer_advance(run->tracer, seconds, err);
}

static bool plain_engine_done(const void *data)
{
    const struct plain_run *run = data;
    return pp_path_tracer_done(run->tracer);
}

static double plain_engine_progress(const void *data)
{
    const struct plain_run *run = data;
    return pp_path_tracer_progress(run->tracer);
}

static double plain_engine_error(const void *data)
{
    const struct plain_run *run = data;
    return pp_path_tracer_error(run->tracer);
}

static void read_plain_engine(const void *data, int index,
                              struct pp_reading readings[PP_COMPONENT_COUNT])
{
    const struct plain_run *run = data;
    pp_path_tracer_read(run->tracer, index, readings);
}

const struct pp_engine pp_engine_plain = {
    .name = "plain",
    .column = "plain",
    .summary = "light paths by the textbook: slow, to check the others",
    .said = "by plain path tracing",
    .deviation = "one standard error",
    .from = "from plain, %",
    .is_truth = true,
    .is_sampled = true,
    .create = create_plain_engine,
    .advance = advance_plain_engine,
    .done = plain_engine_done,
    .progress = plain_engine_progress,
    .error = plain_engine_error,
    .read = read_plain_engine,
    .destroy = destroy_plain_engine,
};
