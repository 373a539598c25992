/* engine_path.c - the unbiased path tracer of simulate/tracer as an engine. */
#include <stdlib.h>

#include "simulate/tracer/tracer.h"
#include "studies/engines/engine.h"

/* The light on the scene, and the tracer. */
struct path_run {
    struct pp_environment *environment;
    struct pp_tracer *tracer;
};

static void destroy(void *data)
{
    struct path_run *run = data;
    if (!run)
        return;
    pp_tracer_destroy(run->tracer);
    pp_environment_destroy(run->environment);
    free(run);
}

static enum pp_status make(struct path_run *run, const struct pp_light_scene *scene,
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
    enum pp_status status =
        pp_light_scene_under(&run->environment, scene, &report->light, err);
    if (status == PP_OK)
        status =
            pp_tracer_create(&run->tracer, scene, run->environment, report->receivers,
                             report->receiver_count, &wanted, err);
    return status;
}

static enum pp_status create(void **data, const struct pp_light_scene *scene,
                             const struct pp_report *report,
                             const struct pp_engine_options *options,
                             struct pp_error *err)
{
    struct path_run *run = calloc(1, sizeof *run);
    if (!run)
        return pp_fail_memory(err);
    enum pp_status status = make(run, scene, report, options, err);
    if (status != PP_OK) {
        destroy(run);
        run = NULL;
    }
    *data = run;
    return status;
}

static enum pp_status advance(void *data, double seconds, struct pp_error *err)
{
    struct path_run *run = data;
    return pp_tracer_advance(run->tracer, seconds, err);
}

static bool done(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_done(run->tracer);
}

static double progress(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_progress(run->tracer);
}

static double error(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_error(run->tracer);
}

static void read(const void *data, int index,
                 struct pp_reading readings[PP_COMPONENT_COUNT])
{
    const struct path_run *run = data;
    pp_tracer_read(run->tracer, index, readings);
}

static double common(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_common(run->tracer);
}

static double common_near(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_common_near(run->tracer);
}

const struct pp_engine pp_engine_path = {
    .name = "path",
    .column = "traced",
    .summary = "light paths from the points, without bias",
    .said = "by simulation",
    .deviation = "one standard error",
    .from = "from traced, %",
    .is_truth = true,
    .is_sampled = true,
    .plain = &pp_engine_plain,
    .create = create,
    .advance = advance,
    .done = done,
    .progress = progress,
    .error = error,
    .read = read,
    .common = common,
    .common_near = common_near,
    .destroy = destroy,
};
