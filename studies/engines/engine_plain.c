/* engine_plain.c - adapts the plain path tracer (simulate/path_tracer) as an engine.
 * The plain path tracer computes the same values as engine_path.c by the textbook
 * algorithm. */
#include "simulate/path_tracer/path_tracer.h"
#include "studies/engines/engine.h"

static enum pp_status create_plain_engine(void **run,
                                          const struct pp_light_scene *scene,
                                          const struct pp_environment *environment,
                                          const struct pp_report *report,
                                          const struct pp_engine_options *options,
                                          struct pp_error *err)
{
    const struct pp_path_tracer_options wanted = {.error = options->error,
                                                  .samples = options->samples,
                                                  .seed = options->seed,
                                                  .threads = options->threads,
                                                  .average = true};
    struct pp_path_tracer *solver;
    enum pp_status status =
        pp_path_tracer_create(&solver, scene, environment, report->receivers,
                              report->receiver_count, &wanted, err);
    if (status == PP_OK)
        *run = solver;
    return status;
}

static enum pp_status advance_plain_engine(void *run, double seconds,
                                           struct pp_error *err)
{
    return pp_path_tracer_advance(run, seconds, err);
}

static bool plain_engine_done(const void *run)
{
    return pp_path_tracer_done(run);
}

static double plain_engine_progress(const void *run)
{
    return pp_path_tracer_progress(run);
}

static double plain_engine_error(const void *run)
{
    return pp_path_tracer_error(run);
}

static void read_plain_engine(const void *run, int index,
                              struct pp_reading readings[PP_COMPONENT_COUNT])
{
    pp_path_tracer_read(run, index, readings);
}

static void destroy_plain_engine(void *run)
{
    pp_path_tracer_destroy(run);
}

const struct pp_engine pp_engine_plain = {
    .name = "plain",
    .column = "plain",
    .summary = "textbook path tracing: slow, for checks of the other engines",
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
