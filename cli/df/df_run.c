/* df_run.c - see df_run.h. */
#include "cli/df/df_run.h"

#include <stdlib.h>

#include "cli/interrupt.h"
#include "cli/ranks/room_queue.h"
#include "cli/sweep/sweep_job.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "methods/method.h"
#include "reports/df_csv.h"
#include "reports/df_json.h"
#include "reports/df_text.h"
#include "reports/sweep/sweep_text.h"
#include "studies/bands/report_bands.h"
#include "studies/plane_margin.h"
#include "studies/study_report.h"

/* Runs the selected engines, and saves the cache file. */
static enum pp_status simulate_df_room(struct pp_report *report, bool *by_clock,
                                       const struct pp_study_options *study,
                                       const struct pp_engine_choice *choice,
                                       struct pp_error *err)
{
    const struct pp_engine_options options = {.sensor_m = choice->sensor_m,
                                              .cache = choice->cache.options,
                                              .interpolate = choice->interpolate,
                                              .cache_file = choice->cache.file};
    struct pp_kept_bytes kept = {0};
    enum pp_status status = PP_OK;
    const struct pp_engine *engine;
    for (int i = 0; (engine = pp_engine_at(i)) != NULL && status == PP_OK; i++)
        if (pp_engine_choice_has(choice, i))
            status = pp_study_report_simulate(
                report, engine, options, study, by_clock,
                engine->keep && choice->cache.file ? &kept : NULL, err);
    if (status == PP_OK && kept.bytes && report->finished)
        status = pp_cache_choice_write(&choice->cache, kept.bytes, kept.length, err);
    free(kept.bytes);
    return status;
}

/* Adds averages over the plane without its margin, by the same methods and
 * simulation. */
static enum pp_status add_margin(struct pp_result *result,
                                 const struct pp_study_room *room,
                                 const struct pp_df_options *options,
                                 struct pp_error *err)
{
    struct pp_study_options study = options->room.study;
    struct pp_engine_choice engine = options->engine;
    struct pp_result inside = {.file = result->file, .report = {.finished = true}};
    struct pp_plane_margin margin;
    engine.cache.file = NULL;
    study.explain = false;
    enum pp_status status = pp_plane_margin_init(&margin, room, err);
    if (status == PP_OK && margin.has_plane)
        status = pp_study_report_methods(&inside.report, &margin.room, &study, err);
    if (status == PP_OK && margin.has_plane && study.simulate)
        status =
            simulate_df_room(&inside.report, &inside.by_clock, &study, &engine, err);
    if (status == PP_OK)
        status = pp_plane_margin_take(&result->report,
                                      margin.has_plane ? &inside.report : NULL, err);
    result->report.finished &= inside.report.finished;
    result->by_clock |= inside.by_clock;
    pp_report_clear(&inside.report);
    pp_plane_margin_clear(&margin);
    return status;
}

/* Adds a recommendation of methods, based on the results of all methods. */
static enum pp_status add_advice(struct pp_result *result,
                                 const struct pp_study_room *room,
                                 const struct pp_df_options *options,
                                 struct pp_error *err)
{
    struct pp_study_options study = options->room.study;
    struct pp_report all;
    study.methods = "all";
    study.explain = false;
    enum pp_status status = pp_study_report_methods(&all, room, &study, err);
    if (status == PP_OK)
        status = pp_advice_of(&result->advice, &all, err);
    result->has_advice = status == PP_OK;
    pp_report_clear(&all);
    return status;
}

static struct pp_room_figures df_room_figures(void *data, int room)
{
    struct pp_result *result = &((struct pp_df_run *)data)->results.list[room];
    return (struct pp_room_figures){&result->report, &result->by_clock};
}

static enum pp_status simulate_room(const void *data, int room,
                                    struct pp_report *report, bool *by_clock,
                                    struct pp_error *err)
{
    const struct pp_df_run *run = data;
    (void)room;
    return simulate_df_room(report, by_clock, run->results.options,
                            &run->options->engine, err);
}

/* Hand methods run before the simulation: they take milliseconds, and are complete even
 * if the simulation is interrupted. */
enum pp_status pp_df_run_compute(void *data, struct pp_error *err)
{
    struct pp_df_run *run = data;
    struct pp_results *results = &run->results;
    const struct pp_rooms *rooms = run->rooms;
    enum pp_status status = PP_OK;
    results->list = calloc((size_t)rooms->count + 1, sizeof *results->list);
    if (!results->list)
        return pp_fail_memory(err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        struct pp_result *result = &results->list[results->count++];
        result->file = rooms->list[i].file;
        result->doubts = rooms->list[i].doubts;
        status = pp_study_report_with_plane(&result->report, &rooms->list[i],
                                            results->options, err);
    }
    if (status == PP_OK && results->options->simulate)
        pp_interrupt_watch();
    if (status == PP_OK)
        status = pp_room_queue_run(
            &(struct pp_room_queue){results->options->simulate ? results->count : 0,
                                    run->options->room.ranks, df_room_figures,
                                    simulate_room, run},
            err);
    for (int i = 0; i < results->count && status == PP_OK && run->options->margin; i++)
        status = add_margin(&results->list[i], &rooms->list[i], run->options, err);
    for (int i = 0; i < results->count && status == PP_OK; i++)
        status = pp_study_report_settle(&results->list[i].report, &rooms->list[i], err);
    for (int i = 0; i < results->count && status == PP_OK && !run->options->no_bands;
         i++)
        status = pp_report_bands_fill(&results->list[i].report, err);
    for (int i = 0; i < results->count && status == PP_OK && run->options->advise; i++)
        status = add_advice(&results->list[i], &rooms->list[i], run->options, err);
    return status;
}

enum pp_status pp_df_run_print(const void *data, FILE *out, struct pp_error *err)
{
    const struct pp_df_run *run = data;
    switch (run->options->format) {
    case PP_FORMAT_JSON:
        return pp_df_json(&run->results, out, err);
    case PP_FORMAT_CSV:
        return pp_df_csv(&run->results, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_df_text(&run->results, pp_terminal_width(run->options->room.output),
                      pp_terminal_utf8(), out, err);
}

bool pp_df_run_is_finished(const void *data)
{
    const struct pp_df_run *run = data;
    for (int i = 0; i < run->results.count; i++)
        if (!run->results.list[i].report.finished)
            return false;
    return true;
}

struct pp_df_run pp_df_run_of(const struct pp_df_options *options,
                              const struct pp_rooms *rooms)
{
    return (struct pp_df_run){
        .options = options,
        .rooms = rooms,
        .results = {.several = rooms->several || options->array,
                    .more_than_one_file = rooms->more_than_one_file,
                    .bands = options->bands,
                    .options = &options->room.study}};
}

void pp_df_run_clear(struct pp_df_run *run)
{
    for (int i = 0; i < run->results.count; i++) {
        pp_report_clear(&run->results.list[i].report);
        pp_advice_clear(&run->results.list[i].advice);
    }
    free(run->results.list);
}

/* ---- --sweep ---- */

struct df_sweep {
    const struct pp_df_options *options;
    char **files;
    int file_count;
};

/* One run of the sweep. The first member is a struct pp_df_run, so a pointer to this
 * struct can be passed to functions that expect one. */
struct df_sweep_run {
    struct pp_df_run df;
    struct pp_rooms rooms;
};

static enum pp_exit load_df_run(void *run, const void *data)
{
    const struct df_sweep *sweep = data;
    struct df_sweep_run *one = run;
    enum pp_exit exit_status = pp_rooms_load(&one->rooms, "df", sweep->files,
                                             sweep->file_count, &sweep->options->room);
    one->df = pp_df_run_of(sweep->options, &one->rooms);
    return exit_status;
}

static void clear_df_run(void *run)
{
    struct df_sweep_run *one = run;
    pp_df_run_clear(&one->df);
    pp_rooms_clear(&one->rooms);
}

static enum pp_status print_df_table(const void *runs, const void *data, FILE *out,
                                     struct pp_error *err)
{
    const struct df_sweep_run *list = runs;
    const struct pp_room_options *room =
        &((const struct df_sweep *)data)->options->room;
    int count = pp_sweep_count(&room->sweep);
    const struct pp_results **results = calloc((size_t)count, sizeof *results);
    if (!results)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        results[i] = &list[i].df.results;
    enum pp_status status =
        pp_sweep_df_text(&room->sweep, results, pp_terminal_width(room->output),
                         pp_terminal_utf8(), out, err);
    free(results);
    return status;
}

enum pp_exit pp_df_run_sweep(struct pp_df_options *options, char **files,
                             int file_count)
{
    struct pp_terminal_watch watch;
    const struct df_sweep sweep = {options, files, file_count};
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    return pp_sweep_job_run(&(struct pp_sweep_job){
        &options->room, options->format, sizeof(struct df_sweep_run), load_df_run,
        pp_df_run_compute, pp_df_run_is_finished, pp_df_run_print, print_df_table,
        clear_df_run, &sweep});
}
