/* study_report.c - makes a report with the columns of the methods, and adds those of a
 * simulation, whose progress is reported to a watch. */
#include "studies/study_report.h"

#include "methods/evaluate.h"
#include "studies/plane_figures.h"

enum pp_status pp_study_report_methods(struct pp_report *report,
                                       const struct pp_study_room *room,
                                       const struct pp_study_options *options,
                                       struct pp_error *err)
{
    *report = (struct pp_report){.world = room->world,
                                 .light = room->light,
                                 .options = &options->method_options,
                                 .receivers = room->receivers,
                                 .receiver_count = room->receiver_count,
                                 .finished = true,
                                 .explain = options->explain,
                                 .threads = options->threads};
    return pp_methods_evaluate(report, options->methods, err);
}

enum pp_status pp_study_report_with_plane(struct pp_report *report,
                                          const struct pp_study_room *room,
                                          const struct pp_study_options *options,
                                          struct pp_error *err)
{
    if (options->explain)
        return pp_study_report_methods(report, room, options, err);
    struct pp_study_room wider = *room;
    *report = (struct pp_report){.finished = true};
    enum pp_status status =
        pp_plane_figures_receivers(&wider.receivers, &wider.receiver_count, room, err);
    if (status != PP_OK)
        return status;
    status = pp_study_report_methods(report, &wider, options, err);
    report->more_receivers = wider.receivers;
    return status;
}

enum pp_status pp_study_report_settle(struct pp_report *report,
                                      const struct pp_study_room *room,
                                      struct pp_error *err)
{
    return report->explain ? PP_OK : pp_plane_figures_fill(report, room, err);
}

enum pp_status pp_study_report_traced(struct pp_report *report,
                                      const struct pp_study_options *options,
                                      bool *by_clock, struct pp_error *err)
{
    return pp_study_report_simulate(report, &pp_engine_path,
                                    (struct pp_engine_options){0}, options, by_clock,
                                    NULL, err);
}

enum pp_status pp_study_report_traced_direct(struct pp_report *report,
                                             const struct pp_study_options *options,
                                             bool *by_clock, struct pp_error *err)
{
    return pp_study_report_simulate(report, &pp_engine_path,
                                    (struct pp_engine_options){.direct = true}, options,
                                    by_clock, NULL, err);
}

enum pp_status pp_study_report_simulate(struct pp_report *report,
                                        const struct pp_engine *engine,
                                        struct pp_engine_options engine_options,
                                        const struct pp_study_options *options,
                                        bool *by_clock, struct pp_kept_bytes *kept,
                                        struct pp_error *err)
{
    engine_options.error = options->error;
    engine_options.samples = options->samples;
    engine_options.seed = options->seed;
    engine_options.threads = options->threads;
    engine_options.alone = options->alone;
    engine_options.plain = options->method_options.plain;
    struct pp_simulation *simulation;
    enum pp_simulation_end end;
    enum pp_status status =
        pp_simulation_create(&simulation, engine, report, &engine_options, err);
    if (status != PP_OK)
        return status;
    status = pp_simulation_run(simulation, options->seconds, &options->watch,
                               report->world->name, &end, err);
    if (status == PP_OK) {
        report->finished &= end != PP_SIMULATION_STOPPED;
        *by_clock |= end == PP_SIMULATION_BY_CLOCK;
        status = pp_simulation_add_columns(simulation, report, err);
    }
    if (status == PP_OK && kept && end != PP_SIMULATION_STOPPED)
        status = pp_simulation_keep(simulation, &kept->bytes, &kept->length, err);
    pp_simulation_destroy(simulation);
    return status;
}
