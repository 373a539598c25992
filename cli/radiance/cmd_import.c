/* cmd_import.c - the command import: reads the scene of another program, and simulates
 * sensors in the scene. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/terminal.h"
#include "cli/command.h"
#include "cli/format_option.h"
#include "cli/interrupt.h"
#include "cli/message.h"
#include "cli/job.h"
#include "model/base/array.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "reports/import_report.h"
#include "cli/progress.h"
#include "cli/room_options.h"
#include "cli/radiance/import_building.h"
#include "model/base/clock.h"
#include "model/light/scene_horizontal.h"
#include "simulate/scene/light_scene_of_description.h"
#include "simulate/transport/sensors.h"

static const char about[] =
    "Reads a Radiance scene and simulates sensor points in it by path tracing: "
    "irradiance, illuminance, and the daylight factor relative to the open ground. "
    "SCENE files are read in order, as if they were one file; - is standard input. "
    "Lines that begin with \"!\" (gensky, genbox, xform) are interpreted; no other "
    "program is run. Without --points-file, the command prints a summary of the scene. "
    "A gbXML file, recognised by its first character, is converted to a room file. "
    "Missing data, and the defaults used instead, are listed on standard error.";

/* Maximum number of paths per point in each randomisation. */
static const long MOST_SAMPLES = 1 << 26;

/* Time (s) between checks of time limit, interrupt and progress bar. */
static const double slice_s = 0.1;

struct import_options {
    struct pp_room_options room;
    const char *points_file; /* NULL: none */
    bool summary;
    bool by_chance; /* no next-event estimation: concentrated sources are found only by
                     * rays that happen to hit them */
    enum pp_format format;
};

static enum pp_status read_lamps(const char *text, void *place, struct pp_error *err)
{
    bool by_chance = strcmp(text, "chance") == 0;
    if (!by_chance && strcmp(text, "aimed") != 0)
        return pp_fail(err, PP_BAD_INPUT, "aimed or chance");
    *(bool *)place = by_chance;
    return PP_OK;
}

static const struct pp_option import_options[] = {
    {"points-file", 0, "FILE",
     "File of sensor points, one line \"x y z dx dy dz\" each; - is standard input.",
     pp_options_read_input, offsetof(struct import_options, points_file)},
    {"lamps", 0, "HOW",
     "Sampling of light sources: aimed (default), or chance, which treats each source "
     "as a glow.",
     read_lamps, offsetof(struct import_options, by_chance)},
    {"summary", 0, NULL, "First print a summary of the scene.", NULL,
     offsetof(struct import_options, summary)},
    {0},
};

/* ---- sensor points: lines "x y z dx dy dz", in the format of rtrace ---- */

static const size_t FILE_MOST = (size_t)64 << 20;
enum { POINTS_MOST = 100000 };

/* Reads up to six numbers from a line, which is modified. Returns their number, or -1
 * if a word is not a number or there are more than six words. */
static int read_sensor_numbers(char *line, double numbers[6])
{
    int count = 0;
    for (char *rest = line, *word; (word = strsep(&rest, " \t\r,")) != NULL;) {
        if (*word == '\0')
            continue;
        if (count == 6 || !pp_text_parse_number(word, &numbers[count])
            || fabs(numbers[count]) > 1e9)
            return -1;
        count++;
    }
    return count;
}

static enum pp_status take_sensor_line(struct pp_sensor **list, int *count, int *space,
                                       char *text, const char *file, int line,
                                       struct pp_error *err)
{
    double n[6];
    text += strspn(text, " \t\r");
    if (*text == '#' || *text == '\0')
        return PP_OK;
    int words = read_sensor_numbers(text, n);
    if (words != 6)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: expected six numbers, x y z dx dy dz", file, line);
    struct pp_vec3 normal = pp_vec(n[3], n[4], n[5]);
    double length = pp_vec_length(normal);
    if (!(length > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s:%d: the direction is 0 0 0; expected at least one "
                       "number that is not 0",
                       file, line);
    if (*count == POINTS_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%.200s:%d: more than %d points", file, line,
                       POINTS_MOST);
    if (pp_array_reserve(list, space, *count + 1, sizeof **list, err) != PP_OK)
        return PP_SYSTEM;
    (*list)[(*count)++] = (struct pp_sensor){pp_vec(n[0], n[1], n[2]),
                                             pp_vec_scale(normal, 1.0 / length), line};
    return PP_OK;
}

/* Reads the file ("-": standard input). The caller frees *list. Empty lines and lines
 * that begin with "#" are skipped; directions are normalised. PP_BAD_INPUT for any
 * other line, with the line number, and for a file without points. */
static enum pp_status read_sensor_points(struct pp_sensor **list, int *count,
                                         const char *path, struct pp_error *err)
{
    char *points;
    size_t length;
    *list = NULL;
    *count = 0;
    enum pp_status status = pp_read_file(&points, &length, path, FILE_MOST, err);
    if (status != PP_OK)
        return status;
    const char *file = pp_read_file_title(path);
    if (strlen(points) != length)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%.200s: the file has a NUL byte; expected text", file);
    int space = 0, line = 1;
    for (char *rest = points, *text; status == PP_OK && (text = strsep(&rest, "\n"));)
        status = take_sensor_line(list, count, &space, text, file, line++, err);
    if (status == PP_OK && *count == 0)
        status = pp_fail(
            err, PP_BAD_INPUT,
            "%.200s: the file has no points; expected lines of x y z dx dy dz", file);
    free(points);
    if (status != PP_OK) {
        free(*list);
        *list = NULL;
        *count = 0;
    }
    return status;
}

/* ---- simulation ---- */

/* Runs until all sensors are finished, the time limit is reached, or the user
 * interrupts. */
static enum pp_status trace_import_sensors(struct pp_sensors *sensors,
                                           struct pp_imported *imported,
                                           const struct pp_room_options *options,
                                           struct pp_error *err)
{
    enum pp_status status = PP_OK;
    struct pp_progress progress;
    pp_progress_begin(&progress, "sensors", options->quiet);
    imported->finished = true;
    while (status == PP_OK && !pp_sensors_done(sensors)) {
        if (pp_interrupt_came()) {
            imported->finished = false;
            break;
        }
        double spent = pp_clock_s() - progress.started_s, slice = slice_s;
        if (options->study.seconds > 0.0) {
            imported->by_clock = spent >= options->study.seconds;
            if (imported->by_clock)
                break;
            slice = fmin(slice, options->study.seconds - spent);
        }
        status = pp_sensors_advance(sensors, slice, err);
        double done = pp_sensors_progress(sensors);
        if (options->study.seconds > 0.0)
            done = fmax(done, spent / options->study.seconds);
        pp_progress_show(&progress, done, pp_sensors_error(sensors));
    }
    pp_progress_end(&progress);
    return status;
}

static enum pp_status simulate_import(struct pp_imported *imported,
                                      struct pp_sensor_reading *readings,
                                      const struct pp_room_options *options,
                                      bool by_chance, struct pp_error *err)
{
    struct pp_light_scene *scene;
    enum pp_status status = pp_light_scene_of_description(&scene, imported->scene, err);
    if (status != PP_OK)
        return status;
    const struct pp_sensors_options wanted = {
        .error = options->study.error,
        .samples = options->study.samples,
        .seed = options->study.seed,
        .threads = options->study.threads,
        .horizontal = pp_rgb_luminance(imported->horizontal),
        .by_chance = by_chance};
    struct pp_sensors *sensors;
    status = pp_sensors_create(&sensors, scene, NULL, imported->points, imported->count,
                               &wanted, err);
    if (status == PP_OK) {
        pp_interrupt_watch();
        status = trace_import_sensors(sensors, imported, options, err);
        for (int i = 0; i < imported->count; i++)
            readings[i] = pp_sensors_read(sensors, i);
        imported->readings = readings;
        pp_sensors_destroy(sensors);
    }
    pp_light_scene_destroy(scene);
    return status;
}

/* ---- the command ---- */

struct import_run {
    const struct import_options *options;
    struct pp_imported imported;
    struct pp_scene_description scene;
    struct pp_sensor *points;
    struct pp_sensor_reading *readings;
};

static enum pp_status read_all(struct import_run *run, struct pp_error *err)
{
    struct pp_imported *imported = &run->imported;
    enum pp_status status = PP_OK;
    if (run->options->points_file)
        status = read_sensor_points(&run->points, &imported->count,
                                    run->options->points_file, err);
    imported->points = run->points;
    if (status == PP_OK)
        status = pp_rad_read(&run->scene, &imported->summary,
                             (const char *const *)imported->files, imported->file_count,
                             err);
    if (status != PP_OK)
        return status;
    imported->scene = &run->scene;
    imported->horizontal = pp_scene_horizontal(&run->scene);
    return PP_OK;
}

static enum pp_status compute_import(void *data, struct pp_error *err)
{
    struct import_run *run = data;
    enum pp_status status = read_all(run, err);
    if (status == PP_OK && run->scene.shape_count == 0
        && run->scene.material_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the scene is empty; expected at least one primitive",
                       pp_read_file_title(run->imported.files[0]));
    if (status != PP_OK || !run->points)
        return status;
    run->readings = calloc((size_t)run->imported.count + 1, sizeof *run->readings);
    return run->readings
               ? simulate_import(&run->imported, run->readings, &run->options->room,
                                 run->options->by_chance, err)
               : pp_fail_memory(err);
}

static enum pp_status print_import(const void *data, FILE *out, struct pp_error *err)
{
    const struct import_run *run = data;
    return pp_import_report(&run->imported, run->options->format,
                            pp_terminal_width(run->options->room.output),
                            pp_terminal_utf8(), out, err);
}

static bool import_is_finished(const void *data)
{
    const struct import_run *run = data;
    return !run->imported.readings || run->imported.finished;
}

/* True if one of the files is XML, that is, a building instead of a scene. */
static bool is_building(char **files, int file_count)
{
    for (int i = 0; i < file_count; i++)
        if (pp_import_building_is(files[i]))
            return true;
    return false;
}

static enum pp_exit run_import(void *values, char **files, int file_count)
{
    const struct import_options *options = values;
    if (is_building(files, file_count))
        return pp_import_building_run(files[0], options->room.output,
                                      options->room.quiet);
    struct import_run run = {
        .options = options,
        .imported = {.files = files,
                     .file_count = file_count,
                     .summarised = options->summary || !options->points_file}};
    pp_scene_description_init(&run.scene);
    enum pp_exit exit_status = pp_job_run(&(struct pp_job){
        options->room.output, compute_import, print_import, import_is_finished, &run});
    pp_scene_description_clear(&run.scene);
    free(run.points);
    free(run.readings);
    return exit_status;
}

static enum pp_status check_building(const struct import_options *options,
                                     int file_count, struct pp_error *err)
{
    const char *stray = options->points_file                ? "--points-file"
                        : options->summary                  ? "--summary"
                        : options->by_chance                ? "--lamps"
                        : options->format != PP_FORMAT_TEXT ? "--format"
                                                            : NULL;
    if (stray)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s is for Radiance scenes, but a gbXML file is converted to a room file",
            stray);
    if (file_count > 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "a gbXML file cannot be combined with other files; expected "
                       "only the gbXML file");
    return PP_OK;
}

static enum pp_status check_import_options(void *values, char **files, int file_count,
                                           struct pp_error *err)
{
    struct import_options *options = values;
    struct pp_room_options *room_options = &options->room;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a scene file, or - for standard input");
    if (is_building(files, file_count))
        return check_building(options, file_count, err);
    if (room_options->study.samples > MOST_SAMPLES)
        return pp_fail(err, PP_BAD_INPUT, "--samples is %ld; expected at most %ld",
                       room_options->study.samples, MOST_SAMPLES);
    if (!options->points_file && options->format == PP_FORMAT_CSV)
        return pp_fail(err, PP_BAD_INPUT,
                       "a summary cannot be CSV; expected --points-file, or --format "
                       "text or json");
    room_options->study.simulate = true;
    return pp_room_options_settle(room_options, err);
}

static const struct pp_option_group groups[] = {
    {"Calculation", import_options, 0},
    PP_ROOM_STOP_GROUPS(offsetof(struct import_options, room)),
    {"Output", pp_format_option, offsetof(struct import_options, format)},
    {"Output", pp_room_output_options, offsetof(struct import_options, room)},
    {0},
};

static void init_import_options(void *values)
{
    *(struct import_options *)values =
        (struct import_options){.room = pp_room_options_none};
}

static void clear_import_options(void *values)
{
    struct import_options *options = values;
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_import = {
    .name = "import",
    .summary = "simulate points in a Radiance scene; convert gbXML to a room file",
    .operands = "SCENE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct import_options),
    .init = init_import_options,
    .check = check_import_options,
    .run = run_import,
    .clear = clear_import_options,
};
