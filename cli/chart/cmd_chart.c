/* cmd_chart.c - the command chart: draws one chart of each room to a PDF, SVG or
 * PNG. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/watch.h"
#include "api/chart_kind.h"
#include "api/chart_sheet.h"
#include "cli/availability/availability_options.h"
#include "cli/chart/board_options.h"
#include "cli/chart/model_options.h"
#include "cli/chart/overlay_options.h"
#include "cli/chart/sheet_options.h"
#include "cli/interrupt.h"
#include "cli/rooms.h"
#include "cli/message.h"
#include "cli/output.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "model/base/text.h"

static enum pp_status read_format(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "pdf") != 0 && strcmp(text, "svg") != 0
        && strcmp(text, "png") != 0)
        return pp_fail(err, PP_BAD_INPUT, "pdf, svg or png");
    *(const char **)place = text;
    return PP_OK;
}

static enum pp_status read_fill(const char *text, void *place, struct pp_error *err)
{
    static const char *const names[] = {
        [PP_FILL_NONE] = "none", [PP_FILL_COLOUR] = "colour", [PP_FILL_GREY] = "grey"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, names[i]) == 0) {
            *(enum pp_plan_fill *)place = (enum pp_plan_fill)i;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "none, colour or grey");
}

struct chart_sheet_options {
    const char *format; /* as typed; NULL: by the file's name */
    enum pp_paper paper;
    enum pp_orientation orientation;
    double dpi; /* 0: the canvas's own choice */
    bool list, logarithmic, linear;
    struct pp_chart_choice choice;
};

/* No paper was asked for: the kind's own. */
#define PAPER_UNSAID ((enum pp_paper) - 1)

#define PLACE(member) offsetof(struct chart_sheet_options, member)

static const struct pp_option sheet_options[] = {
    {"list", 'l', NULL,
     "List the kinds of chart, behind KIND the options too, and stop.", NULL,
     PLACE(list)},
    {"format", 'f', "FORMAT", "pdf, svg or png (default: by the ending of -o FILE).",
     read_format, PLACE(format)},
    {"paper", 0, "SIZE", "a5, a4 (default), a3 (of model-net the default) or a2.",
     pp_sheet_options_read_paper, PLACE(paper)},
    {"orientation", 0, "WAY", "portrait or landscape (default: as the room fits best).",
     pp_sheet_options_read_orientation, PLACE(orientation)},
    {"dpi", 0, "N", "Dots per inch of a PNG, 20 to 1200 (default 200).",
     pp_sheet_options_read_dpi, PLACE(dpi)},
    {"log", 0, NULL,
     "Section: daylight factors on a logarithmic scale (default: where they span more "
     "than 30 to 1).",
     NULL, PLACE(logarithmic)},
    {"linear", 0, NULL, "Section: on a linear scale.", NULL, PLACE(linear)},
    {"fill", 0, "WAY",
     "Plan: between the contours none (default), colour, or grey for printing in "
     "black.",
     read_fill, PLACE(choice.fill)},
    {0},
};

#define BOARD(member) PLACE(choice.board.member)

static const struct pp_option board_options[] = {
    {"glazed", 0, "yes|no",
     "Blank diagram: with the losses of clear single glass (default), or without.",
     pp_board_options_read_yes_no, BOARD(glazed)},
    {"fine", 0, NULL, "Pepper-pot: dots worth 0.01 % instead of 0.1 %.", NULL,
     BOARD(fine)},
    {"receiver", 0, "WAY",
     "Blank pepper-pot diagram: horizontal (default), or vertical, facing the window.",
     pp_board_options_read_receiver, BOARD(vertical)},
    {"viewing-distance", 0, "MM",
     "Pepper-pot: from the eye to the drawing, 5 to 200 mm (default 30, with --fine "
     "60, or less where a window would leave the sheet).",
     pp_board_options_read_viewing_mm, BOARD(viewing_mm)},
    {"number", 0, "N",
     "Blank protractor: 1 to 10 (default 2, vertical glass, overcast).",
     pp_board_options_read_protractor, BOARD(number)},
    {"glazing", 0, "NAME",
     "Blank protractor of any glazing, by its name in the table; or none.",
     pp_options_read_text, BOARD(glazing)},
    {"slope", 0, "DEG",
     "Blank protractor: slope of the glass, 0 horizontal to 90 vertical (default).",
     pp_board_options_read_slope, PLACE(choice.board)},
    {"which", 0, "NAME",
     "Nomogram: average (default) or minimum, for windows, or rooflight.",
     pp_board_options_read_nomogram, PLACE(choice.board)},
    {"inclined", 0, "DEG",
     "Waldram, vertical sky: droop lines of edges at an angle to the window in plan.",
     pp_board_options_read_inclined, PLACE(choice.board)},
    {"unsolved", 0, NULL,
     "Waldram, pepper-pot, protractor, brs-table, of a point: the exercise, which is "
     "the "
     "section, plan and elevations to scale, and in a PDF the blank diagram.",
     NULL, BOARD(unsolved)},
    {"window", 0, "WHICH",
     "Vertical sky, skylight indicator: the window, by its line in the file, or by its "
     "wall (default: the first upright one).",
     pp_options_read_text, BOARD(window)},
    {0},
};

static const char about[] =
    "Draws a chart of a room to -o FILE.pdf, FILE.svg or FILE.png. The rooms of a "
    "building, or of several files, get a page each of a PDF, and a file each of the "
    "other formats: FILE-1.png, FILE-2.png. FILE is a room file; - is standard input. "
    "The diagrams of the drawing board are blank without FILE, and with it are drawn "
    "from one point, by --points X,Y; a nomogram is for the whole room, and the "
    "diagrams of the vertical sky component are for one window, by --window.";

static void print_kinds(FILE *out)
{
    const struct pp_chart_kind *kind;
    for (int i = 0; (kind = pp_chart_kind_at(i)) != NULL; i++)
        pp_options_help_word(kind->name, kind->summary, out);
}

static void help_on_kinds(FILE *out)
{
    fputs("\nKinds of chart:\n", out);
    print_kinds(out);
}

/* The kind that was typed, or NULL and err. */
static const struct pp_chart_kind *find_kind(const char *typed, struct pp_error *err)
{
    const struct pp_chart_kind *kind = pp_chart_kind_find(typed);
    if (kind)
        return kind;
    const char *names[32];
    int count = 0;
    for (; count < 32 && (kind = pp_chart_kind_at(count)) != NULL; count++)
        names[count] = kind->name;
    pp_text_unknown(err, typed, names, count, NULL, "there is no chart \"%.100s\"",
                    typed);
    return NULL;
}

/* By --format, or by the file's ending. */
static enum pp_status choose_format(enum pp_chart_format *format,
                                    const struct pp_room_options *room_options,
                                    const struct chart_sheet_options *options,
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

/* What is drawn, of which rooms, and how it ended. */
struct chart_task {
    const struct pp_chart_kind *kind;
    enum pp_chart_format format;
    const struct pp_room_options *room_options;
    const struct chart_sheet_options *options;
    struct pp_study_room *rooms;
    int count;
    bool finished; /* false: a simulation was interrupted */
};

/* A sheet for each room, on one canvas. */
static enum pp_status draw_rooms(struct chart_task *drawing, struct pp_canvas *canvas,
                                 struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (drawing->count == 0)
        return pp_chart_sheet_draw(drawing->kind, canvas, NULL,
                                   &drawing->room_options->study,
                                   &drawing->options->choice, &drawing->finished, err);
    for (int i = 0; i < drawing->count && status == PP_OK; i++) {
        if (i > 0)
            status = pp_canvas_next_sheet(canvas, err);
        if (status == PP_OK)
            status =
                pp_chart_sheet_draw(drawing->kind, canvas, &drawing->rooms[i],
                                    &drawing->room_options->study,
                                    &drawing->options->choice, &drawing->finished, err);
    }
    return status;
}

static enum pp_status draw(struct chart_task *drawing, FILE *out, struct pp_error *err)
{
    const struct pp_world *world = drawing->count ? drawing->rooms[0].world : NULL;
    const struct chart_sheet_options *options = drawing->options;
    char description[256];
    if (drawing->kind->outside && !world)
        snprintf(description, sizeof description, "%s", drawing->kind->summary);
    else
        snprintf(description, sizeof description, "%s; sky: %s", drawing->kind->summary,
                 pp_sky_name(world ? &drawing->rooms[0].light.sky
                                   : &options->choice.board.sky));
    const struct pp_sheet sheet = {
        .format = drawing->format,
        .paper = options->paper,
        .landscape = options->orientation == PP_LANDSCAPE
                     || (options->orientation == PP_AS_FITS
                         && pp_chart_kind_landscape(drawing->kind, world)),
        .dpi = options->dpi,
        .transparent = drawing->kind->transparent,
        .title = world ? world->name : drawing->kind->name,
        .description = description};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status = draw_rooms(drawing, canvas, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

static enum pp_status draw_to_file(struct chart_task *drawing, const char *path,
                                   struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, err);
    if (status == PP_OK)
        status = draw(drawing, output.stream, err);
    return pp_output_close(&output, status, err);
}

/* "plan.png" with "-3" before its ending; to be freed. NULL when memory is out. */
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

/* A file for each room, in a format that has no pages. */
static enum pp_status draw_numbered(struct chart_task *all, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < all->count && status == PP_OK; i++) {
        struct chart_task one = *all;
        one.rooms = &all->rooms[i];
        one.count = 1;
        char *path = numbered(all->room_options->output, i + 1);
        status = path ? draw_to_file(&one, path, err) : pp_fail_memory(err);
        free(path);
        all->finished &= one.finished;
    }
    return status;
}

static enum pp_exit draw_all(struct chart_task *drawing, bool to_standard_output)
{
    struct pp_error err = {0};
    bool pages = drawing->format == PP_CHART_PDF || drawing->count <= 1;
    if (!pages && to_standard_output) {
        pp_fail(&err, PP_BAD_INPUT,
                "there are %d rooms, and only a PDF has a page for each; expected -o "
                "FILE, --format pdf or --room NAME",
                drawing->count);
        return pp_message_usage("chart", &err);
    }
    if (drawing->room_options->study.simulate)
        pp_interrupt_watch();
    enum pp_status status =
        pages ? draw_to_file(drawing, drawing->room_options->output, &err)
              : draw_numbered(drawing, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    if (drawing->finished)
        return PP_EXIT_DONE;
    pp_message("interrupted; the chart shows what was reached so far");
    return PP_EXIT_INTERRUPTED;
}

/* Most diagrams of the drawing board are drawn from one point. */
static enum pp_exit check_points(const struct pp_chart_kind *kind,
                                 const struct pp_rooms *rooms)
{
    for (int i = 0; kind->from_point && i < rooms->count; i++) {
        if (rooms->list[i].receiver_count == 1)
            continue;
        struct pp_error err;
        pp_fail(&err, PP_BAD_INPUT,
                "%s is drawn from one point, and there are %d; expected one, by "
                "--points X,Y",
                kind->name, rooms->list[i].receiver_count);
        return pp_message_usage("chart", &err);
    }
    return PP_EXIT_DONE;
}

static enum pp_exit run_on(const struct pp_chart_kind *kind,
                           const struct pp_room_options *room_options,
                           const struct chart_sheet_options *options, char **files,
                           int file_count)
{
    struct pp_error err = {0};
    enum pp_chart_format format;
    if (choose_format(&format, room_options, options, &err) != PP_OK)
        return pp_message_usage("chart", &err);
    bool to_standard_output =
        !room_options->output || strcmp(room_options->output, "-") == 0;
    if (to_standard_output && isatty(STDOUT_FILENO)) {
        pp_fail(&err, PP_BAD_INPUT,
                "a chart is not for the terminal; expected -o FILE");
        return pp_message_usage("chart", &err);
    }

    struct pp_rooms rooms = {0};
    enum pp_exit exit_status = PP_EXIT_DONE;
    if (file_count > 0)
        exit_status = pp_rooms_load(&rooms, "chart", files, file_count, room_options);
    if (exit_status == PP_EXIT_DONE)
        exit_status = check_points(kind, &rooms);
    if (exit_status != PP_EXIT_DONE) {
        pp_rooms_clear(&rooms);
        return exit_status;
    }
    struct chart_task drawing = {.kind = kind,
                                 .format = format,
                                 .room_options = room_options,
                                 .options = options,
                                 .rooms = rooms.list,
                                 .count = rooms.count,
                                 .finished = true};
    exit_status = draw_all(&drawing, to_standard_output);
    pp_rooms_clear(&rooms);
    return exit_status;
}

/* The light outside is asked for where it is drawn, and known without a room. */
static enum pp_status check_light(const struct pp_year_options *light,
                                  struct pp_room_options *options,
                                  const struct pp_chart_kind *kind, char **files,
                                  int file_count, struct pp_error *err)
{
    bool said = light->weather || !isnan(light->latitude_deg);
    if (!kind->outside)
        return said && (light->weather || !kind->of_sun)
                   ? pp_fail(err, PP_BAD_INPUT,
                             "%s is drawn without a year's light; --weather and "
                             "--latitude are of availability",
                             kind->name)
                   : PP_OK;
    if (!said && file_count == 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "expected --weather FILE.epw, --latitude DEG, or a room file with "
            "a site");
    if (!options->study.methods)
        options->study.methods = "exact+bre";
    return pp_availability_options_check(light, files, file_count, err);
}

/* ---- the command line ---- */

struct chart_command {
    struct pp_room_options room;
    struct chart_sheet_options chart;
    const struct pp_chart_kind *kind; /* by the first word; NULL: none */
};

#undef PLACE
#define PLACE(member) offsetof(struct chart_command, member)

static const struct pp_option_group groups[] = {
    {"The sheet", sheet_options, PLACE(chart)},
    {"Diagrams of the drawing board", board_options, PLACE(chart)},
    {"Overlay", pp_overlay_options, PLACE(chart.choice.board.overlay)},
    {"Scale model", pp_model_options, PLACE(chart.choice.model)},
    {"Availability", pp_light_options, PLACE(chart.choice.availability)},
    {"Availability", pp_illuminance_options, PLACE(chart.choice.availability)},
    PP_ROOM_CHOICE_GROUPS("What is computed", PLACE(room)),
    PP_ROOM_SIMULATION_GROUPS(PLACE(room)),
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init(void *values)
{
    *(struct chart_command *)values = (struct chart_command){
        .room = pp_room_options_none,
        .chart = {.paper = PAPER_UNSAID,
                  .choice.availability = pp_year_options_default}};
}

static enum pp_status check(void *values, char **words, int word_count,
                            struct pp_error *err)
{
    struct chart_command *command = values;
    struct pp_room_options *options = &command->room;
    struct chart_sheet_options *chart = &command->chart;
    if (chart->list)
        return PP_OK;
    if (word_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a kind of chart; --list names them");
    const struct pp_chart_kind *kind = command->kind = find_kind(words[0], err);
    if (!kind)
        return PP_BAD_INPUT;
    if (word_count == 1 && !kind->board && !kind->outside)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (chart->paper == PAPER_UNSAID)
        chart->paper = kind->paper;
    if (chart->choice.model.typed && kind != &pp_draw_model_net)
        return pp_fail(err, PP_BAD_INPUT, "%s is of a model-net",
                       chart->choice.model.typed);
    if (chart->logarithmic && chart->linear)
        return pp_fail(err, PP_BAD_INPUT, "a scale is --log or --linear, not both");
    chart->choice.scale = chart->logarithmic ? PP_SCALE_LOG
                          : chart->linear    ? PP_SCALE_LINEAR
                                             : PP_SCALE_AS_FITS;
    enum pp_status status = pp_room_options_settle(options, err);
    if (status == PP_OK)
        status = check_light(&chart->choice.availability, options, kind, words + 1,
                             word_count - 1, err);
    if (status == PP_OK && options->study.methods)
        status = pp_selection_check(options->study.methods, err);
    if (status == PP_OK && kind->check)
        status = kind->check(options->study.methods, options->study.simulate, err);
    if (status == PP_OK && kind->board)
        status = pp_board_options_check(&chart->choice.board, options, kind,
                                        word_count == 1, err);
    return status;
}

static enum pp_exit run(void *values, char **words, int word_count)
{
    struct chart_command *command = values;
    struct pp_terminal_watch watch;
    if (command->chart.list) {
        if (word_count > 0)
            pp_command_help(&pp_command_chart, stdout);
        else
            print_kinds(stdout);
        return PP_EXIT_DONE;
    }
    command->room.study.watch = pp_watch_of_terminal(&watch, command->room.quiet);
    enum pp_exit exit_status =
        pp_availability_options_load(&command->chart.choice.availability);
    return exit_status == PP_EXIT_DONE
               ? run_on(command->kind, &command->room, &command->chart, words + 1,
                        word_count - 1)
               : exit_status;
}

static void clear(void *values)
{
    struct chart_command *command = values;
    pp_availability_options_clear(&command->chart.choice.availability);
    pp_room_options_clear(&command->room);
}

const struct pp_command pp_command_chart = {
    .name = "chart",
    .summary = "one chart of a room as PDF, SVG or PNG",
    .operands = "KIND [FILE...]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct chart_command),
    .more_help = help_on_kinds,
    .init = init,
    .check = check,
    .run = run,
    .clear = clear,
    .words_before_files = 1,
};
