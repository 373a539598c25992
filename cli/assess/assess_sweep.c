/* assess_sweep.c - see assess_sweep.h. */
#include "cli/assess/assess_sweep.h"

#include <stdlib.h>

#include "cli/assess/assess_run.h"
#include "cli/message.h"
#include "cli/sweep/sweep_job.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "reports/sweep/sweep_text.h"

struct assess_sweep {
    struct pp_assess_words *words;
    char **files;
    int file_count;
    struct pp_assess_rooms *rooms; /* the rooms of each run */
    struct pp_assess_run *runs;
    enum pp_status (*print)(const void *data, FILE *out, struct pp_error *err);
};

static enum pp_exit load_assess_run(void *data, int run)
{
    struct assess_sweep *sweep = data;
    enum pp_exit exit_status = pp_assess_run_load(
        &sweep->rooms[run], sweep->words, "assess", sweep->files, sweep->file_count);
    sweep->runs[run] = pp_assess_run_of(sweep->words, &sweep->rooms[run]);
    return exit_status;
}

static enum pp_status compute_assess_run(void *data, int run, struct pp_error *err)
{
    return pp_assess_run_compute(&((struct assess_sweep *)data)->runs[run], err);
}

static bool assess_sweep_is_finished(const void *data, int run)
{
    return pp_assess_run_is_finished(&((const struct assess_sweep *)data)->runs[run]);
}

static enum pp_status print_assess_run(const void *data, int run, FILE *out,
                                       struct pp_error *err)
{
    const struct assess_sweep *sweep = data;
    return sweep->print(&sweep->runs[run], out, err);
}

static enum pp_status print_assess_table(const void *data, FILE *out,
                                         struct pp_error *err)
{
    const struct assess_sweep *sweep = data;
    const struct pp_sweep *values = &sweep->words->room.sweep;
    int count = pp_sweep_count(values);
    const struct pp_assessments **results = calloc((size_t)count, sizeof *results);
    if (!results)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        results[i] = &sweep->runs[i].all;
    enum pp_status status = pp_sweep_assess_text(
        values, results, pp_terminal_width(sweep->words->room.output),
        pp_terminal_utf8(), out, err);
    free(results);
    return status;
}

enum pp_exit pp_assess_sweep_run(struct pp_assess_words *words, char **files,
                                 int file_count,
                                 enum pp_status (*print)(const void *data, FILE *out,
                                                         struct pp_error *err))
{
    struct pp_terminal_watch watch;
    struct pp_error err;
    int count = pp_sweep_count(&words->room.sweep);
    struct assess_sweep sweep = {words,
                                 files,
                                 file_count,
                                 calloc((size_t)count, sizeof *sweep.rooms),
                                 calloc((size_t)count, sizeof *sweep.runs),
                                 print};
    words->room.study.watch = pp_watch_of_terminal(&watch, words->room.quiet);
    enum pp_exit exit_status = sweep.rooms && sweep.runs
                                   ? pp_assess_run_weather(words)
                                   : (pp_fail_memory(&err), pp_message_error(&err));
    if (exit_status == PP_EXIT_DONE)
        exit_status = pp_sweep_job_run(&(struct pp_sweep_job){
            &words->room, words->format, load_assess_run, compute_assess_run,
            assess_sweep_is_finished, print_assess_run, print_assess_table, &sweep});
    for (int i = 0; i < count && sweep.rooms && sweep.runs; i++) {
        pp_assess_run_clear(&sweep.runs[i]);
        pp_assess_run_unload(&sweep.rooms[i]);
    }
    free(sweep.runs);
    free(sweep.rooms);
    return exit_status;
}
