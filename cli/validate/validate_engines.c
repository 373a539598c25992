/* validate_engines.c - a report a room, to which each engine adds its columns. */
#include "cli/validate/validate_engines.h"

#include <stdlib.h>

#include "cli/interrupt.h"
#include "cli/ranks/room_queue.h"
#include "cli/validate/run_suite.h"
#include "reports/df_result.h"
#include "simulate/cache/irradiance_cache.h"
#include "studies/study_report.h"
#include "studies/research/validation/room_cases.h"

struct engines_run {
    const struct pp_room_options *options;
    const struct pp_rooms *rooms;
    struct pp_result *results; /* one a room */
    int count;
};

static struct pp_room_figures engine_room_figures(void *data, int index)
{
    struct pp_result *result = &((struct engines_run *)data)->results[index];
    return (struct pp_room_figures){&result->report, &result->by_clock};
}

/* Divides the room's time among the engines. */
static enum pp_status simulate_by_engines(const void *data, int index,
                                          struct pp_report *report, bool *by_clock,
                                          struct pp_error *err)
{
    const struct engines_run *run = data;
    const struct pp_engine_options cached = {.cache = pp_irradiance_cache_defaults()};
    struct pp_study_options study = run->options->study;
    enum pp_status status = PP_OK;
    int engines = 0;
    (void)index;
    while (pp_engine_at(engines))
        engines++;
    study.seconds /= engines;
    for (int i = 0; i < engines && status == PP_OK; i++) {
        if (pp_interrupt_came())
            report->finished = false;
        else
            status = pp_study_report_simulate(report, pp_engine_at(i), cached, &study,
                                              by_clock, NULL, err);
    }
    return status;
}

static enum pp_status find_cases(void *data, struct pp_known_cases *cases,
                                 struct pp_error *err)
{
    struct engines_run *run = data;
    enum pp_status status = PP_OK;
    run->results = calloc((size_t)run->rooms->count + 1, sizeof *run->results);
    if (!run->results)
        return pp_fail_memory(err);
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++) {
        struct pp_result *result = &run->results[run->count++];
        result->file = run->rooms->list[i].file;
        status = pp_study_report_methods(&result->report, &run->rooms->list[i],
                                         &run->options->study, err);
    }
    pp_interrupt_watch();
    if (status == PP_OK)
        status = pp_room_queue_run(
            &(struct pp_room_queue){run->count, run->options->ranks,
                                    engine_room_figures, simulate_by_engines, run},
            err);
    for (int i = 0; i < run->count && status == PP_OK; i++)
        pp_room_cases_of_engines(cases, run->results[i].file, &run->results[i].report);
    return status;
}

static bool engines_are_finished(const void *data)
{
    const struct engines_run *run = data;
    for (int i = 0; i < run->count; i++)
        if (!run->results[i].report.finished)
            return false;
    return true;
}

enum pp_exit pp_validate_engines(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format, const char *page)
{
    struct engines_run run = {.options = options, .rooms = rooms};
    enum pp_exit exit_status =
        pp_run_suite(&(struct pp_suite_source){&pp_suite_engines, find_cases,
                                               engines_are_finished, &run},
                     options, format, page);
    for (int i = 0; i < run.count; i++)
        pp_report_clear(&run.results[i].report);
    free(run.results);
    return exit_status;
}
