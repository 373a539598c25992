/* chart_run.c - see chart_run.h. */
#include "cli/chart/chart_run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "api/chart_sheet.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/rooms.h"
#include "studies/criteria/room_before.h"

/* Determines the format from --format, or else from the extension of the file. */
static enum pp_status choose_format(enum pp_chart_format *format,
                                    const struct pp_room_options *room_options,
                                    const struct pp_chart_words *options,
                                    struct pp_error *err)
{
    const char *output = room_options->output;
    if (options->format) {
        char name[16];
        snprintf(name, sizeof name, "chart.%s", options->format);
        return pp_canvas_format_of(format, name, err);
    }
    if (!output || strcmp(output, "-") == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected -o FILE.pdf, FILE.svg or FILE.png, or --format");
    return pp_canvas_format_of(format, output, err);
}

/* ---- the task ---- */

/* The chart to be drawn, its rooms, and the result. */
struct chart_task {
    const struct pp_chart_kind *kind;
    enum pp_chart_format format;
    const struct pp_room_options *room_options;
    const struct pp_chart_words *options;
    struct pp_rooms rooms, former;       /* former: rooms in their former state */
    const struct pp_study_room **before; /* former state of each room, as in struct
                                          * pp_chart_site */
    bool finished;                       /* false: a simulation was interrupted */
};

static void clear_chart_task(struct chart_task *task)
{
    free(task->before);
    pp_rooms_clear(&task->former);
    pp_rooms_clear(&task->rooms);
}

/* Number of rooms on the sheet that begins with room `first`: all rooms of its file for
 * a chart of a site, else 1. */
static int rooms_on_sheet(const struct chart_task *task, int first)
{
    const struct pp_rooms *rooms = &task->rooms;
    int count = 1;
    while (task->kind->of_site && first + count < rooms->count
           && rooms->list[first + count].building == rooms->list[first].building)
        count++;
    return count;
}

static int count_sheets(const struct chart_task *task)
{
    int sheets = 0;
    for (int i = 0; i < task->rooms.count; i += rooms_on_sheet(task, i))
        sheets++;
    return sheets;
}

/* Finds the former state of each room (room_before.h). */
static enum pp_status pair_rooms(struct chart_task *task, struct pp_error *err)
{
    const struct pp_rooms_before before = {task->former.list, task->former.count,
                                           task->options->before_is_state};
    task->before =
        calloc((size_t)task->rooms.count + 1, sizeof(struct pp_study_room *));
    if (!task->before)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < task->rooms.count && status == PP_OK; i++) {
        int *pairs;
        status = pp_room_before_find(&task->before[i], &pairs, &task->rooms.list[i],
                                     task->rooms.count, &before, err);
        free(pairs);
    }
    return status;
}

/* Loads the rooms in their former state. The former rooms come from the file of
 * --before. For --before existing, or a chart of a site, they come from the room file
 * itself. */
static enum pp_exit load_former(struct chart_task *task)
{
    const struct pp_chart_words *options = task->options;
    struct pp_room_options all_rooms = *task->room_options;
    struct pp_error err;
    enum pp_exit exit_status = PP_EXIT_DONE;
    all_rooms.room = NULL;
    if (options->before && !options->before_is_state) {
        char *file[] = {(char *)options->before};
        exit_status = pp_rooms_load(&task->former, "chart", file, 1, &all_rooms);
    } else if (options->before || task->kind->of_site) {
        exit_status = pp_rooms_load_state(&task->former, "chart", &task->rooms,
                                          &all_rooms, PP_STATE_EXISTING);
    }
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    if (options->before && task->former.count == 0) {
        pp_fail(&err, PP_BAD_INPUT,
                "--before existing: no element in %s has a state; expected a file with "
                "existing and proposed states, or --before FILE",
                task->rooms.list[0].file);
        return pp_message_usage("chart", &err);
    }
    if (pair_rooms(task, &err) != PP_OK)
        return pp_message_error(&err);
    return PP_EXIT_DONE;
}

static enum pp_exit load(struct chart_task *task, char **files, int file_count)
{
    enum pp_exit exit_status =
        pp_rooms_load(&task->rooms, "chart", files, file_count, task->room_options);
    return exit_status == PP_EXIT_DONE ? load_former(task) : exit_status;
}

/* ---- Sheets and files ---- */

/* Draws the sheet that begins with room `first`. */
static enum pp_status draw_chart_sheet(struct chart_task *task,
                                       struct pp_canvas *canvas, int first,
                                       struct pp_error *err)
{
    struct pp_chart_choice choice = task->options->choice;
    struct pp_study_room *room = NULL;
    if (task->rooms.count > 0) {
        room = &task->rooms.list[first];
        choice.site =
            (struct pp_chart_site){room, &task->before[first],
                                   rooms_on_sheet(task, first), choice.site.french_m};
    }
    return pp_chart_sheet_draw(task->kind, canvas, room, &task->room_options->study,
                               &choice, &task->finished, err);
}

/* Draws the sheets that begin with rooms [first, end) on one canvas. */
static enum pp_status draw_sheets(struct chart_task *task, struct pp_canvas *canvas,
                                  int first, int end, struct pp_error *err)
{
    enum pp_status status = draw_chart_sheet(task, canvas, first, err);
    if (task->rooms.count > 0)
        first += rooms_on_sheet(task, first);
    for (; first < end && status == PP_OK; first += rooms_on_sheet(task, first)) {
        status = pp_canvas_next_sheet(canvas, err);
        if (status == PP_OK)
            status = draw_chart_sheet(task, canvas, first, err);
    }
    return status;
}

/* Facts for the title block: those on the command line replace those in the room's
 * file. */
static struct pp_project project_of(const struct chart_task *task,
                                    const struct pp_study_room *room)
{
    struct pp_project project = {0};
    if (room && room->building)
        project = *pp_building_project(room->building);
    for (int i = 0; i < PP_PROJECT_FACTS; i++)
        if (pp_project_at(&task->options->project, i))
            *pp_project_place(&project, i) = pp_project_at(&task->options->project, i);
    return project;
}

static enum pp_status draw_charts(struct chart_task *task, int first, int end,
                                  FILE *out, struct pp_error *err)
{
    const struct pp_study_room *room =
        task->rooms.count ? &task->rooms.list[first] : NULL;
    const struct pp_world *world = room ? room->world : NULL;
    const struct pp_chart_words *options = task->options;
    char description[256];
    if (task->kind->outside && !world)
        snprintf(description, sizeof description, "%s", task->kind->summary);
    else if (options->choice.moment)
        snprintf(description, sizeof description,
                 "illuminances and direct sunlight on the plan, %s",
                 options->choice.moment->when ? options->choice.moment->when
                                              : "at one moment");
    else
        snprintf(description, sizeof description, "%s; sky: %s", task->kind->summary,
                 pp_sky_name(room ? &room->light.sky : &options->choice.board.sky));
    const struct pp_sheet sheet = {
        .format = task->format,
        .paper = options->paper,
        .landscape = options->orientation == PP_LANDSCAPE
                     || (options->orientation == PP_AS_FITS
                         && pp_chart_kind_landscape(task->kind, world)),
        .dpi = options->dpi,
        .transparent = task->kind->transparent,
        .title = world ? world->name : task->kind->name,
        .description = description};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    const struct pp_project project = project_of(task, room);
    pp_canvas_set_project(canvas, &project);
    status = draw_sheets(task, canvas, first, end, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

/* Draws the sheets that begin with rooms [first, end) into one output. */
static enum pp_status draw_to_output(struct chart_task *task, int first, int end,
                                     const char *path, struct pp_output *output,
                                     struct pp_error *err)
{
    enum pp_status status = pp_output_open(output, path, err);
    return status == PP_OK ? draw_charts(task, first, end, output->stream, err)
                           : status;
}

/* Draws all sheets into one file. */
static enum pp_status draw_to_file(struct chart_task *task, struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = draw_to_output(task, 0, task->rooms.count,
                                           task->room_options->output, &output, err);
    return pp_output_close(&output, status, err);
}

/* File name with a number before its extension, such as "plan-3.png", which the caller
 * frees. NULL: out of memory. */
static char *numbered(const char *path, int number)
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name ? name : path, '.');
    if (!dot)
        dot = path + strlen(path);
    char *made;
    int length = asprintf(&made, "%.*s-%d%s", (int)(dot - path), path, number, dot);
    return length < 0 ? NULL : made;
}

/* Draws each sheet to a separate numbered file, for a format without pages. The files
 * are written after all sheets are drawn, so no file is left if a chart fails. */
static enum pp_status draw_numbered(struct chart_task *task, int sheets,
                                    struct pp_error *err)
{
    struct pp_output *outputs = calloc((size_t)sheets, sizeof *outputs);
    enum pp_status status = outputs ? PP_OK : pp_fail_memory(err);
    int opened = 0;
    for (int first = 0; first < task->rooms.count && status == PP_OK; opened++) {
        int end = first + rooms_on_sheet(task, first);
        char *path = numbered(task->room_options->output, opened + 1);
        status = path ? draw_to_output(task, first, end, path, &outputs[opened], err)
                      : pp_fail_memory(err);
        free(path);
        first = end;
    }
    if (status == PP_OK)
        status = pp_output_commit_all(outputs, opened, err);
    for (int i = 0; i < opened; i++)
        pp_output_clear(&outputs[i]);
    free(outputs);
    return status;
}

static enum pp_exit draw_all(struct chart_task *task, bool to_standard_output)
{
    struct pp_error err = {0};
    int sheets = count_sheets(task);
    bool pages = task->format == PP_CHART_PDF || sheets <= 1;
    if (!pages && to_standard_output) {
        pp_fail(&err, PP_BAD_INPUT,
                "there are %d %s, but only a PDF can have several pages; expected -o "
                "FILE, --format pdf or --room NAME",
                sheets, task->kind->of_site ? "files" : "rooms");
        return pp_message_usage("chart", &err);
    }
    if (task->room_options->study.simulate)
        pp_interrupt_watch();
    enum pp_status status =
        pages ? draw_to_file(task, &err) : draw_numbered(task, sheets, &err);
    if (status == PP_INTERRUPTED) {
        pp_message("interrupted; no chart is written");
        return PP_EXIT_INTERRUPTED;
    }
    if (status != PP_OK)
        return pp_message_error(&err);
    if (task->finished)
        return PP_EXIT_DONE;
    pp_message("interrupted; the chart shows the results obtained so far");
    return PP_EXIT_INTERRUPTED;
}

/* Checks the number of points. Most drawing-board diagrams are for a single point. */
static enum pp_exit check_points(const struct pp_chart_kind *kind,
                                 const struct pp_rooms *rooms)
{
    for (int i = 0; kind->from_point && i < rooms->count; i++) {
        if (rooms->list[i].receiver_count == 1)
            continue;
        struct pp_error err;
        pp_fail(&err, PP_BAD_INPUT,
                "%s shows one point, but there are %d; expected one point, such as "
                "--points X,Y",
                kind->name, rooms->list[i].receiver_count);
        return pp_message_usage("chart", &err);
    }
    return PP_EXIT_DONE;
}

enum pp_exit pp_chart_run(const struct pp_chart_kind *kind,
                          const struct pp_room_options *room_options,
                          const struct pp_chart_words *options, char **files,
                          int file_count)
{
    struct pp_error err = {0};
    struct chart_task task = {.kind = kind,
                              .room_options = room_options,
                              .options = options,
                              .finished = true};
    if (choose_format(&task.format, room_options, options, &err) != PP_OK)
        return pp_message_usage("chart", &err);
    bool to_standard_output =
        !room_options->output || strcmp(room_options->output, "-") == 0;
    if (to_standard_output && isatty(STDOUT_FILENO)) {
        pp_fail(&err, PP_BAD_INPUT,
                "a chart cannot be written to the terminal; expected -o FILE");
        return pp_message_usage("chart", &err);
    }
    enum pp_exit exit_status = PP_EXIT_DONE;
    if (file_count > 0)
        exit_status = load(&task, files, file_count);
    if (exit_status == PP_EXIT_DONE)
        exit_status = check_points(kind, &task.rooms);
    if (exit_status == PP_EXIT_DONE)
        exit_status = draw_all(&task, to_standard_output);
    clear_chart_task(&task);
    return exit_status;
}
