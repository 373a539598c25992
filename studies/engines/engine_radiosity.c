/* engine_radiosity.c - the finite elements of simulate/radiosity as an engine. */
#include "simulate/radiosity/radiosity.h"
#include "studies/engines/engine.h"

static enum pp_status create(void **data, const struct pp_light_scene *scene,
                             const struct pp_report *report,
                             const struct pp_engine_options *options,
                             struct pp_error *err)
{
    const struct pp_radiosity_options wanted = {.error = options->error,
                                                .threads = options->threads};
    struct pp_radiosity *radiosity;
    (void)scene; /* it has its own */
    enum pp_status status =
        pp_radiosity_create(&radiosity, report->world, &report->light,
                            report->receivers, report->receiver_count, &wanted, err);
    *data = radiosity;
    return status;
}

static enum pp_status advance(void *data, double seconds, struct pp_error *err)
{
    (void)seconds; /* a level takes what it takes */
    return pp_radiosity_advance(data, err);
}

static bool done(const void *data)
{
    return pp_radiosity_done(data);
}

static double progress(const void *data)
{
    return pp_radiosity_progress(data);
}

static double error(const void *data)
{
    return pp_radiosity_error(data);
}

static void read(const void *data, int index,
                 struct pp_reading readings[PP_COMPONENT_COUNT])
{
    pp_radiosity_read(data, index, readings);
}

static void destroy(void *data)
{
    pp_radiosity_destroy(data);
}

const struct pp_engine pp_engine_radiosity = {
    .name = "radiosity",
    .column = "radiosity",
    .summary = "finite elements, without random numbers",
    .said = "by finite elements",
    .deviation = "an error that 19 of 20 keep, by refinement",
    .from = "from radiosity, %",
    .is_truth = true,
    .is_sampled = false,
    .create = create,
    .advance = advance,
    .done = done,
    .progress = progress,
    .error = error,
    .read = read,
    .destroy = destroy,
};
