/* cmd_availability.c - the command availability: fraction of the working hours in which
 * daylight reaches given illuminances. */
#include <stdlib.h>
#include <string.h>

#include "cli/terminal.h"
#include "cli/availability/availability_options.h"
#include "cli/command.h"
#include "cli/rooms.h"
#include "cli/watch.h"
#include "cli/format_option.h"
#include "studies/study_report.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/job.h"
#include "reports/availability_json.h"
#include "reports/availability_csv.h"
#include "reports/availability_text.h"
#include "methods/evaluate.h"
#include "methods/selection.h"

static const char about[] =
    "Shows the share of working hours in which daylight alone reaches a target "
    "illuminance: at the reference points of each room, for their median, and for "
    "the average. The external illuminance required is the target divided by the "
    "daylight factor. A weather file, or an overcast sky at the latitude, "
    "determines how often it is reached. FILE is a room file; - is standard input.";

struct availability_options {
    struct pp_room_options room;
    struct pp_year_options light;
    enum pp_format format;
};

/* State of a run. outside: daylight outside each room. */
struct availability_run {
    struct availability_options *options;
    const struct pp_rooms *rooms;
    struct pp_availability_results results;
    struct pp_year_light *outside;
};

static enum pp_status compute_room(struct availability_run *run,
                                   const struct pp_study_room *room, int index,
                                   struct pp_error *err)
{
    struct pp_availability_result *result = &run->results.list[index];
    struct pp_year_light *outside = &run->outside[index];
    result->file = room->file;
    enum pp_status status =
        pp_year_light_of_room(outside, &run->options->light, room->world, err);
    if (status == PP_OK)
        status =
            pp_study_report_methods(&result->report, room, run->results.options, err);
    if (status == PP_OK && run->results.options->simulate)
        status = pp_study_report_traced(&result->report, run->results.options,
                                        &result->by_clock, err);
    if (status != PP_OK)
        return status;
    struct pp_availability_question question =
        pp_year_light_question(&run->options->light, outside);
    return pp_availability_fill(&result->sheet, &question, &result->report, err);
}

static enum pp_status compute_availability(void *data, struct pp_error *err)
{
    struct availability_run *run = data;
    const struct pp_rooms *rooms = run->rooms;
    enum pp_status status = PP_OK;
    run->results.list = calloc((size_t)rooms->count, sizeof *run->results.list);
    run->outside = calloc((size_t)rooms->count, sizeof *run->outside);
    if (!run->results.list || !run->outside)
        return pp_fail_memory(err);
    if (run->results.options->simulate)
        pp_interrupt_watch();
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        run->results.count = i + 1;
        status = compute_room(run, &rooms->list[i], i, err);
    }
    return status;
}

static enum pp_status print_availability(const void *data, FILE *out,
                                         struct pp_error *err)
{
    const struct availability_run *run = data;
    switch (run->options->format) {
    case PP_FORMAT_JSON:
        return pp_availability_json(&run->results, out, err);
    case PP_FORMAT_CSV:
        return pp_availability_csv(&run->results, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_availability_text(&run->results,
                                pp_terminal_width(run->options->room.output),
                                pp_terminal_utf8(), out, err);
}

static bool availability_is_finished(const void *data)
{
    const struct availability_run *run = data;
    for (int i = 0; i < run->results.count; i++)
        if (!run->results.list[i].report.finished)
            return false;
    return true;
}

static enum pp_exit run_availability_of_rooms(struct availability_options *options,
                                              const struct pp_rooms *rooms)
{
    struct availability_run run = {
        .options = options,
        .rooms = rooms,
        .results = {.several = rooms->several,
                    .more_than_one_file = rooms->more_than_one_file,
                    .options = &options->room.study}};
    enum pp_exit exit_status = pp_job_run(
        &(struct pp_job){options->room.output, compute_availability, print_availability,
                         availability_is_finished, &run});
    for (int i = 0; i < run.results.count; i++) {
        pp_availability_sheet_clear(&run.results.list[i].sheet);
        pp_report_clear(&run.results.list[i].report);
        pp_year_light_clear(&run.outside[i]);
    }
    free(run.results.list);
    free(run.outside);
    return exit_status;
}

static enum pp_exit run_availability(void *values, char **files, int file_count)
{
    struct availability_options *options = values;
    struct pp_terminal_watch watch;
    struct pp_rooms rooms;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    enum pp_exit result =
        pp_availability_options_load(&options->light, options->room.study.strict);
    if (result == PP_EXIT_DONE)
        result =
            pp_rooms_load(&rooms, "availability", files, file_count, &options->room);
    if (result != PP_EXIT_DONE)
        return result;
    result = run_availability_of_rooms(options, &rooms);
    pp_rooms_clear(&rooms);
    return result;
}

/* ---- the command line ---- */

#define PLACE(member) offsetof(struct availability_options, member)

static const struct pp_option_group groups[] = {
    {"External light and working hours", pp_light_options, PLACE(light)},
    {"External light and working hours", pp_working_time_options, PLACE(light)},
    {"Calculation", pp_illuminance_options, PLACE(light)},
    PP_ROOM_CHOICE_GROUPS("Calculation", PLACE(room)),
    PP_ROOM_SIMULATION_GROUPS(PLACE(room)),
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_availability_options(void *values)
{
    *(struct availability_options *)values = (struct availability_options){
        .room = pp_room_options_none, .light = pp_year_options_default};
}

static enum pp_status check_availability_options(void *values, char **files,
                                                 int file_count, struct pp_error *err)
{
    struct availability_options *options = values;
    (void)files;
    struct pp_study_options *study = &options->room.study;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    enum pp_status status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK)
        status = pp_availability_options_check(&options->light, err);
    if (!study->methods)
        study->methods = "exact+bre";
    return status == PP_OK ? pp_selection_check(study->methods, err) : status;
}

static void clear_availability_options(void *values)
{
    struct availability_options *options = values;
    pp_availability_options_clear(&options->light);
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_availability = {
    .name = "availability",
    .summary = "share of working hours with enough daylight",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct availability_options),
    .init = init_availability_options,
    .check = check_availability_options,
    .run = run_availability,
    .clear = clear_availability_options,
};
