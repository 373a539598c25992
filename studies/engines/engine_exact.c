/* engine_exact.c - the hand method `exact` as an engine: what comes straight from sky
 * and obstructions, without a random number.
 *
 * It is done after one step of any length, and its standard error is 0 (its error is
 * that of methods/exact/exact.c, 1e-6 or better). It follows no light inside the room,
 * so that there is no internally reflected component and no daylight factor.
 */
#include <stdlib.h>

#include "methods/evaluate.h"
#include "studies/engines/engine.h"

static const char method[] = "exact";

struct exact_run {
    struct pp_report report; /* of that method alone */
    bool done;
};

static void destroy(void *data)
{
    struct exact_run *run = data;
    if (!run)
        return;
    pp_report_clear(&run->report);
    free(run);
}

static enum pp_status create(void **data, const struct pp_report *report,
                             const struct pp_engine_options *options,
                             struct pp_error *err)
{
    (void)options;
    struct exact_run *run = calloc(1, sizeof *run);
    *data = run;
    if (!run)
        return pp_fail_memory(err);
    run->report = (struct pp_report){.world = report->world,
                                     .receivers = report->receivers,
                                     .receiver_count = report->receiver_count};
    return PP_OK;
}

static enum pp_status advance(void *data, double seconds, struct pp_error *err)
{
    (void)seconds;
    struct exact_run *run = data;
    if (run->done)
        return PP_OK;
    enum pp_status status = pp_methods_evaluate(&run->report, method, err);
    run->done = status == PP_OK;
    return status;
}

static bool done(const void *data)
{
    const struct exact_run *run = data;
    return run->done;
}

static double progress(const void *data)
{
    return done(data) ? 1.0 : 0.0;
}

static double error(const void *data)
{
    return done(data) ? 0.0 : NAN;
}

/* The method's own sentences end with the run; readings may outlive it. */
static struct pp_reading reading_of(const struct exact_run *run,
                                    enum pp_component component, int index)
{
    const struct pp_column *column =
        run->done ? pp_report_find(&run->report, component, method) : NULL;
    if (!column)
        return pp_reading_none("not computed yet");
    double value = index < 0 ? column->average.value : column->points[index].value;
    if (isnan(value))
        return pp_reading_none("the method exact has no value here");
    return (struct pp_reading){.value = value, .std_error = 0.0};
}

static void read(const void *data, int index,
                 struct pp_reading readings[PP_COMPONENT_COUNT])
{
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        readings[i] = pp_reading_none(
            "the engine exact follows no light that is reflected in the room");
    readings[PP_SC] = reading_of(data, PP_SC, index);
    readings[PP_ERC] = reading_of(data, PP_ERC, index);
}

const struct pp_engine pp_engine_exact = {
    .name = "exact",
    .column = "direct",
    .summary = "sky and externally reflected component, without chance",
    .create = create,
    .advance = advance,
    .done = done,
    .progress = progress,
    .error = error,
    .read = read,
    .destroy = destroy,
};
