/* validate - formulae against simulation, and the program against analytic answers. */
#include <stdlib.h>
#include <string.h>

#include "cli/validate/against_radiance.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/print/format.h"
#include "cli/study_report.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/validate/print_validate.h"
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
        return pp_print_validate_self_test_json(known, out, err);
    if (format == PP_FORMAT_CSV)
        pp_print_validate_self_test_csv(known, out);
    else
        pp_print_validate_self_test(known, pp_print_width(path), out);
    return PP_OK;
}

static enum pp_exit answer(const struct pp_room_options *options, enum pp_format format)
{
    struct pp_self_test_cases known;
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, options->output, &err);
    if (status == PP_OK)
        status = pp_self_test_run(&known, options->seed, options->threads, &err);
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
                            enum pp_format format, FILE *out, struct pp_error *err)
{
    if (format == PP_FORMAT_JSON)
        return pp_print_validate_rooms_json(validation, out, err);
    if (format == PP_FORMAT_CSV)
        pp_print_validate_rooms_csv(validation, out);
    else
        pp_print_validate_rooms(
            validation, pp_print_width(validation->results->options->output), out);
    return PP_OK;
}

static enum pp_exit compute_and_print(struct pp_validation *validation,
                                      struct pp_results *results,
                                      const struct pp_rooms *rooms,
                                      enum pp_format format)
{
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, results->options->output, &err);
    if (status == PP_OK)
        status = compute(validation, results, rooms, &err);
    if (status == PP_OK)
        status = print(validation, format, output.stream, &err);
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
                                 .options = options};
    struct pp_validation validation = {.results = &results,
                                       .rooms = calloc(count, sizeof *validation.rooms),
                                       .counts =
                                           calloc(count, sizeof *validation.counts)};
    if (results.list && validation.rooms && validation.counts) {
        exit_status = compute_and_print(&validation, &results, &rooms, format);
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

static const struct pp_option against_option[] = {
    {"against", 0, "PROGRAM",
     "Compare the simulation with another program's, of the same rooms: radiance, "
     "where "
     "its oconv and rtrace are on PATH.",
     read_program, 0},
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
    options->methods = "exact";
    exit_status = pp_against_radiance(&rooms, options, format);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command ---- */

/* What the options say, before any file is opened. */
static enum pp_status check(struct pp_room_options *options, int file_count,
                            struct pp_error *err)
{
    const char *of_rooms = options->methods            ? "--methods"
                           : options->points.count > 0 ? "--points"
                           : options->sky              ? "--sky"
                           : options->room             ? "--room"
                           : options->error > 0.0      ? "--error"
                           : options->samples > 0      ? "--samples"
                           : options->seconds > 0.0    ? "--time"
                                                       : NULL;
    if (file_count == 0 && of_rooms)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is about a room; expected a room file, or - for standard "
                       "input",
                       of_rooms);
    options->simulate = true;
    if (!options->methods)
        options->methods = "all";
    enum pp_status status = pp_room_options_settle(options, err);
    return status == PP_OK ? pp_selection_check(options->methods, err) : status;
}

enum pp_exit cmd_validate(int argc, char **argv)
{
    struct pp_room_options options = pp_room_options_none;
    enum pp_format format = PP_FORMAT_TEXT;
    const char *against = NULL;
    const struct pp_option_group groups[] = {
        {"What is compared", pp_room_choice_options, &options},
        {"What is compared", against_option, &against},
        {"Simulation", pp_room_simulation_options + 1, &options},
        {"Output", pp_format_option, &format},
        {"Output", pp_room_output_options, &options},
        {0},
    };
    const struct pp_command_line line = {"validate", "[FILE...]", about, groups, NULL};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help && against && file_count == 0)
        status = pp_fail(&err, PP_BAD_INPUT,
                         "--against is about a room; expected a room "
                         "file, or - for standard input");
    if (status == PP_OK && !wants_help && against && options.methods)
        status = pp_fail(&err, PP_BAD_INPUT,
                         "--against compares the simulation alone; expected it without "
                         "--methods");
    if (status == PP_OK && !wants_help)
        status = check(&options, file_count, &err);

    if (pp_command_line_starts(&line, argv, file_count, status, wants_help, &err,
                               &exit_status)) {
        if (against)
            exit_status = compare_with_radiance(&options, format, argv, file_count);
        else if (file_count == 0)
            exit_status = answer(&options, format);
        else
            exit_status = compare(&options, format, argv, file_count);
    }
    pp_room_options_clear(&options);
    return exit_status;
}
