/* cmd_validate.c - the command validate: compares formulae with simulation, and results
 * of the program with known results. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/ranks/room_queue.h"
#include "cli/terminal.h"
#include "cli/validate/against_radiance.h"
#include "cli/validate/run_suite.h"
#include "cli/command.h"
#include "cli/watch.h"
#include "cli/format_option.h"
#include "cli/df/formula_option.h"
#include "cli/validate/validate_rooms.h"
#include "cli/rooms.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "model/base/text.h"
#include "reports/df_result.h"
#include "reports/parts/format.h"
#include "simulate/cache/irradiance_cache.h"
#include "studies/research/validation/room_cases.h"
#include "studies/study_report.h"

static const char about[] =
    "Without FILE: compares the program with known answers (open skies, closed-form "
    "solutions for windows, light in a closed room, worked examples). With the name of "
    "a suite (analytic, published or cie171): lists each case with its expected value, "
    "difference, limit and verdict. rooms FILE compares each method with the "
    "simulation; the bands of the atlas are the limits. engines FILE compares the "
    "simulation engines. radiance FILE compares the simulation with Radiance. Room "
    "files without a suite: compares each method with the simulation at the reference "
    "points and for the average. It shows bias, spread and the worst point, and the "
    "parts of the difference caused by the method's assumptions and by its formula. "
    "FILE is a room file; - is standard input.";

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
    const char *against; /* name of the other program; NULL: none */
    enum pp_format format;
    const char *page;             /* file for the page of a suite's results; NULL:
                                   * none */
    const struct pp_suite *suite; /* NULL: compare the rooms of files */
    int words;                    /* number of operands before the files */
};

#define PLACE(member) offsetof(struct validate_options, member)

static const struct pp_option against_option[] = {
    {"against", 0, "PROGRAM",
     "Compare the simulation of the same rooms with another program: radiance, if "
     "oconv and rtrace are on PATH.",
     read_program, PLACE(against)},
    {0},
};

static const struct pp_option page_option[] = {
    {"page", 0, "FILE.html",
     "Also write the results of a suite as a self-contained HTML page with histograms.",
     pp_options_read_output, PLACE(page)},
    {0},
};

/* ---- the suite "engines": one report per room, to which each engine adds columns
 * ---- */

struct engines_run {
    const struct pp_room_options *options;
    const struct pp_rooms *rooms;
    struct pp_result *results; /* one for each room */
    int count;
};

static struct pp_room_figures engine_room_figures(void *data, int index)
{
    struct pp_result *result = &((struct engines_run *)data)->results[index];
    return (struct pp_room_figures){&result->report, &result->by_clock};
}

/* Runs all engines in one room, with equal parts of the room's time limit. */
static enum pp_status simulate_by_engines(const void *data, int index,
                                          struct pp_report *report, bool *by_clock,
                                          struct pp_error *err)
{
    const struct engines_run *run = data;
    const struct pp_engine_options cached = {.cache = pp_irradiance_cache_defaults()};
    struct pp_study_options study = run->options->study;
    enum pp_status status = PP_OK;
    int engines = 0;
    (void)index;
    while (pp_engine_at(engines))
        engines++;
    study.seconds /= engines;
    for (int i = 0; i < engines && status == PP_OK; i++) {
        if (pp_interrupt_came())
            report->finished = false;
        else
            status = pp_study_report_simulate(report, pp_engine_at(i), cached, &study,
                                              by_clock, NULL, err);
    }
    return status;
}

static enum pp_status find_engine_cases(void *data, struct pp_known_cases *cases,
                                        struct pp_error *err)
{
    struct engines_run *run = data;
    enum pp_status status = PP_OK;
    run->results = calloc((size_t)run->rooms->count + 1, sizeof *run->results);
    if (!run->results)
        return pp_fail_memory(err);
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++) {
        struct pp_result *result = &run->results[run->count++];
        result->file = run->rooms->list[i].file;
        status = pp_study_report_methods(&result->report, &run->rooms->list[i],
                                         &run->options->study, err);
    }
    pp_interrupt_watch();
    if (status == PP_OK)
        status = pp_room_queue_run(
            &(struct pp_room_queue){run->count, run->options->ranks,
                                    engine_room_figures, simulate_by_engines, run},
            err);
    for (int i = 0; i < run->count && status == PP_OK; i++)
        pp_room_cases_of_engines(cases, run->results[i].file, &run->results[i].report);
    return status;
}

static bool engines_are_finished(const void *data)
{
    const struct engines_run *run = data;
    for (int i = 0; i < run->count; i++)
        if (!run->results[i].report.finished)
            return false;
    return true;
}

/* Runs every engine in every room, over ranks if there are any, and compares the
 * results. page: file for the page of results; NULL: none. PP_EXIT_INPUT if more
 * results than permitted are outside their limits. */
static enum pp_exit validate_engines(const struct pp_rooms *rooms,
                                     const struct pp_room_options *options,
                                     enum pp_format format, const char *page)
{
    struct engines_run run = {.options = options, .rooms = rooms};
    enum pp_exit exit_status =
        pp_run_suite(&(struct pp_suite_source){&pp_suite_engines, find_engine_cases,
                                               engines_are_finished, &run},
                     options, format, page);
    for (int i = 0; i < run.count; i++)
        pp_report_clear(&run.results[i].report);
    free(run.results);
    return exit_status;
}

/* ---- rooms ---- */

/* Loads the rooms and runs the selected comparison. */
static enum pp_exit compare_loaded_rooms(struct validate_options *options, char **files,
                                         int file_count)
{
    struct pp_rooms rooms;
    struct pp_room_options *of_rooms = &options->room;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "validate", files, file_count, of_rooms);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    if (options->against || options->suite == &pp_suite_engines)
        of_rooms->study.methods = "exact";
    if (options->against && options->suite)
        exit_status =
            pp_against_radiance_suite(&rooms, of_rooms, options->format, options->page);
    else if (options->suite == &pp_suite_engines)
        exit_status =
            validate_engines(&rooms, of_rooms, options->format, options->page);
    else if (options->against)
        exit_status = pp_against_radiance(&rooms, of_rooms, options->format);
    else if (options->suite)
        exit_status =
            pp_validate_rooms_suite(&rooms, of_rooms, options->format, options->page);
    else
        exit_status = pp_validate_rooms(&rooms, of_rooms, options->format);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command line ---- */

static const struct pp_option_group groups[] = {
    PP_ROOM_CHOICE_GROUPS("Comparison", PLACE(room)),
    {"Comparison", pp_formula_option, PLACE(formulae)},
    {"Comparison", against_option, 0},
    PP_ROOM_STOP_GROUPS(PLACE(room)),
    {"Output", pp_format_option, PLACE(format)},
    {"Output", page_option, 0},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_validate_options(void *values)
{
    *(struct validate_options *)values =
        (struct validate_options){.room = pp_room_options_none};
}

/* First option given that applies only to rooms; NULL: none. */
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

/* Reads the first operand if it is a word and not a file. */
static void take_word(struct validate_options *options, char **operands, int count)
{
    options->suite = count == 0 ? &pp_suite_quick : pp_suite_find(operands[0]);
    options->words = count > 0 && options->suite;
    if (options->suite == &pp_suite_radiance)
        options->against = operands[0];
}

enum { SUITES_MOST = 16 };

static int list_suites(const char *names[SUITES_MOST])
{
    int count = 0;
    while (count < SUITES_MOST && pp_suite_at(count)) {
        names[count] = pp_suite_at(count)->name;
        count++;
    }
    return count;
}

/* Checks a word that is not a file: PP_BAD_INPUT if it resembles the name of a
 * suite. */
static enum pp_status check_word(const char *word, struct pp_error *err)
{
    const char *names[SUITES_MOST];
    int count = list_suites(names);
    if (access(word, F_OK) == 0 || !pp_text_nearest(word, names, count))
        return PP_OK;
    return pp_text_unknown(err, word, names, count, NULL,
                           "%s is neither a suite nor a file", word);
}

static enum pp_status fail_page(struct pp_error *err)
{
    const char *names[SUITES_MOST];
    char text[200] = "";
    pp_text_append_list(text, sizeof text, names, list_suites(names), " or ");
    return pp_fail(err, PP_BAD_INPUT, "--page is for a suite; expected %s", text);
}

static enum pp_status check_suite(const struct validate_options *options,
                                  int file_count, struct pp_error *err)
{
    const char *of_rooms = said_of_rooms(options);
    bool own_rooms = options->suite && !options->suite->of_rooms;
    if (own_rooms && file_count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the suite %s has its own rooms; expected no file after it",
                       options->suite->name);
    if (own_rooms && of_rooms)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for rooms; expected a room file, or - for standard input",
                       of_rooms);
    if (!own_rooms && file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected room files, or - for standard input, after %s",
                       options->suite->name);
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
    bool alone = options->against || options->suite == &pp_suite_engines;
    if (!alone || !excluded)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT, "%s only simulations; expected no %s",
                   options->against ? "--against compares" : "engines compares",
                   excluded);
}

static enum pp_status check_validate_options(void *values, char **operands, int count,
                                             struct pp_error *err)
{
    struct validate_options *options = values;
    struct pp_study_options *study = &options->room.study;
    take_word(options, operands, count);
    enum pp_status status = options->suite ? PP_OK : check_word(operands[0], err);
    if (status == PP_OK)
        status = check_suite(options, count - options->words, err);
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

static enum pp_exit run_validate(void *values, char **operands, int count)
{
    struct validate_options *options = values;
    struct pp_terminal_watch watch;
    char **files = operands + options->words;
    int file_count = count - options->words;
    bool uses_ranks = !options->suite || options->suite->of_rooms;
    if (options->room.ranks && options->room.ranks->rank > 0 && !uses_ranks)
        return PP_EXIT_DONE;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    return options->suite && !options->suite->of_rooms
               ? pp_run_suite_known(options->suite, &options->room, options->format,
                                    options->page)
               : compare_loaded_rooms(options, files, file_count);
}

static void clear_validate_options(void *values)
{
    struct validate_options *options = values;
    pp_room_options_clear(&options->room);
    pp_formula_option_clear(&options->formulae);
}

const struct pp_command pp_command_validate = {
    .name = "validate",
    .summary = "compare methods, simulation and known answers",
    .operands = "[SUITE] [FILE...]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct validate_options),
    .init = init_validate_options,
    .check = check_validate_options,
    .run = run_validate,
    .clear = clear_validate_options,
    .uses_ranks = true,
    .ranks_place = PLACE(room.ranks),
};
