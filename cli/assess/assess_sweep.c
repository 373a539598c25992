/* assess_sweep.c - see assess_sweep.h. */
#include "cli/assess/assess_sweep.h"

#include <stdlib.h>

#include "cli/assess/assess_run.h"
#include "cli/sweep/sweep_job.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "reports/sweep/sweep_text.h"

struct assess_sweep {
    struct pp_assess_words *words;
    char **files;
    int file_count;
};

/* One run of the sweep. The first member is a struct pp_assess_run, so a pointer to
 * this struct can be passed to functions that expect one. */
struct assess_sweep_run {
    struct pp_assess_run assess;
    struct pp_assess_rooms rooms;
};

static enum pp_exit load_assess_run(void *run, const void *data)
{
    const struct assess_sweep *sweep = data;
    struct assess_sweep_run *one = run;
    enum pp_exit exit_status = pp_assess_run_load(&one->rooms, sweep->words, "assess",
                                                  sweep->files, sweep->file_count);
    one->assess = pp_assess_run_of(sweep->words, &one->rooms);
    return exit_status;
}

static void clear_assess_run(void *run)
{
    struct assess_sweep_run *one = run;
    pp_assess_run_clear(&one->assess);
    pp_assess_run_unload(&one->rooms);
}

static enum pp_status print_assess_table(const void *runs, const void *data, FILE *out,
                                         struct pp_error *err)
{
    const struct assess_sweep_run *list = runs;
    const struct pp_room_options *room =
        &((const struct assess_sweep *)data)->words->room;
    int count = pp_sweep_count(&room->sweep);
    const struct pp_assessments **results = calloc((size_t)count, sizeof *results);
    if (!results)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        results[i] = &list[i].assess.all;
    enum pp_status status =
        pp_sweep_assess_text(&room->sweep, results, pp_terminal_width(room->output),
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
    const struct assess_sweep sweep = {words, files, file_count};
    words->room.study.watch = pp_watch_of_terminal(&watch, words->room.quiet);
    enum pp_exit exit_status = pp_assess_run_weather(words);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    return pp_sweep_job_run(&(struct pp_sweep_job){
        &words->room, words->format, sizeof(struct assess_sweep_run), load_assess_run,
        pp_assess_run_compute, pp_assess_run_is_finished, print, print_assess_table,
        clear_assess_run, &sweep});
}
