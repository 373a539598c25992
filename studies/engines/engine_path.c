/* engine_path.c - the unbiased path tracer of simulate/fast as an engine. */
#include <stdlib.h>

#include "simulate/fast/tracer.h"
#include "studies/engines/engine.h"

/* The light on the scene, and the tracer. */
struct path_run {
    struct pp_environment *environment;
    struct pp_tracer *tracer;
};

static void destroy_path_engine(void *data)
{
    struct path_run *run = data;
    if (!run)
        return;
    pp_tracer_destroy(run->tracer);
    pp_environment_destroy(run->environment);
    free(run);
}

static enum pp_status make_path_run(struct path_run *run,
                                    const struct pp_light_scene *scene,
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

static enum pp_status create_path_engine(void **data,
                                         const struct pp_light_scene *scene,
                                         const struct pp_report *report,
                                         const struct pp_engine_options *options,
                                         struct pp_error *err)
{
    struct path_run *run = calloc(1, sizeof *run);
    if (!run)
        return pp_fail_memory(err);
    enum pp_status status = make_path_run(run, scene, report, options, err);
    if (status != PP_OK) {
        destroy_path_engine(run);
        run = NULL;
    }
    *data = run;
    return status;
}

static enum pp_status advance_path_engine(void *data, double seconds,
                                          struct pp_error *err)
{
    struct path_run *run = data;
    return pp_tracer_advance(run->tracer, seconds, err);
}

static bool path_engine_done(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_done(run->tracer);
}

static double path_engine_progress(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_progress(run->tracer);
}

static double path_engine_error(const void *data)
{
    const struct path_run *run = data;
    return pp_tracer_error(run->tracer);
}

static void read_path_engine(const void *data, int index,
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
