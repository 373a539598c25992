/* cmd_validate.c - the command validate: formulae against simulation, and the
 * program against analytic answers. */
#include <stdlib.h>
#include <string.h>

#include "cli/terminal.h"
#include "cli/validate/against_radiance.h"
#include "cli/command.h"
#include "cli/watch.h"
#include "cli/format_option.h"
#include "studies/study_report.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "reports/df_result.h"
#include "reports/validate_report.h"
#include "cli/rooms.h"
#include "methods/evaluate.h"
#include "methods/selection.h"

static const char about[] =
    "Without FILE: the program's answers beside those that are known on paper (open "
    "skies, closed forms of windows, light in a closed room, worked examples). With "
    "room files: each method against the simulation, at the reference points and for "
    "the average over the working plane: bias, spread and the worst point. FILE is a "
    "room file; - is standard input.";

/* ---- known answers ---- */

static enum pp_status print_known(const struct pp_self_test_cases *known,
                                  enum pp_format format, const char *path, FILE *out,
                                  struct pp_error *err)
{
    if (format == PP_FORMAT_JSON)
        return pp_validate_report_self_test_json(known, out, err);
    if (format == PP_FORMAT_CSV)
        pp_validate_report_self_test_csv(known, out);
    else
        pp_validate_report_self_test(known, pp_terminal_width(path), out);
    return PP_OK;
}

static enum pp_exit answer(const struct pp_room_options *options, enum pp_format format)
{
    struct pp_self_test_cases known;
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, options->output, &err);
    if (status == PP_OK)
        status =
            pp_self_test_run(&known, options->study.seed, options->study.threads, &err);
    if (status == PP_OK)
        status = print_known(&known, format, options->output, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    for (int i = 0; i < known.count; i++)
        if (!pp_self_test_passes(&known.list[i])) {
            pp_message("not all answers are right; this build is not to be trusted");
            return PP_EXIT_MACHINE;
        }
    return PP_EXIT_DONE;
}

/* ---- rooms ---- */

/* Reports of all rooms, hand methods first, and how far they are from the simulation.
 */
static enum pp_status compute(struct pp_validation *validation,
                              struct pp_results *results, const struct pp_rooms *rooms,
                              struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        struct pp_result *result = &results->list[results->count++];
        result->file = rooms->list[i].file;
        status = pp_study_report_methods(&result->report, &rooms->list[i],
                                         results->options, err);
    }
    pp_interrupt_watch();
    for (int i = 0; i < results->count && status == PP_OK; i++) {
        struct pp_result *result = &results->list[i];
        status = pp_study_report_traced(&result->report, results->options,
                                        &result->by_clock, err);
        if (status == PP_OK)
            status = pp_comparison_of_report(
                &validation->rooms[i], &validation->counts[i], &result->report, err);
    }
    if (status == PP_OK)
        status = pp_comparison_overall(&validation->overall, &validation->overall_count,
                                       validation->rooms, validation->counts,
                                       results->count, err);
    return status;
}

static enum pp_status print(const struct pp_validation *validation,
                            enum pp_format format, const char *path, FILE *out,
                            struct pp_error *err)
{
    if (format == PP_FORMAT_JSON)
        return pp_validate_report_rooms_json(validation, out, err);
    if (format == PP_FORMAT_CSV)
        pp_validate_report_rooms_csv(validation, out);
    else
        pp_validate_report_rooms(validation, pp_terminal_width(path), out);
    return PP_OK;
}

static enum pp_exit compute_and_print(struct pp_validation *validation,
                                      struct pp_results *results,
                                      const struct pp_rooms *rooms,
                                      enum pp_format format, const char *path)
{
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, &err);
    if (status == PP_OK)
        status = compute(validation, results, rooms, &err);
    if (status == PP_OK)
        status = print(validation, format, path, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    for (int i = 0; i < results->count; i++)
        if (!results->list[i].report.finished)
            return pp_message_unfinished();
    return PP_EXIT_DONE;
}

static enum pp_exit compare(const struct pp_room_options *options,
                            enum pp_format format, char **files, int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "validate", files, file_count, options);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    size_t count = (size_t)rooms.count + 1;
    struct pp_results results = {.list = calloc(count, sizeof *results.list),
                                 .several = rooms.several,
                                 .more_than_one_file = rooms.more_than_one_file,
                                 .options = &options->study};
    struct pp_validation validation = {.results = &results,
                                       .rooms = calloc(count, sizeof *validation.rooms),
                                       .counts =
                                           calloc(count, sizeof *validation.counts)};
    if (results.list && validation.rooms && validation.counts) {
        exit_status =
            compute_and_print(&validation, &results, &rooms, format, options->output);
    } else {
        struct pp_error err;
        pp_fail_memory(&err);
        exit_status = pp_message_error(&err);
    }
    for (int i = 0; i < results.count; i++) {
        pp_report_clear(&results.list[i].report);
        free(validation.rooms[i]);
    }
    free(validation.rooms);
    free(validation.counts);
    free(validation.overall);
    free(results.list);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- another program ---- */

static enum pp_status read_program(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "radiance") != 0)
        return pp_fail(err, PP_BAD_INPUT, "radiance");
    *(const char **)place = text;
    return PP_OK;
}

struct validate_options {
    struct pp_room_options room;
    const char *against; /* the other program; NULL: none */
    enum pp_format format;
};

#define PLACE(member) offsetof(struct validate_options, member)

static const struct pp_option against_option[] = {
    {"against", 0, "PROGRAM",
     "Compare the simulation with another program's, of the same rooms: radiance, "
     "where "
     "its oconv and rtrace are on PATH.",
     read_program, PLACE(against)},
    {0},
};

static enum pp_exit compare_with_radiance(struct pp_room_options *options,
                                          enum pp_format format, char **files,
                                          int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "validate", files, file_count, options);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    options->study.methods = "exact";
    exit_status = pp_against_radiance(&rooms, options, format);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command line ---- */

static const struct pp_option_group groups[] = {
    PP_ROOM_CHOICE_GROUPS("What is compared", PLACE(room)),
    {"What is compared", against_option, 0},
    PP_ROOM_STOP_GROUPS(PLACE(room)),
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init(void *values)
{
    *(struct validate_options *)values =
        (struct validate_options){.room = pp_room_options_none};
}

static enum pp_status check(void *values, char **files, int file_count,
                            struct pp_error *err)
{
    struct validate_options *options = values;
    struct pp_study_options *study = &options->room.study;
    const char *of_rooms = study->methods            ? "--methods"
                           : study->points.count > 0 ? "--points"
                           : study->sky              ? "--sky"
                           : options->room.room      ? "--room"
                           : study->error > 0.0      ? "--error"
                           : study->samples > 0      ? "--samples"
                           : study->seconds > 0.0    ? "--time"
                                                     : NULL;
    (void)files;
    if (options->against && file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--against is about a room; expected a room "
                       "file, or - for standard input");
    if (options->against && study->methods)
        return pp_fail(err, PP_BAD_INPUT,
                       "--against compares the simulation alone; expected it without "
                       "--methods");
    if (file_count == 0 && of_rooms)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is about a room; expected a room file, or - for standard "
                       "input",
                       of_rooms);
    study->simulate = true;
    if (!study->methods)
        study->methods = "all";
    enum pp_status status = pp_room_options_settle(&options->room, err);
    return status == PP_OK ? pp_selection_check(study->methods, err) : status;
}

static enum pp_exit run(void *values, char **files, int file_count)
{
    struct validate_options *options = values;
    struct pp_terminal_watch watch;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    if (options->against)
        return compare_with_radiance(&options->room, options->format, files,
                                     file_count);
    return file_count == 0
               ? answer(&options->room, options->format)
               : compare(&options->room, options->format, files, file_count);
}

static void clear(void *values)
{
    struct validate_options *options = values;
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_validate = {
    .name = "validate",
    .summary = "methods against simulation, program against paper",
    .operands = "[FILE...]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct validate_options),
    .init = init,
    .check = check,
    .run = run,
    .clear = clear,
};
