#include "cli/study_report.h"

#include <omp.h>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "methods/evaluate.h"
#include "model/base/clock.h"
#include "simulate/tracer/tracer.h"

/* Between two looks at the clock, the interrupt and the progress bar. */
static const double slice_s = 0.1;

enum pp_status pp_study_report_methods(struct pp_report *report,
                                       const struct pp_loaded_room *room,
                                       const struct pp_room_options *options,
                                       struct pp_error *err)
{
    *report = (struct pp_report){.world = room->world,
                                 .options = &options->method_options,
                                 .receivers = room->receivers,
                                 .receiver_count = room->receiver_count,
                                 .finished = true,
                                 .explain = options->explain};
    if (options->threads > 0)
        omp_set_num_threads(options->threads);
    return pp_methods_evaluate(report, options->methods, err);
}

/* Until the tracer is done, the time is over, or somebody interrupts. */
static enum pp_status trace(struct pp_tracer *tracer, struct pp_report *report,
                            const struct pp_room_options *options,
                            struct pp_progress *progress, bool *by_clock,
                            struct pp_error *err)
{
    *by_clock = false;
    while (!pp_tracer_done(tracer)) {
        if (pp_interrupt_came()) {
            report->finished = false;
            break;
        }
        double spent = pp_clock_s() - progress->started_s;
        double slice = slice_s;
        if (options->seconds > 0.0) {
            *by_clock = spent >= options->seconds;
            if (*by_clock)
                break;
            slice = fmin(slice, options->seconds - spent);
        }
        enum pp_status status = pp_tracer_advance(tracer, slice, err);
        if (status != PP_OK)
            return status;

        double done = pp_tracer_progress(tracer);
        if (options->seconds > 0.0)
            done = fmax(done, spent / options->seconds);
        pp_progress_show(progress, done, pp_tracer_error(tracer));
    }
    return PP_OK;
}

/* One column for each component, with what the tracer knows. */
static enum pp_status add_columns(struct pp_report *report,
                                  const struct pp_tracer *tracer, struct pp_error *err)
{
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        struct pp_column *column = pp_report_add(report, component, "traced", true);
        if (!column)
            return pp_fail_memory(err);
        struct pp_reading readings[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, -1, readings);
        column->average = readings[component];
        for (int i = 0; i < report->receiver_count; i++) {
            pp_tracer_read(tracer, i, readings);
            column->points[i] = readings[component];
        }
    }
    return PP_OK;
}

enum pp_status pp_study_report_traced(struct pp_report *report,
                                      const struct pp_room_options *options,
                                      bool *by_clock, struct pp_error *err)
{
    const char *name = report->world->name;
    struct pp_progress progress;
    pp_progress_begin(&progress, name ? name : "room", options->quiet);

    const struct pp_tracer_options traced = {.error = options->error,
                                             .samples = options->samples,
                                             .seed = options->seed,
                                             .threads = options->threads,
                                             .average = true};
    struct pp_tracer *tracer;
    enum pp_status status = pp_tracer_create(&tracer, report->world, report->receivers,
                                             report->receiver_count, &traced, err);
    if (status != PP_OK)
        return status;
    status = trace(tracer, report, options, &progress, by_clock, err);
    pp_progress_end(&progress);
    if (status == PP_OK)
        status = add_columns(report, tracer, err);
    pp_tracer_destroy(tracer);
    return status;
}
