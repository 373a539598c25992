/* cmd_size.c - the command size: finds the smallest window that reaches a target. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "api/draw_envelope.h"
#include "cli/terminal.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/job.h"
#include "cli/output.h"
#include "model/base/text.h"
#include "reports/block_height_report.h"
#include "reports/plot_envelope_report.h"
#include "reports/size_report.h"
#include "cli/rooms.h"
#include "cli/format_option.h"
#include "cli/sweep/sweep_job.h"
#include "cli/sweep/sweep_options.h"
#include "cli/watch.h"
#include "cli/size/size_options.h"
#include "model/base/relative_path.h"
#include "reports/size_csv.h"
#include "reports/sweep/sweep_text.h"

static const char about[] =
    "Finds the window that just reaches a target: the smallest width, height, head, "
    "sill or number of windows that gives the target average daylight factor. With "
    "--points, the target is for the point with the lowest value; with --for, it is a "
    "criterion. The answer of a hand method is checked by simulation, unless --by-hand "
    "is given. --obstruction finds the maximum height of a block at which windows or "
    "rooms keep their share of the sky. --envelope finds the largest building on its "
    "plot. FILE is a room file; - is standard input.";

/* Adapts the text of a room file for a copy at `path`: relative names of other files
 * are changed. Replaces and frees *text, which is NULL after a failure. */
static enum pp_status move_text(char **text, size_t *length, const char *file,
                                const char *path, struct pp_error *err)
{
    char *way = NULL, *moved = NULL;
    enum pp_status status = pp_relative_path_prefix(&way, file, path, err);
    if (status == PP_OK)
        status = pp_room_text_move(&moved, length, *text, *length, way, err);
    free(way);
    free(*text);
    *text = moved;
    return status;
}

/* Writes the room file with the new sizes of openings in all rooms that reach the
 * target. PP_BAD_INPUT if no room does. */
static enum pp_status write_sized_file(const struct pp_size_results *results,
                                       const char *file, const char *path,
                                       struct pp_error *err)
{
    int count = 0;
    bool reached = false;
    for (int i = 0; i < results->count; i++)
        count += results->list[i].edit_count;
    struct pp_text_edit *edits = calloc((size_t)count + 1, sizeof *edits);
    if (!edits)
        return pp_fail_memory(err);
    count = 0;
    for (int i = 0; i < results->count; i++) {
        const struct pp_size_room_result *result = &results->list[i];
        if (result->answer.verdict != PP_SIZE_REACHED)
            continue;
        reached = true;
        for (int k = 0; k < result->edit_count; k++) {
            edits[count] = result->edits[k];
            edits[count++].opening += result->file_opening;
        }
    }
    char *text = NULL;
    size_t length;
    struct pp_output output = {0};
    enum pp_status status =
        reached ? pp_room_text_edit(&text, &length, results->list[0].file_text,
                                    results->list[0].file_length, edits, count, err)
                : pp_fail(err, PP_BAD_INPUT,
                          "the target was not reached, so %s was not written", path);
    if (status == PP_OK)
        status = move_text(&text, &length, file, path, err);
    if (status == PP_OK)
        status = pp_output_open(&output, path, err);
    if (status == PP_OK) {
        fwrite(text, 1, length, output.stream);
        status = pp_output_commit(&output, err);
    }
    free(text);
    free(edits);
    return status;
}

struct size_run {
    const struct pp_size_options *options;
    const struct pp_rooms *rooms;
    struct pp_size_results results;
};

/* Sizes all rooms. If there are several rooms, a room that cannot be sized gets a
 * reason instead of a size. If --window or --wall selects the window, such a room is
 * omitted. Fails if no room can be sized. */
static enum pp_status compute_sizes(void *data, struct pp_error *err)
{
    struct size_run *run = data;
    struct pp_size_results *results = &run->results;
    const struct pp_rooms *rooms = run->rooms;
    results->list = calloc((size_t)rooms->count, sizeof *results->list);
    if (!results->list)
        return pp_fail_memory(err);
    bool of_one_window = results->request->line > 0 || results->request->wall;
    int sized = 0;
    for (int i = 0; i < rooms->count; i++) {
        struct pp_size_room_result *result = &results->list[results->count++];
        struct pp_error fault = {0};
        enum pp_status status =
            pp_size_room(result, &rooms->list[i], results->request, &fault);
        sized += status == PP_OK;
        bool none = sized == 0 && i + 1 == rooms->count;
        if (status != PP_OK && (status != PP_BAD_INPUT || none))
            return pp_fail(err, status, "%s: %s", rooms->list[i].file, fault.message);
        if (status == PP_BAD_INPUT)
            pp_size_room_result_refuse(result, fault.message);
        if (status == PP_BAD_INPUT && of_one_window)
            results->count--;
    }
    return PP_OK;
}

static enum pp_status print_size(const void *data, FILE *out, struct pp_error *err)
{
    const struct size_run *run = data;
    if (run->options->format == PP_FORMAT_CSV)
        return pp_size_csv(&run->results, out, err);
    return run->options->format == PP_FORMAT_JSON
               ? pp_size_report_json(&run->results, out, err)
               : pp_size_report(&run->results,
                                pp_terminal_width(run->options->room.output),
                                pp_terminal_utf8(), out, err);
}

static enum pp_exit size_rooms(struct size_run *run)
{
    const struct pp_size_options *options = run->options;
    struct pp_error err = {0};
    if (options->room.study.simulate)
        pp_interrupt_watch();
    enum pp_exit exit_status = pp_job_run(
        &(struct pp_job){options->room.output, compute_sizes, print_size, NULL, run});
    if (exit_status == PP_EXIT_DONE && options->write
        && write_sized_file(&run->results, run->rooms->list[0].file, options->write,
                            &err)
               != PP_OK)
        return pp_message_error(&err);
    return exit_status;
}

static struct size_run size_run_of(const struct pp_size_options *options,
                                   const struct pp_rooms *rooms)
{
    return (struct size_run){
        .options = options,
        .rooms = rooms,
        .results = {.several = rooms->several,
                    .more_than_one_file = rooms->more_than_one_file,
                    .request = &options->request}};
}

static void clear_size_run(struct size_run *run)
{
    for (int i = 0; i < run->results.count; i++)
        pp_size_room_result_clear(&run->results.list[i]);
    free(run->results.list);
}

/* ---- --sweep ---- */

struct size_sweep {
    const struct pp_size_options *options;
    char **files;
    int file_count;
};

/* One run of the sweep. The first member is a struct size_run, so a pointer to this
 * struct can be passed to functions that expect one. */
struct size_sweep_run {
    struct size_run size;
    struct pp_rooms rooms;
};

static enum pp_exit load_size_run(void *run, const void *data)
{
    const struct size_sweep *sweep = data;
    struct size_sweep_run *one = run;
    enum pp_exit exit_status = pp_rooms_load(&one->rooms, "size", sweep->files,
                                             sweep->file_count, &sweep->options->room);
    one->size = size_run_of(sweep->options, &one->rooms);
    return exit_status;
}

static void clear_swept_run(void *run)
{
    struct size_sweep_run *one = run;
    clear_size_run(&one->size);
    pp_rooms_clear(&one->rooms);
}

static enum pp_status print_size_table(const void *runs, const void *data, FILE *out,
                                       struct pp_error *err)
{
    const struct size_sweep_run *list = runs;
    const struct pp_room_options *room =
        &((const struct size_sweep *)data)->options->room;
    int count = pp_sweep_count(&room->sweep);
    const struct pp_size_results **results = calloc((size_t)count, sizeof *results);
    if (!results)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        results[i] = &list[i].size.results;
    enum pp_status status =
        pp_sweep_size_text(&room->sweep, results, pp_terminal_width(room->output),
                           pp_terminal_utf8(), out, err);
    free(results);
    return status;
}

static enum pp_exit size_sweep(struct pp_size_options *options, char **files,
                               int file_count)
{
    const struct size_sweep sweep = {options, files, file_count};
    if (options->room.study.simulate)
        pp_interrupt_watch();
    return pp_sweep_job_run(&(struct pp_sweep_job){
        &options->room, options->format, sizeof(struct size_sweep_run), load_size_run,
        compute_sizes, NULL, print_size, print_size_table, clear_swept_run, &sweep});
}

/* ---- --obstruction: height of a block; --envelope: envelope on a plot ---- */

enum { NAMES_MOST = 64 };

struct block_run {
    const struct pp_size_options *options;
    const char *file;
    struct pp_block_height_task height_task;
    struct pp_block_height height;
    struct pp_plot_envelope_task envelope_task;
    struct pp_plot_envelope envelope;
};

/* Checks that the file has exactly one block of that name; otherwise PP_BAD_INPUT. */
static enum pp_status check_block_name(const char *file,
                                       const struct pp_building *building,
                                       const char *name, struct pp_error *err)
{
    const char *names[NAMES_MOST];
    int count = pp_building_block_names(building, names, NAMES_MOST);
    if (isfinite(pp_building_block_height(building, name)))
        return PP_OK;
    return count == 0 ? pp_fail(err, PP_BAD_INPUT,
                                "%s: no block in it has a name; expected one named "
                                "\"%.60s\"",
                                file, name)
                      : pp_text_unknown(err, name, names, count, NULL,
                                        "%s: no single block has the name \"%.60s\"",
                                        file, name);
}

static enum pp_status draw_envelope_to(struct block_run *run, FILE *out,
                                       struct pp_error *err)
{
    struct pp_sheet sheet = {.landscape = true,
                             .title = run->envelope_task.block,
                             .description = "the largest envelope on the plot"};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_format_of(&sheet.format, run->options->draw, err);
    if (status == PP_OK)
        status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status =
        pp_draw_envelope(canvas, &run->envelope, &run->envelope_task, run->file, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

static enum pp_status draw_envelope_chart(struct block_run *run, struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, run->options->draw, err);
    if (status == PP_OK)
        status = draw_envelope_to(run, output.stream, err);
    return pp_output_close(&output, status, err);
}

static enum pp_status compute_block_height(void *data, struct pp_error *err)
{
    struct block_run *run = data;
    struct pp_error fault = {0};
    enum pp_status status = check_block_name(run->file, run->height_task.building,
                                             run->height_task.block, err);
    if (status != PP_OK)
        return status;
    status = run->options->envelope
                 ? pp_plot_envelope_find(&run->envelope, &run->envelope_task, &fault)
                 : pp_block_height_find(&run->height, &run->height_task, &fault);
    if (status != PP_OK)
        return pp_fail(err, status, "%s: %s", run->file, fault.message);
    return run->options->draw ? draw_envelope_chart(run, err) : PP_OK;
}

static enum pp_status print_height(const struct block_run *run, int width, FILE *out,
                                   struct pp_error *err)
{
    return run->options->format == PP_FORMAT_JSON
               ? pp_block_height_report_json(&run->height, &run->height_task, out, err)
               : pp_block_height_report(&run->height, &run->height_task, width, out,
                                        err);
}

static enum pp_status print_envelope(const struct block_run *run, int width, FILE *out,
                                     struct pp_error *err)
{
    switch (run->options->format) {
    case PP_FORMAT_JSON:
        return pp_plot_envelope_report_json(&run->envelope, &run->envelope_task, out,
                                            err);
    case PP_FORMAT_CSV:
        return pp_plot_envelope_report_csv(&run->envelope, &run->envelope_task, out,
                                           err);
    default:
        return pp_plot_envelope_report(&run->envelope, &run->envelope_task, width, out,
                                       err);
    }
}

static enum pp_status print_block_height(const void *data, FILE *out,
                                         struct pp_error *err)
{
    const struct block_run *run = data;
    int width = pp_terminal_width(run->options->room.output);
    return run->options->envelope ? print_envelope(run, width, out, err)
                                  : print_height(run, width, out, err);
}

static enum pp_exit size_block(const struct pp_size_options *options, const char *file)
{
    struct pp_rooms rooms;
    char *files[] = {(char *)file};
    enum pp_exit exit_status = pp_rooms_load(&rooms, "size", files, 1, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct block_run run = {.options = options,
                            .file = file,
                            .height_task = {.building = rooms.buildings[0],
                                            .block = pp_size_options_block(options),
                                            .rule = options->rule,
                                            .most_m = options->highest_m},
                            .envelope_task = {.building = rooms.buildings[0],
                                              .block = pp_size_options_block(options),
                                              .rule = options->rule,
                                              .most_m = options->highest_m}};
    exit_status = pp_job_run(&(struct pp_job){
        options->room.output, compute_block_height, print_block_height, NULL, &run});
    pp_block_height_clear(&run.height);
    pp_plot_envelope_clear(&run.envelope);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command ---- */

static enum pp_exit run_size(void *values, char **files, int file_count)
{
    struct pp_size_options *options = values;
    struct pp_terminal_watch watch;
    struct pp_rooms rooms;
    if (pp_size_options_block(options))
        return size_block(options, files[0]);
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    if (options->room.sweep.axis_count > 0)
        return size_sweep(options, files, file_count);
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "size", files, file_count, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct size_run size = size_run_of(options, &rooms);
    exit_status = size_rooms(&size);
    clear_size_run(&size);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* ---- the command line ---- */

#define PLACE(member) offsetof(struct pp_size_options, member)

static const struct pp_option_group groups[] = {
    {"Target", pp_size_task_options, 0},
    {"Target", pp_size_block_options, 0},
    {"Target", pp_room_french_option, PLACE(rule.french_m)},
    {"Target", pp_room_spacing_option, PLACE(request.grid)},
    PP_ROOM_PLACE_GROUPS("Target", PLACE(room)),
    {"Target", pp_sweep_options, PLACE(room.sweep)},
    PP_ROOM_BY_HAND_GROUPS(PLACE(room)),
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_size_write_option, 0},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_size_options(void *values)
{
    *(struct pp_size_options *)values =
        (struct pp_size_options){.room = pp_room_options_none};
}

static enum pp_status check_size_options(void *values, char **files, int file_count,
                                         struct pp_error *err)
{
    struct pp_size_options *options = values;
    (void)files;
    enum pp_status status = pp_size_options_settle(options, err);
    if (status == PP_OK && file_count == 0)
        status =
            pp_fail(err, PP_BAD_INPUT, "expected a room file, or - for standard input");
    if (status == PP_OK && pp_size_options_block(options) && file_count > 1)
        status = pp_fail(err, PP_BAD_INPUT, "--%s needs one file, but there are %d",
                         options->envelope ? "envelope" : "obstruction", file_count);
    if (status == PP_OK && options->write && file_count > 1)
        status = pp_fail(err, PP_BAD_INPUT,
                         "--write needs one room file, but there are %d", file_count);
    const char *alone = options->write                   ? "write"
                        : pp_size_options_block(options) ? "obstruction"
                                                         : NULL;
    if (status == PP_OK && options->room.sweep.axis_count > 0 && alone)
        status =
            pp_fail(err, PP_BAD_INPUT,
                    "--%s is for a single run, but --sweep makes many; expected --set",
                    options->envelope ? "envelope" : alone);
    return status;
}

static void clear_size_options(void *values)
{
    struct pp_size_options *options = values;
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_size = {
    .name = "size",
    .summary = "the window that just reaches a target",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct pp_size_options),
    .init = init_size_options,
    .check = check_size_options,
    .run = run_size,
    .clear = clear_size_options,
};
