/* engine_path.c - the unbiased path tracer of simulate/tracer as an engine. */
#include "studies/engines/engine.h"
#include "simulate/tracer/tracer.h"

static enum pp_status create(void **run, const struct pp_report *report,
                             const struct pp_engine_options *options,
                             struct pp_error *err)
{
    const struct pp_tracer_options wanted = {.error = options->error,
                                             .samples = options->samples,
                                             .seed = options->seed,
                                             .threads = options->threads,
                                             .average = true};
    struct pp_tracer *tracer = NULL;
    enum pp_status status = pp_tracer_create(&tracer, report->world, report->receivers,
                                             report->receiver_count, &wanted, err);
    *run = tracer;
    return status;
}

static enum pp_status advance(void *run, double seconds, struct pp_error *err)
{
    return pp_tracer_advance(run, seconds, err);
}

static bool done(const void *run)
{
    return pp_tracer_done(run);
}

static double progress(const void *run)
{
    return pp_tracer_progress(run);
}

static double error(const void *run)
{
    return pp_tracer_error(run);
}

static void read(const void *run, int index,
                 struct pp_reading readings[PP_COMPONENT_COUNT])
{
    pp_tracer_read(run, index, readings);
}

static void destroy(void *run)
{
    pp_tracer_destroy(run);
}

const struct pp_engine pp_engine_path = {
    .name = "path",
    .column = "traced",
    .summary = "light paths from the points, without bias",
    .create = create,
    .advance = advance,
    .done = done,
    .progress = progress,
    .error = error,
    .read = read,
    .destroy = destroy,
};
