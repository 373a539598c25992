/* cmd_chart.c - the command chart: draws one chart of each room to a PDF, SVG or
 * PNG. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/watch.h"
#include "api/chart_kind.h"
#include "cli/availability/availability_options.h"
#include "cli/chart/board_options.h"
#include "cli/chart/chart_run.h"
#include "cli/chart/moment_plan_options.h"
#include "cli/chart/sheet_options.h"
#include "cli/message.h"
#include "methods/evaluate.h"
#include "methods/selection.h"
#include "model/base/text.h"
#include "model/light/photographs/sky_picture.h"

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

static enum pp_status read_mirror_line(const char *text, void *place,
                                       struct pp_error *err)
{
    struct pp_chart_choice *choice = place;
    choice->line_said = true;
    if (strcmp(text, "no-sky") == 0)
        choice->line = PP_LIT_NO_SKY;
    else if (strcmp(text, "sky-factor") == 0)
        choice->line = PP_LIT_SKY_FACTOR;
    else
        return pp_fail(err, PP_BAD_INPUT, "no-sky or sky-factor");
    return PP_OK;
}

/* Value if no paper size is given. The kind of chart then determines the size. */
#define PAPER_UNSAID ((enum pp_paper) - 1)

#define PLACE(member) offsetof(struct pp_chart_words, member)

static const struct pp_option sheet_options[] = {
    {"list", 'l', NULL,
     "List the kinds of chart, or after KIND the options of that chart, and stop.",
     NULL, PLACE(list)},
    {"format", 'f', "FORMAT",
     "pdf, svg or png (default: from the extension of -o FILE).", read_format,
     PLACE(format)},
    {"paper", 0, "SIZE",
     "Paper size: a5, a4 (default), a3 (default for model-net) or a2.",
     pp_sheet_options_read_paper, PLACE(paper)},
    {"orientation", 0, "WAY", "portrait or landscape (default: whichever fits best).",
     pp_sheet_options_read_orientation, PLACE(orientation)},
    {"dpi", 0, "N", "Resolution of a PNG in dots per inch, 20 to 1200 (default 200).",
     pp_sheet_options_read_dpi, PLACE(dpi)},
    {"log", 0, NULL,
     "Section: logarithmic scale of daylight factors (default if the highest is more "
     "than 30 times the lowest).",
     NULL, PLACE(logarithmic)},
    {"linear", 0, NULL, "Section: linear scale.", NULL, PLACE(linear)},
    {"before", 'b', "FILE",
     "Plan, site, elevation, sun path: compare with this room file of the site "
     "before the development. existing: compare with the existing state in the same "
     "file.",
     pp_options_read_input, PLACE(before)},
    {"line", 0, "NAME",
     "Plan: mark the area with a view of the sky (no-sky), or with a sky factor over "
     "0.2 % (sky-factor). With --before: also the area lost.",
     read_mirror_line, PLACE(choice)},
    {"fill", 0, "WAY",
     "Plan: fill between contours: none (default), colour, or grey for black-and-white "
     "print.",
     read_fill, PLACE(choice.fill)},
    {0},
};

#define BOARD(member) PLACE(choice.board.member)

static const struct pp_option board_options[] = {
    {"glazed", 0, "yes|no",
     "Blank diagram: include the losses of clear single glass (default yes).",
     pp_board_options_read_yes_no, BOARD(glazed)},
    {"fine", 0, NULL, "Pepper-pot: each dot is worth 0.01 % instead of 0.1 %.", NULL,
     BOARD(fine)},
    {"receiver", 0, "WAY",
     "Blank pepper-pot diagram: for a horizontal receiver (default), or for a vertical "
     "one that faces the window.",
     pp_board_options_read_receiver, BOARD(vertical)},
    {"viewing-distance", 0, "MM",
     "Pepper-pot: distance from eye to drawing, 5 to 200 mm (default 30, with --fine "
     "60; less if a window would not fit on the sheet).",
     pp_board_options_read_viewing_mm, BOARD(viewing_mm)},
    {"number", 0, "N",
     "Blank protractor: number 1 to 10 (default 2, vertical glass, overcast sky).",
     pp_board_options_read_protractor, BOARD(number)},
    {"glazing", 0, "NAME", "Blank protractor: a glazing from the table, or none.",
     pp_options_read_text, BOARD(glazing)},
    {"slope", 0, "DEG",
     "Blank protractor: slope of the glass, 0 (horizontal) to 90 (vertical, default).",
     pp_board_options_read_slope, PLACE(choice.board)},
    {"which", 0, "NAME",
     "Nomogram: average or minimum for windows (default average), or rooflight.",
     pp_board_options_read_nomogram, PLACE(choice.board)},
    {"inclined", 0, "DEG",
     "Waldram diagram of the vertical sky: draw droop lines for edges at this angle to "
     "the window in plan.",
     pp_board_options_read_inclined, PLACE(choice.board)},
    {"unsolved", 0, NULL,
     "Waldram, pepper-pot, protractor, brs-table for a point: draw an exercise "
     "without its solution. It shows section, plan and elevations to scale; a PDF "
     "adds the blank diagram.",
     NULL, BOARD(unsolved)},
    {"slats", 0, "W,S,ANGLE,...",
     "Slats without a room: width and spacing in m, angle in degrees; then reflectance "
     "above (default 0.5) and below, and curvature in m.",
     pp_board_options_read_slats, PLACE(choice.board)},
    {"window", 0, "WHICH",
     "Vertical sky, skylight indicator, sun path, slats: the window, by its name, by "
     "its wall or by its line number in the file (default: the first vertical window).",
     pp_options_read_text, BOARD(window)},
    {0},
};

/* ---- options of scale models ---- */

static enum pp_status read_scale(const char *text, void *place, struct pp_error *err)
{
    struct pp_model_options *options = place;
    double scale;
    if (!pp_text_parse_number(text, &scale) || !(scale >= 2.0 && scale <= 500.0))
        return pp_fail(err, PP_BAD_INPUT, "a number from 2 to 500: 20 for 1:20");
    options->scale = scale;
    options->typed = "--scale";
    return PP_OK;
}

static enum pp_status read_mirror_box(const char *text, void *place,
                                      struct pp_error *err)
{
    struct pp_model_options *options = place;
    const char *comma = strchr(text, ',');
    char first[32] = "";
    double rho = -1.0, height = -1.0;
    if (comma && (size_t)(comma - text) < sizeof first)
        memcpy(first, text, (size_t)(comma - text));
    if (!pp_text_parse_number(first, &rho) || !(rho > 0.0 && rho <= 1.0)
        || !pp_text_parse_number(comma + 1, &height)
        || !(height >= 0.01 && height <= 10.0))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the reflectance of the mirrors, above 0 and up to 1, and the ratio of the "
            "height of the box to its width, from 0.01 to 10, such as 0.85,0.5");
    options->box = (struct pp_mirror_box){rho, height};
    options->has_box = true;
    options->typed = "--mirror-box";
    return PP_OK;
}

static const struct pp_option model_options[] = {
    {"scale", 0, "N", "1:N, from 2 to 500 (default 20).", read_scale, 0},
    {"mirror-box", 0, "RHO,K",
     "Mirror box for measurements in the model: reflectance of the mirrors, and ratio "
     "of the height of the box to its width (default 0.85,0.5).",
     read_mirror_box, 0},
    {0},
};

/* ---- options of overlays ---- */

static enum pp_status read_lens(const char *text, void *place, struct pp_error *err)
{
    static const char *const names[PP_LENS_COUNT] = {
        [PP_LENS_EQUIDISTANT] = "equidistant",
        [PP_LENS_EQUISOLID] = "equisolid",
        [PP_LENS_STEREOGRAPHIC] = "stereographic",
        [PP_LENS_ORTHOGRAPHIC] = "orthographic",
    };
    struct pp_overlay_options *overlay = place;
    for (int i = 0; i < PP_LENS_COUNT; i++)
        if (strcmp(text, names[i]) == 0) {
            overlay->lens = (enum pp_lens)i;
            overlay->typed = "--lens";
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT,
                   "equidistant, equisolid, stereographic or orthographic");
}

static enum pp_status read_diameter(const char *text, void *place, struct pp_error *err)
{
    struct pp_overlay_options *overlay = place;
    double mm;
    if (!pp_text_parse_number(text, &mm) || !(mm >= 20.0 && mm <= 400.0))
        return pp_fail(err, PP_BAD_INPUT, "a number of millimetres from 20 to 400");
    overlay->diameter_mm = mm;
    overlay->typed = "--diameter";
    return PP_OK;
}

static enum pp_status read_show(const char *text, void *place, struct pp_error *err)
{
    struct pp_overlay_options *overlay = place;
    overlay->said = true;
    overlay->typed = "--show";
    for (const char *at = text;; at++) {
        size_t length = strcspn(at, ",");
        bool *shown = length == 4 && strncmp(at, "dots", 4) == 0    ? &overlay->dots
                      : length == 5 && strncmp(at, "cells", 5) == 0 ? &overlay->cells
                      : length == 3 && strncmp(at, "sun", 3) == 0   ? &overlay->sun
                                                                    : NULL;
        if (!shown)
            return pp_fail(err, PP_BAD_INPUT,
                           "dots, cells, sun, or several of these, separated by "
                           "commas");
        *shown = true;
        at += length;
        if (!*at)
            return PP_OK;
    }
}

static const struct pp_option overlay_options[] = {
    {"lens", 0, "NAME",
     "equidistant (default), equisolid, stereographic or orthographic.", read_lens, 0},
    {"diameter", 0, "MM",
     "Diameter of the horizon circle, 20 to 400 mm (default: as large as the paper "
     "allows).",
     read_diameter, 0},
    {"show", 0, "WHAT,...",
     "Marks: dots (0.1 % each), cells (0.5 % each), sun (sun paths), or several of "
     "these, separated by commas. Default: dots, and with --latitude also sun.",
     read_show, 0},
    {0},
};

/* ---- kinds ---- */

static const char about[] =
    "Draws a chart of a room to -o FILE.pdf, FILE.svg or FILE.png. Several rooms get "
    "one page each in a PDF, or one file each: FILE-1.png, FILE-2.png. FILE is a room "
    "file; - is standard input. Diagrams of the drawing board are blank without FILE. "
    "With FILE they show one point, selected by --points X,Y. A nomogram shows the "
    "whole room. Diagrams of the vertical sky component show one window, selected by "
    "--window.";

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

/* Finds the kind of chart with the typed name. NULL, with err set, if there is none. */
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

/* Checks that options for daylight outside are given only for charts that use them, and
 * that they are complete if there is no room. */
static enum pp_status check_light(const struct pp_year_options *light,
                                  struct pp_room_options *options,
                                  const struct pp_chart_kind *kind, int file_count,
                                  struct pp_error *err)
{
    bool said = light->weather || !isnan(light->latitude_deg);
    if (kind->of_year) {
        if (!light->weather || file_count == 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "the chart %s needs a weather file and a room file; "
                           "expected --weather FILE.epw",
                           kind->name);
        const char *time = pp_availability_options_typed(light);
        if (kind == &pp_draw_en17037 && time)
            return pp_fail(err, PP_BAD_INPUT,
                           "the page of EN 17037 has the hours of the standard; "
                           "expected no %s",
                           time);
        return pp_availability_options_check(light, err);
    }
    if (!kind->outside)
        return said && !(light->weather ? kind->of_weather : kind->of_sun)
                   ? pp_fail(err, PP_BAD_INPUT,
                             "%s does not use weather data; --weather and --latitude "
                             "apply to availability, --weather also to year and "
                             "sun-path",
                             kind->name)
                   : PP_OK;
    if (!said && file_count == 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "expected --weather FILE.epw, --latitude DEG, or a room file with "
            "a site");
    if (!options->study.methods)
        options->study.methods = "exact+bre";
    return pp_availability_options_check(light, err);
}

/* ---- the command line ---- */

struct chart_command {
    struct pp_room_options room;
    struct pp_chart_words chart;
    struct pp_moment_choice moment;
    struct pp_moment_source source;
    const struct pp_chart_kind *kind; /* kind of chart named by the first operand; NULL:
                                       * none */
};

#undef PLACE
#define PLACE(member) offsetof(struct chart_command, member)

static const struct pp_option_group groups[] = {
    {"Sheet", sheet_options, PLACE(chart)},
    {"Sheet", pp_room_cut_option, PLACE(chart.choice.cut)},
    {"Sheet", pp_room_french_option, PLACE(chart.choice.site.french_m)},
    {"Title block", pp_room_project_options, PLACE(chart.project)},
    {"Diagrams of the drawing board", board_options, PLACE(chart)},
    {"Overlay", overlay_options, PLACE(chart.choice.board.overlay)},
    {"Scale model", model_options, PLACE(chart.choice.model)},
    {"Plan of a moment", pp_moment_when_option, PLACE(moment)},
    {"Availability", pp_light_options, PLACE(chart.choice.availability)},
    {"Availability", pp_working_time_options, PLACE(chart.choice.availability)},
    {"Availability", pp_illuminance_options, PLACE(chart.choice.availability)},
    PP_ROOM_CHOICE_GROUPS("Calculation", PLACE(room)),
    PP_ROOM_SIMULATION_GROUPS(PLACE(room)),
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_chart_options(void *values)
{
    *(struct chart_command *)values = (struct chart_command){
        .room = pp_room_options_none,
        .chart = {.paper = PAPER_UNSAID,
                  .choice.availability = pp_year_options_default}};
}

static enum pp_status check_chart_options(void *values, char **words, int word_count,
                                          struct pp_error *err)
{
    struct chart_command *command = values;
    struct pp_room_options *options = &command->room;
    struct pp_chart_words *chart = &command->chart;
    if (chart->list)
        return PP_OK;
    if (word_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a kind of chart; use --list to see all kinds");
    const struct pp_chart_kind *kind = command->kind = find_kind(words[0], err);
    if (!kind)
        return PP_BAD_INPUT;
    if (word_count == 1 && !kind->board && !kind->outside)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (chart->paper == PAPER_UNSAID)
        chart->paper = kind->paper;
    if (chart->choice.model.typed && kind != &pp_draw_model_net)
        return pp_fail(err, PP_BAD_INPUT, "%s is for a model-net only",
                       chart->choice.model.typed);
    if (chart->before && !kind->compares)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s cannot compare two states; --before is for a plan, a site, "
                       "an elevation or a sun path",
                       kind->name);
    if (chart->choice.site.french_m > 0.0 && !kind->of_site
        && kind != &pp_draw_vertical_sky)
        return pp_fail(err, PP_BAD_INPUT,
                       "--vsc-point-french is for a site, an elevation or a diagram of "
                       "the vertical sky component");
    if (chart->choice.cut.kind != PP_SECTION_OF_ROOM && kind != &pp_draw_section
        && kind != &pp_draw_plan)
        return pp_fail(err, PP_BAD_INPUT, "--cut is for a section or a plan");
    if (chart->choice.cut.kind != PP_SECTION_OF_ROOM && kind == &pp_draw_section
        && options->study.points.count > 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--cut and --points cannot be combined; expected only one of them");
    if (chart->choice.line_said && kind != &pp_draw_plan)
        return pp_fail(err, PP_BAD_INPUT, "--line is for a plan only");
    chart->before_is_state = !chart->before || strcmp(chart->before, "existing") == 0;
    if (chart->logarithmic && chart->linear)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--log and --linear cannot be combined; expected only one of them");
    chart->choice.scale = chart->logarithmic ? PP_SCALE_LOG
                          : chart->linear    ? PP_SCALE_LINEAR
                                             : PP_SCALE_AS_FITS;
    enum pp_status status =
        pp_moment_plan_options_settle(&command->moment, chart, options, kind, err);
    if (status == PP_OK)
        status = pp_room_options_settle(options, err);
    if (status == PP_OK)
        status = check_light(&chart->choice.availability, options, kind, word_count - 1,
                             err);
    if (status == PP_OK && options->study.methods)
        status = pp_selection_check(options->study.methods, err);
    if (status == PP_OK && kind->check)
        status = kind->check(options->study.methods, options->study.simulate, err);
    if (status == PP_OK && kind->board)
        status = pp_board_options_check(&chart->choice.board, options, kind,
                                        word_count == 1, err);
    return status;
}

static enum pp_exit run_chart(void *values, char **words, int word_count)
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
    enum pp_exit exit_status = pp_availability_options_load(
        &command->chart.choice.availability, command->room.study.strict);
    if (exit_status == PP_EXIT_DONE && pp_moment_choice_said(&command->moment)) {
        exit_status =
            pp_moment_choice_load(&command->moment, command->room.study.strict);
        command->source = pp_moment_choice_source(&command->moment);
        command->chart.choice.moment = &command->source;
    }
    return exit_status == PP_EXIT_DONE
               ? pp_chart_run(command->kind, &command->room, &command->chart, words + 1,
                              word_count - 1)
               : exit_status;
}

static void clear_chart_options(void *values)
{
    struct chart_command *command = values;
    pp_moment_choice_clear(&command->moment);
    pp_availability_options_clear(&command->chart.choice.availability);
    pp_sky_picture_release(command->chart.choice.board.picture);
    pp_room_options_clear(&command->room);
}

const struct pp_command pp_command_chart = {
    .name = "chart",
    .summary = "a chart of a room as PDF, SVG or PNG",
    .operands = "KIND [FILE...]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct chart_command),
    .more_help = help_on_kinds,
    .init = init_chart_options,
    .check = check_chart_options,
    .run = run_chart,
    .clear = clear_chart_options,
    .words_before_files = 1,
};
