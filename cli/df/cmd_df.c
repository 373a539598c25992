/* df - daylight factors at the reference points, and their average. */
#include <stdlib.h>
#include <string.h>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/print/format.h"
#include "cli/study_report.h"
#include "cli/study_cached.h"
#include "cli/interrupt.h"
#include "cli/lumen_option.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/print/print.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "methods/method.h"

static const struct pp_option explain_option[] = {
    {"explain", 'e', NULL,
     "Set out how each figure comes about, step by step as on paper; of one point, "
     "in text or JSON.",
     NULL, offsetof(struct pp_room_options, explain)},
    {0},
};

static const char about[] =
    "Daylight factors at the reference points of each room, and their average over the "
    "working plane, in per cent: by hand methods, and with --simulate by tracing light "
    "paths as well. FILE is a room file; - is standard input.";

static void help_on_methods(FILE *out)
{
    fputs("\nMethods:\n", out);
    const struct pp_method *method;
    for (int i = 0; (method = pp_method_at(i)) != NULL; i++)
        pp_options_help_word(method->name, method->summary, out);
    pp_options_help_word("A+B", "direct component by A, internally reflected by B",
                         out);
    pp_options_help_word("default", "exact+bre, brs-table+bre, average-df", out);
    pp_options_help_word("all",
                         "every direct method with bre, exact with every internally "
                         "reflected one, and every method that gives the whole",
                         out);
}

/* Hand methods of all rooms first: they take milliseconds, and are there whatever
 * happens to the simulation. */
static enum pp_status compute(struct pp_results *results, const struct pp_rooms *rooms,
                              const struct pp_engine_choice *engine,
                              struct pp_error *err)
{
    for (int i = 0; i < rooms->count; i++) {
        struct pp_result *result = &results->list[results->count++];
        result->file = rooms->list[i].file;
        enum pp_status status = pp_study_report_methods(
            &result->report, &rooms->list[i], results->options, err);
        if (status != PP_OK)
            return status;
    }
    if (!results->options->simulate)
        return PP_OK;

    pp_interrupt_watch();
    for (int i = 0; i < results->count; i++) {
        struct pp_result *result = &results->list[i];
        enum pp_status status = PP_OK;
        if (engine->path)
            status = pp_study_report_traced(&result->report, results->options,
                                            &result->by_clock, err);
        if (status == PP_OK && engine->cached)
            status = pp_study_cached_add(&result->report, results->options, engine,
                                         &result->by_clock, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

static enum pp_status print(const struct pp_results *results, enum pp_format format,
                            FILE *out, struct pp_error *err)
{
    switch (format) {
    case PP_FORMAT_JSON:
        return pp_df_json(results, out, err);
    case PP_FORMAT_CSV:
        return pp_df_csv(results, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_df_text(results, pp_print_width(results->options->output),
                      pp_format_utf8_terminal(), out, err);
}

static enum pp_exit compute_and_print(struct pp_results *results,
                                      const struct pp_rooms *rooms,
                                      const struct pp_engine_choice *engine,
                                      enum pp_format format)
{
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, results->options->output, &err);
    if (status == PP_OK)
        status = compute(results, rooms, engine, &err);
    if (status == PP_OK)
        status = print(results, format, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    for (int i = 0; i < results->count; i++)
        if (!results->list[i].report.finished)
            return pp_message_unfinished();
    return PP_EXIT_DONE;
}

/* A sum is set out for one point a room. */
static enum pp_exit check_explained(const struct pp_room_options *options,
                                    const struct pp_rooms *rooms)
{
    for (int i = 0; options->explain && i < rooms->count; i++) {
        if (rooms->list[i].receiver_count == 1)
            continue;
        struct pp_error err;
        pp_fail(&err, PP_BAD_INPUT,
                "--explain sets out the sums of one point, and there are %d; expected "
                "one, by --points X,Y",
                rooms->list[i].receiver_count);
        return pp_message_usage("df", &err);
    }
    return PP_EXIT_DONE;
}

static enum pp_exit run(const struct pp_room_options *options,
                        const struct pp_engine_choice *engine, enum pp_format format,
                        char **files, int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit exit_status = pp_rooms_load(&rooms, "df", files, file_count, options);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;

    exit_status = check_explained(options, &rooms);
    if (exit_status == PP_EXIT_DONE && engine->cache.file && rooms.count > 1) {
        struct pp_error err;
        pp_fail(&err, PP_BAD_INPUT,
                "--cache has the records of one room, and there are %d; expected one, "
                "by --room NAME",
                rooms.count);
        exit_status = pp_message_usage("df", &err);
    }
    if (exit_status != PP_EXIT_DONE) {
        pp_rooms_clear(&rooms);
        return exit_status;
    }
    struct pp_results results = {.several = rooms.several,
                                 .more_than_one_file = rooms.more_than_one_file,
                                 .options = options};
    results.list = calloc((size_t)rooms.count, sizeof *results.list);
    if (results.list) {
        exit_status = compute_and_print(&results, &rooms, engine, format);
    } else {
        struct pp_error err;
        pp_fail_memory(&err);
        exit_status = pp_message_error(&err);
    }
    for (int i = 0; i < results.count; i++)
        pp_report_clear(&results.list[i].report);
    free(results.list);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* What the options say, before any file is opened. */
static enum pp_status check(struct pp_room_options *options, enum pp_format format,
                            int file_count, struct pp_error *err)
{
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (options->explain && format == PP_FORMAT_CSV)
        return pp_fail(err, PP_BAD_INPUT,
                       "--explain has no place in CSV; expected --format text or json");
    enum pp_status status = pp_room_options_settle(options, err);
    if (status == PP_OK && options->methods)
        status = pp_selection_check(options->methods, err);
    return status;
}

/* With the user's own tables, if he has any. */
static enum pp_exit run_with_tables(struct pp_room_options *options,
                                    const struct pp_engine_choice *engine,
                                    const struct pp_lumen_files *lumen_files,
                                    enum pp_format format, char **files, int file_count)
{
    struct pp_lumen_table *table;
    enum pp_exit exit_status = pp_lumen_option_load(&table, lumen_files);
    options->method_options.lumen_table = table;
    if (exit_status == PP_EXIT_DONE)
        exit_status = run(options, engine, format, files, file_count);
    options->method_options.lumen_table = NULL;
    pp_lumen_table_destroy(table);
    return exit_status;
}

enum pp_exit cmd_df(int argc, char **argv)
{
    struct pp_room_options options = pp_room_options_none;
    struct pp_lumen_files lumen_files = {.count = 0};
    struct pp_engine_choice engine = {.cache = pp_cache_choice_default()};
    enum pp_format format = PP_FORMAT_TEXT;
    const struct pp_option_group groups[] = {
        {"What is computed", pp_room_choice_options, &options},
        {"What is computed", pp_lumen_option, &lumen_files},
        {"What is computed", explain_option, &options},
        {"What is computed", pp_room_external_option, &options},
        {"Simulation", pp_room_simulation_options, &options},
        {"Simulation", pp_engine_options, &engine},
        {"Irradiance cache", pp_cache_choice_options, &engine.cache},
        {"Output", pp_format_option, &format},
        {"Output", pp_room_output_options, &options},
        {0},
    };
    const struct pp_command_line line = {"df", "FILE...", about, groups,
                                         help_on_methods};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help)
        status = check(&options, format, file_count, &err);
    if (status == PP_OK && !wants_help)
        status = pp_study_cached_settle(&engine, options.simulate, &err);

    if (pp_command_line_starts(&line, argv, file_count, status, wants_help, &err,
                               &exit_status))
        exit_status =
            run_with_tables(&options, &engine, &lumen_files, format, argv, file_count);
    pp_room_options_clear(&options);
    pp_cache_choice_clear(&engine.cache);
    return exit_status;
}
