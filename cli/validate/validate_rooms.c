/* validate_rooms.c - lists reports for all rooms and for their simplified versions,
 * which satisfy the assumptions of a method. The reports are simulated, distributed
 * over ranks. Rank 0 compares the results. */
#include "cli/validate/validate_rooms.h"

#include <stdlib.h>

#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/ranks/room_queue.h"
#include "cli/terminal.h"
#include "cli/validate/run_suite.h"
#include "reports/df_result.h"
#include "reports/validate/validate_report.h"
#include "studies/bands/report_bands.h"
#include "studies/study_report.h"
#include "studies/research/validation/own_world.h"
#include "studies/research/validation/room_cases.h"

/* A report to be simulated: for a room, or for a simplified version of the room that
 * satisfies the assumptions of a method. */
struct traced_report {
    struct pp_report *report;
    int room;
    int own; /* index of the simplified version; -1: the room itself */
};

struct rooms_run {
    const struct pp_room_options *options;
    enum pp_format format;
    const struct pp_rooms *rooms;
    struct pp_results results;
    struct pp_validation validation;
    struct pp_own_worlds **worlds; /* simplified versions of each room */
    struct traced_report *traced;  /* each room, followed by its simplified versions */
    int traced_count;
};

static enum pp_status begin_rooms_run(struct rooms_run *run, struct pp_error *err)
{
    size_t count = (size_t)run->rooms->count + 1;
    run->results.list = calloc(count, sizeof *run->results.list);
    run->validation.rooms = calloc(count, sizeof *run->validation.rooms);
    run->validation.counts = calloc(count, sizeof *run->validation.counts);
    run->worlds = calloc(count, sizeof *run->worlds);
    return run->results.list && run->validation.rooms && run->validation.counts
                   && run->worlds
               ? PP_OK
               : pp_fail_memory(err);
}

/* Evaluates the hand methods, which take milliseconds, and lists the simplified
 * versions of the rooms. */
static enum pp_status work_by_hand(struct rooms_run *run, struct pp_error *err)
{
    struct pp_results *results = &run->results;
    enum pp_status status = PP_OK;
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++) {
        const struct pp_study_room *room = &run->rooms->list[i];
        struct pp_result *result = &results->list[results->count++];
        result->file = room->file;
        status = pp_study_report_methods(&result->report, room, results->options, err);
        if (status == PP_OK)
            status =
                pp_own_world_list(&run->worlds[i], room->room, &result->report, err);
    }
    return status;
}

static enum pp_status list_traced(struct rooms_run *run, struct pp_error *err)
{
    int count = run->rooms->count;
    for (int i = 0; i < run->rooms->count; i++)
        count += pp_own_world_count(run->worlds[i]);
    run->traced = calloc((size_t)count + 1, sizeof *run->traced);
    if (!run->traced)
        return pp_fail_memory(err);
    for (int i = 0; i < run->rooms->count; i++) {
        run->traced[run->traced_count++] =
            (struct traced_report){&run->results.list[i].report, i, -1};
        for (int k = 0; k < pp_own_world_count(run->worlds[i]); k++)
            run->traced[run->traced_count++] =
                (struct traced_report){pp_own_world_report(run->worlds[i], k), i, k};
    }
    return PP_OK;
}

static struct pp_room_figures validated_room_figures(void *data, int index)
{
    struct rooms_run *run = data;
    const struct traced_report *traced = &run->traced[index];
    return (struct pp_room_figures){traced->report,
                                    &run->results.list[traced->room].by_clock};
}

/* Simulates one report. After an interrupt, a room has the results so far, and later
 * simplified versions have none. */
static enum pp_status simulate_validated_room(const void *data, int index,
                                              struct pp_report *report, bool *by_clock,
                                              struct pp_error *err)
{
    const struct rooms_run *run = data;
    int room = run->traced[index].room, own = run->traced[index].own;
    struct pp_study_options options = *run->results.options;
    if (own >= 0 && pp_interrupt_came()) {
        report->finished = false;
        return PP_OK;
    }
    options.seconds /= 1 + pp_own_world_count(run->worlds[room]);
    return own < 0 ? pp_study_report_traced(report, &options, by_clock, err)
                   : pp_own_world_trace_one(run->worlds[room], own, report, &options,
                                            by_clock, err);
}

static enum pp_status compare_validated_rooms(struct rooms_run *run,
                                              struct pp_error *err)
{
    struct pp_validation *validation = &run->validation;
    enum pp_status status = PP_OK;
    for (int i = 0; i < run->traced_count; i++)
        run->results.list[run->traced[i].room].report.finished &=
            run->traced[i].report->finished;
    for (int i = 0; i < run->results.count && status == PP_OK; i++)
        status =
            pp_comparison_of_report(&validation->rooms[i], &validation->counts[i],
                                    &run->results.list[i].report, run->worlds[i], err);
    return status == PP_OK
               ? pp_comparison_overall(&validation->overall, &validation->overall_count,
                                       validation->rooms, validation->counts,
                                       run->results.count, err)
               : status;
}

static enum pp_status trace_validated_rooms(struct rooms_run *run, struct pp_error *err)
{
    enum pp_status status = begin_rooms_run(run, err);
    if (status == PP_OK)
        status = work_by_hand(run, err);
    if (status == PP_OK)
        status = list_traced(run, err);
    if (status != PP_OK)
        return status;
    pp_interrupt_watch();
    return pp_room_queue_run(
        &(struct pp_room_queue){run->traced_count, run->options->ranks,
                                validated_room_figures, simulate_validated_room, run},
        err);
}

static bool validated_rooms_are_finished(const void *data)
{
    const struct rooms_run *run = data;
    for (int i = 0; i < run->results.count; i++)
        if (!run->results.list[i].report.finished)
            return false;
    return true;
}

static struct rooms_run run_of(const struct pp_rooms *rooms,
                               const struct pp_room_options *options,
                               enum pp_format format)
{
    return (struct rooms_run){
        .options = options,
        .format = format,
        .rooms = rooms,
        .results = {.several = rooms->several,
                    .more_than_one_file = rooms->more_than_one_file,
                    .options = &options->study}};
}

static void clear_rooms_run(struct rooms_run *run)
{
    for (int i = 0; i < run->results.count; i++) {
        pp_report_clear(&run->results.list[i].report);
        pp_own_world_destroy(run->worlds[i]);
        free(run->validation.rooms[i]);
    }
    free(run->validation.rooms);
    free(run->validation.counts);
    free(run->validation.overall);
    free(run->worlds);
    free(run->traced);
    free(run->results.list);
}

/* ---- the table ---- */

static enum pp_status compute_validated_rooms(void *data, struct pp_error *err)
{
    enum pp_status status = trace_validated_rooms(data, err);
    return status == PP_OK ? compare_validated_rooms(data, err) : status;
}

static enum pp_status print_validated_rooms(const void *data, FILE *out,
                                            struct pp_error *err)
{
    const struct rooms_run *run = data;
    struct pp_validation validation = run->validation;
    validation.results = &run->results;
    if (run->format == PP_FORMAT_JSON)
        return pp_validate_report_rooms_json(&validation, out, err);
    if (run->format == PP_FORMAT_CSV)
        pp_validate_report_rooms_csv(&validation, out);
    else
        pp_validate_report_rooms(&validation, pp_terminal_width(run->options->output),
                                 out);
    return PP_OK;
}

enum pp_exit pp_validate_rooms(const struct pp_rooms *rooms,
                               const struct pp_room_options *options,
                               enum pp_format format)
{
    struct rooms_run run = run_of(rooms, options, format);
    enum pp_exit exit_status = pp_job_run(
        &(struct pp_job){options->output, compute_validated_rooms,
                         print_validated_rooms, validated_rooms_are_finished, &run});
    clear_rooms_run(&run);
    return exit_status;
}

/* ---- the suite ---- */

static enum pp_status find_cases(void *data, struct pp_known_cases *cases,
                                 struct pp_error *err)
{
    struct rooms_run *run = data;
    enum pp_status status = trace_validated_rooms(run, err);
    if (status == PP_OK)
        status = compare_validated_rooms(run, err);
    for (int i = 0; i < run->results.count && status == PP_OK; i++) {
        struct pp_result *result = &run->results.list[i];
        status = pp_report_bands_fill(&result->report, err);
        if (status == PP_OK)
            pp_room_cases_of_methods(cases, result->file, &result->report,
                                     run->worlds[i]);
    }
    return status;
}

enum pp_exit pp_validate_rooms_suite(const struct pp_rooms *rooms,
                                     const struct pp_room_options *options,
                                     enum pp_format format, const char *page)
{
    struct rooms_run run = run_of(rooms, options, format);
    enum pp_exit exit_status =
        pp_run_suite(&(struct pp_suite_source){&pp_suite_rooms, find_cases,
                                               validated_rooms_are_finished, &run},
                     options, format, page);
    clear_rooms_run(&run);
    return exit_status;
}
