/* cmd_df.c - the command df: daylight factors at the reference points, and their
 * average. */
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/df/df_run.h"
#include "cli/format_option.h"
#include "cli/df/moment_run.h"
#include "cli/message.h"
#include "cli/job.h"
#include "cli/sweep/sweep_options.h"
#include "cli/watch.h"
#include "reports/formula_list.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "methods/method.h"

#define PLACE(member) offsetof(struct pp_df_options, member)

static const struct pp_option explain_option[] = {
    {"explain", 'e', NULL,
     "Show the calculation of each figure step by step, for one point, in text or "
     "JSON.",
     NULL, PLACE(room.study.explain)},
    {0},
};

static const struct pp_option advise_option[] = {
    {"advise", 0, NULL,
     "Recommend a method for this room, for the average and for each group of "
     "points, with reasons, in text or JSON. The recommendation is based on the "
     "bands of all methods in similar rooms.",
     NULL, PLACE(advise)},
    {0},
};

static const struct pp_option list_option[] = {
    {"list-formulas", 0, NULL,
     "Print the formulae of all methods, with sources and symbols, and stop.", NULL,
     PLACE(list_formulae)},
    {0},
};

static const struct pp_option margin_option[] = {
    {"margin", 0, NULL,
     "Also show the average over the part of the working plane that is 0.5 m or more "
     "from the walls.",
     NULL, PLACE(margin)},
    {0},
};

static const struct pp_option bands_option[] = {
    {"bands", 0, NULL,
     "Show the bands of all methods in the text table, instead of only those of the "
     "first method, and add the bands to CSV.",
     NULL, PLACE(bands)},
    {"no-bands", 0, NULL,
     "Leave out the 95 % bands. In similar simulated rooms, 95 of 100 true values were "
     "inside their bands.",
     NULL, PLACE(no_bands)},
    {0},
};

static const struct pp_option array_option[] = {
    {"array", 0, NULL, "JSON: print an array of rooms, even for one room.", NULL,
     PLACE(array)},
    {0},
};

static const char about[] =
    "Calculates daylight factors in per cent by hand methods: at the reference points "
    "of each room, and on average over the working plane. --simulate also simulates "
    "them. FILE is a room file; - is standard input.";

static void help_on_methods(FILE *out)
{
    fputs("\nMethods:\n", out);
    const struct pp_method *method;
    for (int i = 0; (method = pp_method_at(i)) != NULL; i++)
        pp_options_help_word(method->name, method->summary, out);
    pp_options_help_word(
        "A+B", "direct component by A, internally reflected component by B", out);
    pp_options_help_word("default",
                         "exact+bre, brs-table+bre and average-df; if bre does not "
                         "apply, exact+split-flux",
                         out);
    pp_options_help_word("all",
                         "every method for the direct component with bre, exact with "
                         "every method for the internally reflected component, and "
                         "every method for the whole daylight factor",
                         out);
}

/* Checks that explanations are for one point of each room, and that a cache file is for
 * one room. */
static enum pp_exit check_rooms(const struct pp_df_options *options,
                                const struct pp_rooms *rooms)
{
    struct pp_error err = {0};
    for (int i = 0; options->room.study.explain && i < rooms->count; i++)
        if (rooms->list[i].receiver_count != 1 && err.status == PP_OK)
            pp_fail(&err, PP_BAD_INPUT,
                    "--explain shows the calculation for one point only, but there "
                    "are %d; expected one point, such as --points X,Y",
                    rooms->list[i].receiver_count);
    if (err.status == PP_OK && options->engine.cache.file && rooms->count > 1)
        pp_fail(&err, PP_BAD_INPUT,
                "--cache stores the records of one room only, but there are %d; "
                "expected --room NAME",
                rooms->count);
    return err.status == PP_OK ? PP_EXIT_DONE : pp_message_usage("df", &err);
}

static enum pp_exit run_df_of_rooms(struct pp_df_options *options,
                                    const struct pp_rooms *rooms)
{
    struct pp_terminal_watch watch;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    struct pp_df_run run = pp_df_run_of(options, rooms);
    enum pp_exit exit_status =
        pp_job_run(&(struct pp_job){options->room.output, pp_df_run_compute,
                                    pp_df_run_print, pp_df_run_is_finished, &run});
    pp_df_run_clear(&run);
    return exit_status;
}

/* ---- the formulae ---- */

static enum pp_status compute_nothing(void *data, struct pp_error *err)
{
    (void)data, (void)err;
    return PP_OK;
}

static enum pp_status print_formulae(const void *data, FILE *out, struct pp_error *err)
{
    (void)data, (void)err;
    pp_formula_list(out);
    return PP_OK;
}

/* Lists the formulae, or runs the command, with the user's own tables for the lumen
 * method if they are given. */
static enum pp_exit run_df(void *values, char **files, int file_count)
{
    struct pp_df_options *options = values;
    struct pp_lumen_table *table;
    struct pp_rooms rooms;
    if (options->list_formulae)
        return pp_job_run(&(struct pp_job){options->room.output, compute_nothing,
                                           print_formulae, NULL, NULL});
    enum pp_exit exit_status = pp_lumen_option_load(&table, &options->lumen_files);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    options->room.study.method_options.lumen_table = table;
    if (options->room.sweep.axis_count > 0) {
        exit_status = pp_df_run_sweep(options, files, file_count);
        pp_lumen_table_destroy(table);
        return exit_status;
    }
    exit_status = pp_rooms_load(&rooms, "df", files, file_count, &options->room);
    if (exit_status == PP_EXIT_DONE) {
        bool moment = pp_moment_choice_said(&options->moment);
        if (moment)
            exit_status = pp_moment_run(&options->moment, &options->room,
                                        options->format, options->array, &rooms);
        else
            exit_status = check_rooms(options, &rooms);
        if (exit_status == PP_EXIT_DONE && !moment)
            exit_status = run_df_of_rooms(options, &rooms);
        pp_rooms_clear(&rooms);
    }
    pp_lumen_table_destroy(table);
    return exit_status;
}

/* ---- the command line ---- */

static enum pp_status check_df_options(void *values, char **files, int file_count,
                                       struct pp_error *err)
{
    struct pp_df_options *options = values;
    struct pp_study_options *study = &options->room.study;
    (void)files;
    if (options->list_formulae && file_count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--list-formulas needs no room; expected no file");
    if (options->list_formulae)
        return PP_OK;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (study->explain && options->format == PP_FORMAT_CSV)
        return pp_fail(err, PP_BAD_INPUT,
                       "--explain cannot write CSV; expected --format text or json");
    if (options->advise && options->format == PP_FORMAT_CSV)
        return pp_fail(err, PP_BAD_INPUT,
                       "--advise cannot write CSV; expected --format text or json");
    if (options->array && options->format != PP_FORMAT_JSON)
        return pp_fail(err, PP_BAD_INPUT,
                       "--array is for JSON; expected --format json as well");
    const char *alone = study->explain                            ? "explain"
                        : options->advise                         ? "advise"
                        : pp_moment_choice_said(&options->moment) ? "when"
                        : options->engine.cache.file              ? "cache"
                                                                  : NULL;
    if (options->room.sweep.axis_count > 0 && alone)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--%s is for a single run, but --sweep makes many; expected --set", alone);
    enum pp_status status =
        pp_moment_choice_settle(&options->moment, &options->room, err);
    if (status == PP_OK && pp_moment_choice_said(&options->moment)) {
        study->simulate = true;
        status = pp_moment_choice_check_paths(&options->room, err);
    }
    if (status == PP_OK)
        status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK && study->methods)
        status = pp_selection_check(study->methods, err);
    if (status == PP_OK)
        status =
            pp_formula_option_settle(&options->formulae, &study->method_options, err);
    return status == PP_OK
               ? pp_engine_choice_settle(&options->engine, study->simulate, err)
               : status;
}

static void init_df_options(void *values)
{
    *(struct pp_df_options *)values = (struct pp_df_options){
        .room = pp_room_options_none, .engine = {.cache = pp_cache_choice_default()}};
}

static void clear_df_options(void *values)
{
    struct pp_df_options *options = values;
    pp_room_options_clear(&options->room);
    pp_formula_option_clear(&options->formulae);
    pp_cache_choice_clear(&options->engine.cache);
}

static const struct pp_option_group groups[] = {
    PP_ROOM_CHOICE_GROUPS("Calculation", PLACE(room)),
    {"Calculation", pp_sweep_options, PLACE(room.sweep)},
    {"Calculation", pp_lumen_option, PLACE(lumen_files)},
    {"Calculation", explain_option, 0},
    {"Calculation", advise_option, 0},
    {"Calculation", pp_formula_option, PLACE(formulae)},
    {"Calculation", list_option, 0},
    {"Calculation", pp_room_external_option, PLACE(room)},
    {"Calculation", pp_moment_when_option, PLACE(moment)},
    {"Calculation", pp_moment_weather_option, PLACE(moment)},
    PP_ROOM_SIMULATION_GROUPS(PLACE(room)),
    {"Simulation", pp_engine_options, PLACE(engine)},
    {"Simulation", pp_room_plain_option, PLACE(room)},
    {"Irradiance cache", pp_cache_choice_options, PLACE(engine.cache)},
    {"Output", pp_format_option, PLACE(format)},
    {"Output", bands_option, 0},
    {"Output", margin_option, 0},
    {"Output", array_option, 0},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

const struct pp_command pp_command_df = {
    .name = "df",
    .summary = "daylight factors at reference points, and their average",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct pp_df_options),
    .more_help = help_on_methods,
    .init = init_df_options,
    .check = check_df_options,
    .run = run_df,
    .clear = clear_df_options,
    .uses_ranks = true,
    .ranks_place = PLACE(room.ranks),
};
