/* cmd_atlas.c - the command atlas: errors of all methods relative to simulation, over
 * thousands of designed rooms. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "charts/atlas_chart.h"
#include "charts/sheet/canvas.h"
#include "cli/atlas/atlas_sweep.h"
#include "cli/chart/sheet_options.h"
#include "cli/command.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/watch.h"
#include "model/base/text.h"
#include "reports/atlas/atlas_bands_csv.h"
#include "reports/atlas/atlas_bands_text.h"
#include "reports/atlas/band_pages.h"
#include "studies/research/atlas/atlas_mapping.h"

static const char about[] =
    "Simulates a series of systematically varied rooms, and the simplified rooms "
    "that hand methods assume. Writes the figures of each method next to the "
    "simulated ones as CSV, one row per point. Rooms already in FILE are not "
    "simulated again, so the same command continues an interrupted run, and you can "
    "add rooms later. The same rooms give an identical file for any number of runs "
    "and threads.";

/* A map of an atlas for a sheet of paper. */
struct map_sheet {
    enum pp_atlas_mapping_kind kind;
    const char *method; /* not owned */
    enum pp_paper paper;
};

struct atlas_options {
    struct pp_room_options room; /* options used: error, seed, threads, output, quiet */
    long rooms;                  /* 0: not given */
    const char *number;          /* number of the room whose room file is requested;
                                  * NULL: none */
    enum pp_atlas_sky sky;
    bool by_hand, bands, try_bands, accuracy;
    bool map; /* draw the map selected by sheet.kind */
    struct map_sheet sheet;
};

/* ---- a room's file ---- */

static enum pp_exit print_atlas_room(const struct atlas_options *options)
{
    char xml[PP_ATLAS_XML];
    struct pp_atlas_design design;
    struct pp_output output;
    struct pp_error err = {0};
    pp_atlas_design_init(&design, options->sky);
    pp_atlas_design_room(&design, (uint32_t)strtoul(options->number, NULL, 10), xml);
    enum pp_status status = pp_output_open(&output, options->room.output, &err);
    if (status == PP_OK)
        fputs(xml, output.stream);
    status = pp_output_close(&output, status, &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

/* ---- a map ---- */

static enum pp_status draw_atlas_map(const struct pp_atlas_map *map,
                                     enum pp_paper paper, enum pp_chart_format format,
                                     FILE *out, struct pp_error *err)
{
    char title[96];
    snprintf(title, sizeof title, "Error of %.80s", map->column);
    const struct pp_sheet sheet = {
        .format = format,
        .paper = paper,
        .landscape = true,
        .title = title,
        .description =
            "ratio of hand figure to simulated figure, for rooms of an atlas"};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status = pp_atlas_chart_draw(canvas, map, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}

/* Draws a map of the atlas as PDF, SVG or PNG, depending on the extension of
 * `output`. */
static enum pp_exit write_map(const struct map_sheet *sheet, const char *path,
                              const char *output)
{
    enum pp_chart_format format;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    struct pp_output file;
    struct pp_error err = {0};
    if (pp_canvas_format_of(&format, output, &err) != PP_OK)
        return pp_message_usage("atlas", &err);
    enum pp_status status = pp_atlas_table_read(&table, path, &err);
    if (status == PP_OK)
        status = pp_atlas_mapping_of(&map, &table, sheet->kind, sheet->method, &err);
    if (status == PP_OK) {
        status = pp_output_open(&file, output, &err);
        if (status == PP_OK)
            status = draw_atlas_map(&map, sheet->paper, format, file.stream, &err);
        status = pp_output_close(&file, status, &err);
    }
    pp_atlas_table_clear(&table);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

/* ---- bands ---- */

/* Bands fitted to the atlas at `path`. table: print the bands as a table; false: print
 * the results of their test on held-out rooms. */
struct bands_run {
    const char *path;
    bool table;
    struct pp_atlas_bands bands;
};

static enum pp_status compute_bands(void *data, struct pp_error *err)
{
    struct bands_run *run = data;
    struct pp_atlas_table table;
    enum pp_status status = pp_atlas_table_read(&table, run->path, err);
    if (status == PP_OK)
        status = pp_atlas_bands_fit(&run->bands, &table, err);
    if (status == PP_OK && run->bands.column_count == 0)
        status = pp_fail(
            err, PP_BAD_INPUT,
            "%s: %d rooms are too few for bands; expected at least %d for each method",
            run->path, run->bands.rooms, pp_band_tree_rules.rooms_least);
    pp_atlas_table_clear(&table);
    return status;
}

static enum pp_status print_bands(const void *data, FILE *out, struct pp_error *err)
{
    const struct bands_run *run = data;
    (void)err;
    if (run->table)
        pp_atlas_bands_csv(&run->bands, out);
    else
        pp_atlas_bands_text(&run->bands, out);
    return PP_OK;
}

/* Writes the bands of an atlas in the format of tables/atlas_bands.csv. output NULL:
 * standard output. */
static enum pp_exit write_bands(const char *path, const char *output)
{
    struct bands_run run = {.path = path, .table = true};
    enum pp_exit result =
        pp_job_run(&(struct pp_job){output, compute_bands, print_bands, NULL, &run});
    pp_atlas_bands_clear(&run.bands);
    return result;
}

/* Tests bands derived from half of the rooms of an atlas on the other half, and prints
 * the result. PP_EXIT_INPUT if in any regime the fraction of rooms inside the band
 * differs from 95 % by more than chance explains. */
static enum pp_exit try_bands(const char *path, const char *output)
{
    struct bands_run run = {.path = path};
    enum pp_exit result =
        pp_job_run(&(struct pp_job){output, compute_bands, print_bands, NULL, &run});
    int outside = pp_atlas_bands_outside(&run.bands);
    if (result == PP_EXIT_DONE && outside > 0) {
        pp_message("regimes in which the share of rooms inside the band differs "
                   "from 95 %% by more than chance explains: %d",
                   outside);
        result = PP_EXIT_INPUT;
    }
    pp_atlas_bands_clear(&run.bands);
    return result;
}

static enum pp_status compute_nothing(void *data, struct pp_error *err)
{
    (void)data, (void)err;
    return PP_OK;
}

static enum pp_status print_pages(const void *data, FILE *out, struct pp_error *err)
{
    (void)data, (void)err;
    pp_band_pages(out);
    return PP_OK;
}

/* Prints the compiled-in bands as Markdown. */
static enum pp_exit write_accuracy_pages(const char *output)
{
    return pp_job_run(
        &(struct pp_job){output, compute_nothing, print_pages, NULL, NULL});
}

/* ---- the command line ---- */

static enum pp_status read_sky(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "overcast") != 0 && strcmp(text, "iso") != 0)
        return pp_fail(err, PP_BAD_INPUT, "overcast or iso");
    *(enum pp_atlas_sky *)place =
        strcmp(text, "iso") == 0 ? PP_ATLAS_ISO : PP_ATLAS_OVERCAST;
    return PP_OK;
}

static enum pp_status read_rooms_option(const char *text, void *place,
                                        struct pp_error *err)
{
    double number;
    if (!pp_text_parse_number(text, &number) || number < 0.0 || number >= PP_ATLAS_MOST
        || number != floor(number))
        return pp_fail(err, PP_BAD_INPUT, "the number of a room, 0 to %d",
                       PP_ATLAS_MOST - 1);
    *(const char **)place = text;
    return PP_OK;
}

static enum pp_status read_map(const char *text, void *place, struct pp_error *err)
{
    struct atlas_options *options = place;
    for (int i = 0; i < PP_MAP_KINDS; i++)
        if (strcmp(text, pp_atlas_mapping_names[i]) == 0) {
            options->map = true;
            options->sheet.kind = (enum pp_atlas_mapping_kind)i;
            return PP_OK;
        }
    char names[128];
    return pp_fail(
        err, PP_BAD_INPUT, "%s",
        pp_text_list_names(names, sizeof names, pp_atlas_mapping_names, PP_MAP_KINDS));
}

#define PLACE(member) offsetof(struct atlas_options, member)

static const struct pp_option sweep_options[] = {
    {"rooms", 'n', "N", "Write the first N rooms of the series to FILE.",
     pp_options_read_count, PLACE(rooms)},
    {"room", 0, "NUMBER", "Print the room file of this room; rooms are counted from 0.",
     read_rooms_option, PLACE(number)},
    {"by-hand", 0, NULL,
     "Recalculate the hand methods in the atlas FILE and add new ones; the "
     "simulated figures do not change.",
     NULL, PLACE(by_hand)},
    {"bands", 0, NULL,
     "Write the bands of the atlas FILE, by method and regime, as the table that is "
     "compiled into the program.",
     NULL, PLACE(bands)},
    {"try", 0, NULL,
     "Fit bands to half of the rooms in the atlas FILE and print how well they fit the "
     "other half.",
     NULL, PLACE(try_bands)},
    {"accuracy", 0, NULL, "Print the compiled-in bands as Markdown.", NULL,
     PLACE(accuracy)},
    {"sky", 0, "SKY",
     "overcast (default), or iso: one of the ISO 15469 skies for each room.", read_sky,
     PLACE(sky)},
    {0},
};

static const struct pp_option map_options[] = {
    {"map", 0, "BY",
     "Draw a map of the atlas FILE to -o FILE.pdf, FILE.svg or FILE.png. It shows the "
     "ratio of hand to simulated figures. BY is depth (depth of the point and "
     "proportion of the room), erc (share of the externally reflected component in the "
     "direct component), ground, reflectance or obstruction.",
     read_map, 0},
    {"method", 0, "NAME",
     "Column of the atlas for the map, such as exact+bre, average-df or erc.exact "
     "(default exact+bre).",
     pp_options_read_text, PLACE(sheet.method)},
    {"paper", 0, "SIZE", "Paper size for the map: a5, a4 (default), a3 or a2.",
     pp_sheet_options_read_paper, PLACE(sheet.paper)},
    {0},
};

static const struct pp_option stop_option[] = {
    {"error", 0, "E%",
     "Simulate until the standard error of every daylight factor is below this "
     "share of the daylight factor, or below 0.002 percentage points (default 1%).",
     pp_options_read_per_cent, PLACE(room.study.error)},
    {0},
};

static const struct pp_option_group groups[] = {
    {"Rooms", sweep_options, 0},
    {"Map", map_options, 0},
    {"Simulation", stop_option, 0},
    {"Simulation", pp_room_seed_options, PLACE(room)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_atlas_options(void *values)
{
    *(struct atlas_options *)values = (struct atlas_options){
        .room = pp_room_options_none, .sheet.method = "exact+bre"};
}

/* Checks that exactly one use of the command is requested, and that an atlas is given
 * if this use reads one. */
static enum pp_status check_use(const struct atlas_options *options, int files,
                                struct pp_error *err)
{
    bool of_file =
        options->by_hand || options->bands || options->try_bands || options->map;
    int uses = (options->rooms > 0) + (options->number != NULL) + options->by_hand
               + options->bands + options->try_bands + options->accuracy + options->map;
    if (uses != 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected one of --rooms N -o FILE, --room NUMBER, --by-hand "
                       "FILE, --map BY FILE -o CHART, --bands FILE, --try FILE, and "
                       "--accuracy");
    if (of_file != (files == 1) || files > 1)
        return pp_fail(
            err, PP_BAD_INPUT,
            of_file
                ? "expected one file: an atlas"
                : "the atlas has its own rooms; expected no file except the one for "
                  "-o");
    return PP_OK;
}

static enum pp_status check_atlas_options(void *values, char **operands, int count,
                                          struct pp_error *err)
{
    struct atlas_options *options = values;
    const char *output = options->room.output;
    (void)operands;
    enum pp_status status = check_use(options, count, err);
    if (status != PP_OK)
        return status;
    if (options->rooms > PP_ATLAS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "--rooms: expected at most %d",
                       PP_ATLAS_MOST);
    if (options->rooms > 0 && (!output || strcmp(output, "-") == 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the atlas is written to a file; expected -o FILE");
    if (options->map && (!output || strcmp(output, "-") == 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--map writes a chart; expected -o FILE.pdf, .svg or .png");
    if (!(options->room.study.error > 0.0))
        options->room.study.error = 0.01;
    return PP_OK;
}

static enum pp_exit run_atlas(void *values, char **operands, int count)
{
    struct atlas_options *options = values;
    const struct pp_study_options *study = &options->room.study;
    struct pp_terminal_watch watch;
    (void)count;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    if (options->number)
        return print_atlas_room(options);
    if (options->bands)
        return write_bands(operands[0], options->room.output);
    if (options->try_bands)
        return try_bands(operands[0], options->room.output);
    if (options->accuracy)
        return write_accuracy_pages(options->room.output);
    if (options->map)
        return write_map(&options->sheet, operands[0], options->room.output);
    if (options->by_hand)
        return pp_atlas_sweep_anew(operands[0], &options->room);
    return pp_atlas_sweep_on(
        &(struct pp_atlas_making){options->sky, {study->error, study->seed}},
        (int)options->rooms, &options->room);
}

static void clear_atlas_options(void *values)
{
    struct atlas_options *options = values;
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_atlas = {
    .name = "atlas",
    .summary = "errors of each hand method in thousands of rooms",
    .operands = "[FILE]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct atlas_options),
    .init = init_atlas_options,
    .check = check_atlas_options,
    .run = run_atlas,
    .clear = clear_atlas_options,
    .uses_ranks = true,
    .ranks_place = PLACE(room.ranks),
};
