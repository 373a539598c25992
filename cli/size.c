/* size - the window that just reaches a target. */
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/gather.h"
#include "cli/interrupt.h"
#include "cli/messages.h"
#include "cli/output.h"
#include "cli/print.h"
#include "cli/print_size.h"
#include "cli/rooms.h"
#include "cli/size_options.h"
#include "cli/utf8.h"
#include "design/room_value.h"
#include "methods/method.h"

static const char about[] =
    "The window that just reaches a target: the smallest width, height, head, sill or "
    "number of windows with which the average daylight factor over the working plane, "
    "or "
    "with --points the lowest of some points, is not below it. With --simulate the "
    "answer "
    "is traced, too. FILE is a room file; - is standard input.";

/* What a value of a room is worked out from. */
struct valuation {
    const struct pp_size_options *options;
    const struct pp_loaded_room *room;
    struct pp_room_value by_hand;
};

/* The traced average, or the lowest of the points. */
static enum pp_status trace(struct valuation *valuation, const struct pp_world *world,
                            struct pp_reading *reading, struct pp_error *err)
{
    int points = valuation->by_hand.point_count;
    struct pp_report report = {.world = world,
                               .receivers = valuation->by_hand.points,
                               .receiver_count = points,
                               .finished = true};
    bool by_clock;
    enum pp_status status =
        pp_gather_traced(&report, &valuation->options->room, &by_clock, err);
    if (status == PP_OK && !report.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted before a size was found");
    if (status == PP_OK) {
        const struct pp_column *df = pp_report_find(&report, PP_DF, "traced");
        *reading = points > 0 ? df->points[0] : df->average;
        for (int i = 1; i < points; i++)
            if (df->points[i].value < reading->value)
                *reading = df->points[i];
    }
    pp_report_clear(&report);
    return status;
}

static enum pp_status value_of(void *data, const struct pp_world *world,
                               struct pp_reading *reading, struct pp_error *err)
{
    struct valuation *valuation = data;
    return valuation->options->traced
               ? trace(valuation, world, reading, err)
               : pp_room_value(&valuation->by_hand, world, reading, err);
}

/* Is the opening one of those that may change? */
static bool is_chosen(const struct pp_size_options *options,
                      const struct pp_room_opening *opening, enum pp_opening_kind kind)
{
    if (options->line > 0)
        return opening->line == options->line;
    return opening->kind == kind
           && (!options->wall || strcmp(opening->wall, options->wall) == 0);
}

/* The indices of the openings that change: the windows, or the rooflights where there
 * are no windows. Fails where there are none. */
static enum pp_status choose(int *openings, int *count,
                             const struct pp_size_options *options,
                             const struct pp_room *room, struct pp_error *err)
{
    int all = pp_room_opening_count(room), windows = 0;
    for (int i = 0; i < all; i++)
        windows += pp_room_opening_at(room, i).kind == PP_WINDOW;
    enum pp_opening_kind kind = windows > 0 || options->wall ? PP_WINDOW : PP_ROOFLIGHT;
    *count = 0;
    for (int i = 0; i < all; i++) {
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        if (is_chosen(options, &opening, kind))
            openings[(*count)++] = i;
    }
    if (*count > 0)
        return PP_OK;
    if (options->line > 0)
        return pp_fail(err, PP_BAD_INPUT, "there is no window on line %ld",
                       options->line);
    if (options->wall)
        return pp_fail(err, PP_BAD_INPUT, "there is no window in a wall \"%.200s\"",
                       options->wall);
    return pp_fail(err, PP_BAD_INPUT,
                   "there is no window or rooflight to change; expected one to begin "
                   "with, of any size");
}

static bool is_by_counts(const char *by)
{
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(by, "+"), by);
    const struct pp_method *direct = pp_method_find(name);
    const char *plus = strchr(by, '+');
    const struct pp_method *internal = plus ? pp_method_find(plus + 1) : NULL;
    return (direct && direct->counts) || (internal && internal->counts);
}

/* The simulated check of an answer. */
static enum pp_status check_by_simulation(struct pp_size_result *result,
                                          struct valuation *valuation,
                                          struct pp_error *err)
{
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the sized room");
    enum pp_status status =
        pp_world_create(&world, result->answer.room, &mistakes, err);
    if (status == PP_OK)
        status = trace(valuation, world, &result->traced, err);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    return status;
}

static enum pp_status size_room(struct pp_size_result *result,
                                const struct pp_loaded_room *room,
                                const struct pp_size_options *options,
                                struct pp_error *err)
{
    bool points = options->room.points.count > 0;
    struct valuation valuation = {
        .options = options,
        .room = room,
        .by_hand = {.method = options->by,
                    .points = points ? room->receivers : NULL,
                    .point_count = points ? room->receiver_count : 0}};
    *result = (struct pp_size_result){.room = room, .traced = pp_reading_none(NULL)};
    int all = pp_room_opening_count(room->room);
    int *openings = malloc(((size_t)all + 1) * sizeof *openings);
    if (!openings)
        return pp_fail_memory(err);
    struct pp_size_task task = {.room = room->room,
                                .change = options->change,
                                .openings = openings,
                                .target = options->target,
                                .by_counts = is_by_counts(options->by),
                                .value = value_of,
                                .data = &valuation};
    enum pp_status status =
        choose(openings, &task.opening_count, options, room->room, err);
    if (status == PP_OK)
        status = pp_size_find(&result->answer, &task, err);
    free(openings);
    if (status == PP_OK && result->answer.verdict == PP_SIZE_NO_VALUE) {
        snprintf(result->text, sizeof result->text, "%s", valuation.by_hand.why);
        result->why = result->text;
    }
    if (status == PP_OK && options->room.simulate && !options->traced
        && result->answer.room)
        status = check_by_simulation(result, &valuation, err);
    return status;
}

static enum pp_exit size_rooms(struct pp_size_results *results,
                               const struct pp_rooms *rooms)
{
    const struct pp_size_options *options = results->options;
    struct pp_error err = {0};
    struct pp_output output;
    if (options->room.threads > 0)
        omp_set_num_threads(options->room.threads);
    if (options->room.simulate)
        pp_interrupt_watch();
    enum pp_status status = pp_output_open(&output, options->room.output, &err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++)
        status =
            size_room(&results->list[results->count++], &rooms->list[i], options, &err);
    if (status == PP_OK && options->json)
        status = pp_print_size_json(results, output.stream, &err);
    else if (status == PP_OK)
        pp_print_size(results, pp_print_width(options->room.output), pp_utf8_terminal(),
                      output.stream);
    if (status == PP_OK)
        status = pp_output_commit(&output, &err);
    if (status == PP_OK)
        return PP_EXIT_DONE;
    pp_output_abandon(&output);
    return pp_say_error(&err);
}

static enum pp_exit run(const struct pp_size_options *options, char **files,
                        int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "size", files, file_count, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct pp_size_results results = {.several = rooms.several,
                                      .more_than_one_file = rooms.more_than_one_file,
                                      .options = options};
    results.list = calloc((size_t)rooms.count, sizeof *results.list);
    if (results.list) {
        exit_status = size_rooms(&results, &rooms);
    } else {
        struct pp_error err;
        pp_fail_memory(&err);
        exit_status = pp_say_error(&err);
    }
    for (int i = 0; i < results.count; i++)
        pp_size_answer_clear(&results.list[i].answer);
    free(results.list);
    pp_rooms_clear(&rooms);
    return exit_status;
}

enum pp_exit cmd_size(int argc, char **argv)
{
    struct pp_size_options options = {.room = pp_room_options_none, .by = "exact+bre"};
    const struct pp_option_group groups[] = {
        {"What is wanted", pp_size_task_options, &options},
        {"What is wanted", pp_room_place_options, &options.room},
        {"Simulation", pp_room_simulation_options, &options.room},
        {"Output", pp_size_format_option, &options},
        {"Output", pp_room_output_options, &options.room},
        {0},
    };
    const struct pp_command_line line = {"size", "FILE...", about, groups};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help) {
        status = pp_size_options_settle(&options, &err);
        if (status == PP_OK && file_count == 0)
            status = pp_fail(&err, PP_BAD_INPUT,
                             "expected a room file, or - for standard input");
    }
    if (status == PP_SYSTEM)
        exit_status = pp_say_error(&err);
    else if (status != PP_OK)
        exit_status = pp_say_usage("size", &err);
    else if (wants_help)
        exit_status = (pp_options_help(&line, stdout), PP_EXIT_DONE);
    else
        exit_status = run(&options, argv, file_count);
    pp_room_options_clear(&options.room);
    return exit_status;
}
