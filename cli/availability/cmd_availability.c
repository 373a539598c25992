/* availability - in how many of the working hours daylight gives an illuminance. */
#include <stdlib.h>
#include <string.h>

#include "cli/availability/availability_options.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/print/format.h"
#include "cli/study_report.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/print/print.h"
#include "cli/availability/availability_text.h"
#include "methods/evaluate.h"
#include "methods/selection.h"

static const char about[] =
    "In how many of the working hours daylight alone gives an illuminance, at the "
    "reference points of each room, at the median of them, and on average: what the "
    "sky "
    "has to give outside is that illuminance over the daylight factor, and how often "
    "it "
    "does is taken from a weather file, or from overcast skies at the latitude. FILE "
    "is a "
    "room file; - is standard input.";

/* What a run holds. `outside` is the rooms' light, one each. */
struct run {
    struct pp_availability_options *options;
    const struct pp_room_options *room_options;
    enum pp_format format;
    struct pp_availability_results results;
    struct pp_environment_light *outside;
};

static enum pp_status compute_room(struct run *run, const struct pp_loaded_room *room,
                                   int index, struct pp_error *err)
{
    struct pp_availability_result *result = &run->results.list[index];
    struct pp_environment_light *outside = &run->outside[index];
    result->file = room->file;
    enum pp_status status =
        pp_availability_options_light(outside, run->options, room->world, err);
    if (status == PP_OK)
        status = pp_study_report_methods(&result->report, room, run->room_options, err);
    if (status == PP_OK && run->room_options->simulate)
        status = pp_study_report_traced(&result->report, run->room_options,
                                        &result->by_clock, err);
    if (status != PP_OK)
        return status;
    struct pp_availability_question question =
        pp_availability_options_question(run->options, outside);
    return pp_availability_fill(&result->sheet, &question, &result->report, err);
}

static enum pp_status print(const struct run *run, FILE *out, struct pp_error *err)
{
    switch (run->format) {
    case PP_FORMAT_JSON:
        return pp_availability_json(&run->results, out, err);
    case PP_FORMAT_CSV:
        return pp_availability_text_csv(&run->results, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_availability_text(&run->results,
                                pp_print_width(run->room_options->output),
                                pp_format_utf8_terminal(), out, err);
}

static enum pp_exit compute_and_print(struct run *run, const struct pp_rooms *rooms)
{
    struct pp_error err = {0};
    struct pp_output output;
    if (run->room_options->simulate)
        pp_interrupt_watch();
    enum pp_status status = pp_output_open(&output, run->room_options->output, &err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        run->results.count = i + 1;
        status = compute_room(run, &rooms->list[i], i, &err);
    }
    if (status == PP_OK)
        status = print(run, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    for (int i = 0; i < run->results.count; i++)
        if (!run->results.list[i].report.finished)
            return pp_message_unfinished();
    return PP_EXIT_DONE;
}

static enum pp_exit run_on(struct run *run, const struct pp_rooms *rooms)
{
    struct pp_error err;
    enum pp_exit result;
    run->results.several = rooms->several;
    run->results.more_than_one_file = rooms->more_than_one_file;
    run->results.options = run->room_options;
    run->results.list = calloc((size_t)rooms->count, sizeof *run->results.list);
    run->outside = calloc((size_t)rooms->count, sizeof *run->outside);
    if (run->results.list && run->outside) {
        result = compute_and_print(run, rooms);
    } else {
        pp_fail_memory(&err);
        result = pp_message_error(&err);
    }
    for (int i = 0; i < run->results.count; i++) {
        pp_availability_sheet_clear(&run->results.list[i].sheet);
        pp_report_clear(&run->results.list[i].report);
        pp_availability_options_light_clear(&run->outside[i]);
    }
    free(run->results.list);
    free(run->outside);
    return result;
}

/* What the options say, before any file is opened. */
static enum pp_status check(struct pp_availability_options *options,
                            struct pp_room_options *room_options, char **files,
                            int file_count, struct pp_error *err)
{
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    enum pp_status status = pp_room_options_settle(room_options, err);
    if (status == PP_OK)
        status = pp_availability_options_check(options, files, file_count, err);
    if (!room_options->methods)
        room_options->methods = "exact+bre";
    return status == PP_OK ? pp_selection_check(room_options->methods, err) : status;
}

static enum pp_exit load_and_run(struct run *run, char **files, int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit result = pp_availability_options_load(run->options);
    if (result != PP_EXIT_DONE)
        return result;
    result =
        pp_rooms_load(&rooms, "availability", files, file_count, run->room_options);
    if (result != PP_EXIT_DONE)
        return result;
    result = run_on(run, &rooms);
    pp_rooms_clear(&rooms);
    return result;
}

enum pp_exit cmd_availability(int argc, char **argv)
{
    struct pp_room_options room_options = pp_room_options_none;
    struct pp_availability_options options = pp_availability_options_default;
    struct run run = {
        .options = &options, .room_options = &room_options, .format = PP_FORMAT_TEXT};
    const struct pp_option_group groups[] = {
        {"Light outside and working hours", pp_light_options, &options},
        {"What is computed", pp_illuminance_options, &options},
        {"What is computed", pp_room_choice_options, &room_options},
        {"Simulation", pp_room_simulation_options, &room_options},
        {"Output", pp_format_option, &run.format},
        {"Output", pp_room_output_options, &room_options},
        {0},
    };
    const struct pp_command_line line = {"availability", "FILE...", about, groups,
                                         NULL};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help)
        status = check(&options, &room_options, argv, file_count, &err);

    if (pp_command_line_starts(&line, argv, file_count, status, wants_help, &err,
                               &exit_status))
        exit_status = load_and_run(&run, argv, file_count);
    pp_availability_options_clear(&options);
    pp_room_options_clear(&room_options);
    return exit_status;
}
