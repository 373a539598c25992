/* moment_run.c - see moment_run.h. */
#include "cli/df/moment_run.h"

#include <stdlib.h>

#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "model/base/read_file.h"
#include "reports/annual/moment_report.h"

struct moment_run {
    const struct pp_moment_choice *choice;
    const struct pp_room_options *room;
    enum pp_format format;
    const struct pp_rooms *rooms;
    struct pp_annual_results results;
};

static enum pp_status compute_moment(void *data, struct pp_error *err)
{
    struct moment_run *run = data;
    const struct pp_study_options *study = &run->room->study;
    struct pp_terminal_watch terminal;
    const struct pp_annual_options options = {
        .samples = (int)study->samples,
        .error = study->error,
        .seed = study->seed,
        .threads = study->threads,
        .strict = study->strict,
        .watch = pp_watch_of_terminal(&terminal, run->room->quiet)};
    run->results.list =
        calloc((size_t)run->rooms->count + 1, sizeof *run->results.list);
    enum pp_status status = run->results.list ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++) {
        const struct pp_study_room *room = &run->rooms->list[i];
        struct pp_moment moment;
        run->results.count = i + 1;
        run->results.list[i].file = room->file;
        struct pp_error own = {0};
        status = pp_moment_choice_find(&moment, run->choice, room->world, &own);
        if (status == PP_OK)
            status = pp_moment_turn_slats(room->world, &moment, &own);
        if (status != PP_OK)
            return pp_fail(err, status, "%s: %s", pp_read_file_title(room->file),
                           own.message);
        status = pp_moment_of_room(&run->results.list[i].sheet, room->world,
                                   &room->light, room->receivers, room->receiver_count,
                                   &moment, &options, err);
        if (status == PP_OK && !run->results.list[i].sheet.finished)
            status = pp_fail(err, PP_INTERRUPTED, "%s: interrupted",
                             pp_read_file_title(room->file));
    }
    return status;
}

static enum pp_status print_moment(const void *data, FILE *out, struct pp_error *err)
{
    const struct moment_run *run = data;
    const char *when = run->choice->when;
    switch (run->format) {
    case PP_FORMAT_JSON:
        return pp_moment_report_json(&run->results, when, out, err);
    case PP_FORMAT_CSV:
        return pp_moment_report_csv(&run->results, when, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_moment_report_text(&run->results, when,
                                 pp_terminal_width(run->room->output), out, err);
}

enum pp_exit pp_moment_run(struct pp_moment_choice *choice,
                           const struct pp_room_options *room, enum pp_format format,
                           bool array, const struct pp_rooms *rooms)
{
    enum pp_exit result = pp_moment_choice_load(choice, room->study.strict);
    if (result == PP_EXIT_DONE) {
        struct moment_run run = {.choice = choice,
                                 .room = room,
                                 .format = format,
                                 .rooms = rooms,
                                 .results = {.several = rooms->several || array}};
        pp_interrupt_watch();
        result = pp_job_run(
            &(struct pp_job){room->output, compute_moment, print_moment, NULL, &run});
        for (int i = 0; i < run.results.count; i++)
            pp_annual_sheet_clear(&run.results.list[i].sheet);
        free(run.results.list);
    }
    pp_moment_choice_clear(choice);
    return result;
}
