/* cmd_validate.c - the command validate: formulae against simulation, and the
 * program against analytic answers. */
#include <stdlib.h>
#include <string.h>

#include "cli/terminal.h"
#include "cli/validate/against_radiance.h"
#include "cli/validate/run_suite.h"
#include "cli/command.h"
#include "cli/watch.h"
#include "cli/format_option.h"
#include "cli/df/formula_option.h"
#include "studies/study_report.h"
#include "studies/validation/own_world.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/job.h"
#include "reports/df_result.h"
#include "reports/validate/validate_report.h"
#include "cli/rooms.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "model/base/text.h"

static const char about[] =
    "Without FILE: the program's answers beside those that are known on paper (open "
    "skies, closed forms of windows, light in a closed room, worked examples). With "
    "the "
    "name of a suite in its place: analytic, published or cie171, each case with what "
    "was expected, the difference and its limit. With room files, or rooms FILE: each "
    "method against the simulation, at the reference points and for the average over "
    "the working plane: bias, spread and the worst point, and how much of it comes of "
    "what the method assumes of ground and surroundings, how much of its formula. With "
    "radiance FILE: the simulation against Radiance's. FILE is a room file; - is "
    "standard input.";

/* ---- rooms ---- */

struct comparison_run {
    const struct pp_room_options *options;
    enum pp_format format;
    const struct pp_rooms *rooms;
    struct pp_results results;
    struct pp_validation validation;
};

/* Traces a room and the worlds that its methods have in mind, and compares. What time
 * there is, each world gets a share of. */
static enum pp_status compare_room(struct comparison_run *run, int index,
                                   struct pp_error *err)
{
    struct pp_result *result = &run->results.list[index];
    struct pp_report *report = &result->report;
    struct pp_validation *validation = &run->validation;
    struct pp_study_options options = *run->results.options;
    struct pp_own_worlds *worlds;
    enum pp_status status =
        pp_own_world_list(&worlds, run->rooms->list[index].room, report, err);
    if (status != PP_OK)
        return status;
    options.seconds /= 1 + pp_own_world_count(worlds);
    status = pp_study_report_traced(report, &options, &result->by_clock, err);
    if (status == PP_OK)
        status = pp_own_world_trace(worlds, &options, &report->finished,
                                    &result->by_clock, err);
    if (status == PP_OK)
        status = pp_comparison_of_report(
            &validation->rooms[index], &validation->counts[index], report, worlds, err);
    pp_own_world_destroy(worlds);
    return status;
}

/* Reports of all rooms, hand methods first, and how far they are from the simulation. */
static enum pp_status compute(void *data, struct pp_error *err)
{
    struct comparison_run *run = data;
    struct pp_results *results = &run->results;
    struct pp_validation *validation = &run->validation;
    const struct pp_rooms *rooms = run->rooms;
    size_t count = (size_t)rooms->count + 1;
    enum pp_status status = PP_OK;
    results->list = calloc(count, sizeof *results->list);
    validation->rooms = calloc(count, sizeof *validation->rooms);
    validation->counts = calloc(count, sizeof *validation->counts);
    if (!results->list || !validation->rooms || !validation->counts)
        return pp_fail_memory(err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        struct pp_result *result = &results->list[results->count++];
        result->file = rooms->list[i].file;
        status = pp_study_report_methods(&result->report, &rooms->list[i],
                                         results->options, err);
    }
    pp_interrupt_watch();
    for (int i = 0; i < results->count && status == PP_OK; i++)
        status = compare_room(run, i, err);
    if (status == PP_OK)
        status = pp_comparison_overall(&validation->overall, &validation->overall_count,
                                       validation->rooms, validation->counts,
                                       results->count, err);
    return status;
}

static enum pp_status print(const void *data, FILE *out, struct pp_error *err)
{
    const struct comparison_run *run = data;
    if (run->format == PP_FORMAT_JSON)
        return pp_validate_report_rooms_json(&run->validation, out, err);
    if (run->format == PP_FORMAT_CSV)
        pp_validate_report_rooms_csv(&run->validation, out);
    else
        pp_validate_report_rooms(&run->validation,
                                 pp_terminal_width(run->options->output), out);
    return PP_OK;
}

static bool is_finished(const void *data)
{
    const struct comparison_run *run = data;
    for (int i = 0; i < run->results.count; i++)
        if (!run->results.list[i].report.finished)
            return false;
    return true;
}

static enum pp_exit compare(const struct pp_room_options *options,
                            enum pp_format format, char **files, int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "validate", files, file_count, options);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct comparison_run run = {
        .options = options,
        .format = format,
        .rooms = &rooms,
        .results = {.several = rooms.several,
                    .more_than_one_file = rooms.more_than_one_file,
                    .options = &options->study}};
    run.validation.results = &run.results;
    exit_status = pp_job_run(
        &(struct pp_job){options->output, compute, print, is_finished, &run});
    for (int i = 0; i < run.results.count; i++) {
        pp_report_clear(&run.results.list[i].report);
        free(run.validation.rooms[i]);
    }
    free(run.validation.rooms);
    free(run.validation.counts);
    free(run.validation.overall);
    free(run.results.list);
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
    struct pp_formula_words formulae;
    const char *against; /* the other program; NULL: none */
    enum pp_format format;
    const char *page;             /* for what a suite found; NULL: not wanted */
    const struct pp_suite *suite; /* NULL: of rooms */
    int words;                    /* operands before the files */
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

static const struct pp_option page_option[] = {
    {"page", 0, "FILE.html",
     "Write what a suite found as a page that needs nothing else, with histograms, "
     "too.",
     pp_options_read_output, PLACE(page)},
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
    {"What is compared", pp_formula_option, PLACE(formulae)},
    {"What is compared", against_option, 0},
    PP_ROOM_STOP_GROUPS(PLACE(room)),
    {"Output", pp_format_option, PLACE(format)},
    {"Output", page_option, 0},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init(void *values)
{
    *(struct validate_options *)values =
        (struct validate_options){.room = pp_room_options_none};
}

/* The option that is about a room; NULL: none is there. */
static const char *said_of_rooms(const struct validate_options *options)
{
    const struct pp_study_options *study = &options->room.study;
    return study->methods                ? "--methods"
           : options->formulae.count > 0 ? "--formula"
           : study->points.count > 0     ? "--points"
           : study->sky                  ? "--sky"
           : options->room.room          ? "--room"
           : study->error > 0.0          ? "--error"
           : study->samples > 0          ? "--samples"
           : study->seconds > 0.0        ? "--time"
           : options->against            ? "--against"
                                         : NULL;
}

/* What the first operand says, where it is no file. */
static void take_word(struct validate_options *options, char **operands, int count)
{
    options->suite = count == 0 ? &pp_suite_quick : pp_suite_find(operands[0]);
    if (count == 0 || options->suite)
        options->words = count > 0;
    else if (strcmp(operands[0], "rooms") == 0)
        options->words = 1;
    else if (strcmp(operands[0], "radiance") == 0) {
        options->words = 1;
        options->against = operands[0];
    }
}

static enum pp_status fail_page(struct pp_error *err)
{
    enum { MOST = 16 };
    const char *names[MOST];
    char text[200] = "";
    int count = 0;
    while (count < MOST && pp_suite_at(count)) {
        names[count] = pp_suite_at(count)->name;
        count++;
    }
    pp_text_append_list(text, sizeof text, names, count, " or ");
    return pp_fail(err, PP_BAD_INPUT, "--page is of a suite; expected %s", text);
}

static enum pp_status check_suite(const struct validate_options *options,
                                  int file_count, struct pp_error *err)
{
    const char *of_rooms = said_of_rooms(options);
    if (options->suite && file_count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the suite %s has its own rooms; expected no file behind it",
                       options->suite->name);
    if (options->suite && of_rooms)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is about a room; expected a room file, or - for standard "
                       "input",
                       of_rooms);
    if (!options->suite && file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected room files, or - for standard input");
    if (!options->suite && options->page)
        return fail_page(err);
    return PP_OK;
}

static enum pp_status check_against(const struct validate_options *options,
                                    struct pp_error *err)
{
    const char *excluded = options->room.study.methods   ? "--methods"
                           : options->formulae.count > 0 ? "--formula"
                                                         : NULL;
    if (!options->against || !excluded)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "--against compares the simulation alone; expected it without %s",
                   excluded);
}

static enum pp_status check(void *values, char **operands, int count,
                            struct pp_error *err)
{
    struct validate_options *options = values;
    struct pp_study_options *study = &options->room.study;
    take_word(options, operands, count);
    enum pp_status status = check_suite(options, count - options->words, err);
    if (status == PP_OK)
        status = check_against(options, err);
    if (status != PP_OK)
        return status;
    study->simulate = true;
    if (!study->methods)
        study->methods = "all";
    status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK)
        status = pp_selection_check(study->methods, err);
    return status == PP_OK ? pp_formula_option_settle(&options->formulae,
                                                      &study->method_options, err)
                           : status;
}

static enum pp_exit run(void *values, char **operands, int count)
{
    struct validate_options *options = values;
    struct pp_terminal_watch watch;
    char **files = operands + options->words;
    int file_count = count - options->words;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    if (options->suite)
        return pp_run_suite(options->suite, &options->room, options->format,
                            options->page);
    return options->against
               ? compare_with_radiance(&options->room, options->format, files,
                                       file_count)
               : compare(&options->room, options->format, files, file_count);
}

static void clear(void *values)
{
    struct validate_options *options = values;
    pp_room_options_clear(&options->room);
    pp_formula_option_clear(&options->formulae);
}

const struct pp_command pp_command_validate = {
    .name = "validate",
    .summary = "methods against simulation, program against paper",
    .operands = "[SUITE] [FILE...]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct validate_options),
    .init = init,
    .check = check,
    .run = run,
    .clear = clear,
};
