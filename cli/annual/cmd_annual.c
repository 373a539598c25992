/* cmd_annual.c - the command annual: daylight in every hour of a year. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/annual/annual_methods.h"
#include "cli/annual/annual_stores.h"
#include "cli/annual/blinds_option.h"
#include "cli/annual/lighting_option.h"
#include "cli/availability/availability_options.h"
#include "cli/command.h"
#include "cli/format_option.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/rooms.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/light/sky_patches.h"
#include "reports/annual/annual_csv.h"
#include "reports/annual/annual_hourly.h"
#include "reports/annual/annual_json.h"
#include "reports/annual/annual_text.h"
#include "reports/annual/lighting_report.h"
#include "studies/year/annual.h"

static const char about[] =
    "Simulates the daylight of a room in every hour of a weather file. Shows daylight "
    "autonomy, useful daylight illuminance, sDA and ASE to LM-83-12 with the blinds of "
    "that standard, and the levels of EN 17037 by its method 2. Results are for the "
    "reference points and for the whole grid, with standard errors. --lighting adds "
    "the electric light saved by daylight. FILE is a room "
    "file; - is standard input.";

struct annual_options {
    struct pp_room_options room;
    struct pp_year_options light;
    struct pp_annual_options annual;
    struct pp_annual_methods methods;
    double sun_shift_min; /* NAN: auto */
    bool leap_day;
    struct pp_blinds_choice blinds;
    const char *hourly;
    struct pp_annual_stores stores;
    struct pp_lighting_choice lighting;
    struct part_of_rooms {
        int number, count; /* calculate part `number` (from 1) of `count` parts of the
                            * rooms; count 0: all rooms */
    } part;
    enum pp_format format;
};

/* State of one run of the command. */
struct annual_run {
    struct annual_options *options;
    const struct pp_rooms *rooms;
    struct pp_weather_year year;
    struct pp_annual_results results;
};

/* ---- the work ---- */

static enum pp_status read_year(struct annual_run *run, struct pp_error *err)
{
    const struct annual_options *options = run->options;
    struct pp_weather_options weather = {.sun_shift_h = options->sun_shift_min / 60.0,
                                         .leap_day = options->leap_day};
    return pp_weather_year_of_epw(&run->year, options->light.epw, &weather,
                                  pp_read_file_title(options->light.weather), err);
}

static void settle_annual(struct annual_run *run)
{
    struct annual_options *options = run->options;
    const struct pp_study_options *study = &options->room.study;
    struct pp_annual_options *annual = &options->annual;
    annual->hours = options->light.hours.list[0];
    annual->hours.days = options->light.days;
    annual->summer = options->light.summer.of_file
                         ? (struct pp_summer_time){options->light.epw->summer_from,
                                                   options->light.epw->summer_to}
                         : options->light.summer.time;
    annual->illuminance_count = options->light.illuminances.count;
    memcpy(annual->illuminances_lx, options->light.illuminances.lx,
           sizeof annual->illuminances_lx);
    annual->blinds = options->blinds.control == PP_BLINDS_LM83 && annual->exact_sky
                         ? PP_BLINDS_NEVER
                         : options->blinds.control;
    annual->schedule = options->blinds.schedule;
    annual->schedule_count = options->blinds.count;
    annual->measure = true;
    annual->coefficients = options->stores.matrix != NULL;
    pp_lighting_option_settle(annual, &options->lighting);
    annual->samples = (int)study->samples;
    annual->error = study->error > 0.0 ? study->error : 0.01; /* not with --samples */
    annual->seed = study->seed;
    annual->threads = study->threads;
    annual->strict = study->strict;
    annual->watch = study->watch;
}

static enum pp_status compute_room(struct annual_run *run,
                                   const struct pp_study_room *room,
                                   struct pp_annual_result *result,
                                   struct pp_error *err)
{
    result->file = room->file;
    const struct annual_options *options = run->options;
    enum pp_status status = pp_annual_of_study_room(&result->sheet, room, &run->year,
                                                    &options->annual, err);
    if (status != PP_OK || !result->sheet.finished || !options->methods.methods)
        return status;
    status = pp_hand_year_of_room(&result->hand, room, &run->year, &options->annual,
                                  &options->methods.options, err);
    result->sheet.finished = status == PP_OK && result->hand.finished;
    return status;
}

/* True if the room belongs to the part. Part K of N has rooms K, K + N, K + 2 N, ... */
static bool is_in_part(const struct part_of_rooms *part, int room)
{
    return part->count == 0 || room % part->count == part->number - 1;
}

static enum pp_status compute_annual(void *data, struct pp_error *err)
{
    struct annual_run *run = data;
    const struct pp_rooms *rooms = run->rooms;
    run->results.list = calloc((size_t)rooms->count, sizeof *run->results.list);
    if (!run->results.list)
        return pp_fail_memory(err);
    enum pp_status status = read_year(run, err);
    if (status != PP_OK)
        return status;
    status = pp_blinds_option_load(&run->options->blinds, run->year.count, err);
    if (status != PP_OK)
        return status;
    settle_annual(run);
    status = pp_annual_stores_open(&run->options->stores, &run->options->annual, err);
    pp_interrupt_watch();
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        if (!is_in_part(&run->options->part, i))
            continue;
        struct pp_annual_result *result = &run->results.list[run->results.count++];
        run->options->annual.room_number = i;
        status = compute_room(run, &rooms->list[i], result, err);
        if (status == PP_OK && !result->sheet.finished)
            break;
    }
    return status;
}

static enum pp_status print_annual(const void *data, FILE *out, struct pp_error *err)
{
    const struct annual_run *run = data;
    switch (run->options->format) {
    case PP_FORMAT_JSON:
        return pp_annual_json(&run->results, out, err);
    case PP_FORMAT_CSV:
        return pp_annual_csv(&run->results, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_annual_text(&run->results, pp_terminal_width(run->options->room.output),
                          pp_terminal_utf8(), out, err);
}

static bool annual_is_finished(const void *data)
{
    const struct annual_run *run = data;
    for (int i = 0; i < run->results.count; i++)
        if (!run->results.list[i].sheet.finished)
            return false;
    return true;
}

/* Writes an additional output file (`name`) for the first room. Does nothing if `name`
 * is NULL or the run was interrupted. The options allow such files for one room
 * only. */
static enum pp_exit write_further(const struct annual_run *run, const char *name,
                                  void (*put)(const struct pp_annual_sheet *sheet,
                                              const char *name, FILE *out))
{
    struct pp_output output;
    struct pp_error err = {0};
    if (!name || !annual_is_finished(run))
        return PP_EXIT_DONE;
    enum pp_status status = pp_output_open(&output, name, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    put(&run->results.list[0].sheet, name, output.stream);
    status = pp_output_close(&output, PP_OK, &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

static void put_hourly(const struct pp_annual_sheet *sheet, const char *name, FILE *out)
{
    pp_annual_hourly_put(sheet, pp_annual_hourly_of_name(name), out);
}

static void put_coefficients(const struct pp_annual_sheet *sheet, const char *name,
                             FILE *out)
{
    (void)name;
    pp_annual_hourly_put_matrix(sheet, out);
}

static void put_schedule(const struct pp_annual_sheet *sheet, const char *name,
                         FILE *out)
{
    (void)name;
    pp_lighting_report_schedule(sheet, out);
}

/* True if the hours are part of the JSON output, not in a file. */
static bool hours_are_json(const struct annual_options *options)
{
    return options->hourly
           && pp_annual_hourly_of_name(options->hourly) == PP_ANNUAL_HOURLY_JSON;
}

static enum pp_exit run_annual_of_rooms(struct annual_options *options,
                                        const struct pp_rooms *rooms)
{
    struct annual_run run = {
        .options = options,
        .rooms = rooms,
        .results = {.hourly = hours_are_json(options),
                    .several = rooms->several,
                    .more_than_one_file = rooms->more_than_one_file}};
    enum pp_exit exit_status = pp_job_run(&(struct pp_job){
        options->room.output, compute_annual, print_annual, annual_is_finished, &run});
    if (exit_status == PP_EXIT_DONE)
        exit_status = write_further(&run, run.results.hourly ? NULL : options->hourly,
                                    put_hourly);
    if (exit_status == PP_EXIT_DONE)
        exit_status = write_further(&run, options->stores.matrix, put_coefficients);
    if (exit_status == PP_EXIT_DONE)
        exit_status = write_further(&run, options->lighting.schedule, put_schedule);
    struct pp_error err = {0};
    if (pp_annual_stores_close(&options->stores, exit_status == PP_EXIT_DONE, &err)
        != PP_OK)
        exit_status = pp_message_error(&err);
    if (exit_status == PP_EXIT_INTERRUPTED && options->stores.checkpoint)
        pp_message("the same command continues from %s", options->stores.checkpoint);
    for (int i = 0; i < run.results.count; i++) {
        pp_annual_sheet_clear(&run.results.list[i].sheet);
        pp_hand_year_sheet_clear(&run.results.list[i].hand);
    }
    free(run.results.list);
    pp_weather_year_clear(&run.year);
    return exit_status;
}

/* First option given whose file is for one room only; NULL: none. */
static const char *of_one_room(const struct annual_options *options)
{
    return options->hourly && !hours_are_json(options) ? "--hourly"
           : options->stores.matrix                    ? "--coefficients"
           : options->stores.from                      ? "--coefficients-from"
           : options->lighting.schedule                ? "--schedule"
                                                       : NULL;
}

static enum pp_exit run_annual(void *values, char **files, int file_count)
{
    struct annual_options *options = values;
    struct pp_terminal_watch watch;
    struct pp_rooms rooms;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    enum pp_exit result =
        pp_availability_options_load(&options->light, options->room.study.strict);
    if (result == PP_EXIT_DONE)
        result = pp_rooms_load(&rooms, "annual", files, file_count, &options->room);
    if (result != PP_EXIT_DONE)
        return result;
    struct pp_error err = {0};
    if (options->part.number > rooms.count) {
        pp_fail(&err, PP_BAD_INPUT,
                "--part %d/%d: this part is empty, because there %s only %d room%s",
                options->part.number, options->part.count,
                rooms.count == 1 ? "is" : "are", rooms.count,
                rooms.count == 1 ? "" : "s");
        result = pp_message_error(&err);
    } else if (of_one_room(options) && rooms.count != 1) {
        pp_fail(&err, PP_BAD_INPUT,
                "%s is for one room, but there are %d; expected --room NAME",
                of_one_room(options), rooms.count);
        result = pp_message_error(&err);
    } else if (pp_annual_methods_check_rooms(&options->methods, &rooms, &err)
               != PP_OK) {
        result = pp_message_usage("annual", &err);
    } else {
        result = run_annual_of_rooms(options, &rooms);
    }
    pp_rooms_clear(&rooms);
    return result;
}

/* ---- the command line ---- */

static enum pp_status read_shift(const char *text, void *place, struct pp_error *err)
{
    double minutes;
    if (strcmp(text, "auto") == 0) {
        *(double *)place = NAN;
        return PP_OK;
    }
    if (!pp_text_parse_number(text, &minutes) || fabs(minutes) > 720.0)
        return pp_fail(err, PP_BAD_INPUT, "auto, or minutes from -720 to 720");
    *(double *)place = minutes;
    return PP_OK;
}

static enum pp_status read_patches(const char *text, void *place, struct pp_error *err)
{
    struct pp_sky_patches patches;
    double count;
    if (!pp_text_parse_number(text, &count)
        || !pp_sky_patches_init(&patches, (int)count, 0.0) || count != patches.count)
        return pp_fail(err, PP_BAD_INPUT, "145, 577 or 2305");
    *(int *)place = (int)count;
    return PP_OK;
}

static enum pp_status read_part(const char *text, void *place, struct pp_error *err)
{
    double v[2];
    struct part_of_rooms *part = place;
    if (pp_options_numbers(text, '/', v, 2) != 2 || v[0] != floor(v[0])
        || v[1] != floor(v[1]) || !(v[0] >= 1.0 && v[0] <= v[1] && v[1] <= 100000.0))
        return pp_fail(err, PP_BAD_INPUT, "K/N with K from 1 to N, such as 1/4");
    *part = (struct part_of_rooms){(int)v[0], (int)v[1]};
    return PP_OK;
}

static enum pp_status read_hourly(const char *text, void *place, struct pp_error *err)
{
    if (pp_annual_hourly_of_name(text) == PP_ANNUAL_HOURLY_NONE)
        return pp_fail(err, PP_BAD_INPUT,
                       "a file name that ends with .csv, .ill or .npy, or json");
    if (pp_annual_hourly_of_name(text) == PP_ANNUAL_HOURLY_JSON) {
        *(const char **)place = text;
        return PP_OK;
    }
    return pp_options_read_output(text, place, err);
}

#define PLACE(member) offsetof(struct annual_options, member)

static const struct pp_option weather_options[] = {
    {"weather", 'w', "FILE.epw",
     "Weather file in EnergyPlus format, required; - is standard input.",
     pp_options_read_input, PLACE(light.weather)},
    {"sun-shift", 0, "auto|MIN",
     "Minutes to add to the middle of each record to obtain the time of the sun "
     "position; auto (default) derives them from the radiation in clear hours of "
     "the file.",
     read_shift, PLACE(sun_shift_min)},
    {"leap-day", 0, NULL, "Keep the records of 29 February.", NULL, PLACE(leap_day)},
    {0},
};

static const struct pp_option result_options[] = {
    {"blinds", 0, "lm83|always|never",
     "Operation of the room's blinds, screens and curtains, for the figures with "
     "blinds: as in LM-83-12 (default, required for sDA), always closed, or never "
     "(none). With lm83, windows without any have the blind of LM-83.",
     pp_blinds_option_read, PLACE(blinds)},
    {"blinds-schedule", 0, "FILE.csv",
     "Instead of --blinds: closed in the hours of a file with a line for each record "
     "of the weather file, whose last field is 1 (closed) or 0 (open).",
     pp_options_read_input, PLACE(blinds.file)},
    {"hourly", 0, "FILE|json",
     "Also write the illuminances of all hours to FILE.csv, FILE.ill (DAYSIM format) "
     "or FILE.npy (NumPy format). json: add them to the output of --format json.",
     read_hourly, PLACE(hourly)},
    {"part", 0, "K/N",
     "Simulate only rooms K, K + N, K + 2 N and so on. Parts 1/N to N/N together cover "
     "all rooms, so several machines or runs can share the work.",
     read_part, PLACE(part)},
    {0},
};

static const struct pp_option method_options[] = {
    {"patches", 0, "N", "Number of sky patches: 145, 577 (default) or 2305.",
     read_patches, PLACE(annual.patches)},
    {"exact-sky", 0, NULL,
     "Evaluate the sky and sun of each hour at the end of every path, without patches "
     "and cells. This reference calculation is slow and does not include the blinds of "
     "LM-83. --samples sets its number of paths (default 128).",
     NULL, PLACE(annual.exact_sky)},
    {0},
};

static const struct pp_option_group groups[] = {
    {"External light and working hours", weather_options, 0},
    {"External light and working hours", pp_working_time_options, PLACE(light)},
    {"Calculation", pp_illuminance_options, PLACE(light)},
    {"Calculation", result_options, 0},
    {"Calculation", pp_annual_stores_options, PLACE(stores)},
    {"Calculation", pp_room_points_option, PLACE(room)},
    {"Calculation", pp_room_sky_options, PLACE(room)},
    {"Hand methods", pp_annual_methods_options, PLACE(methods)},
    {"Electric light", pp_lighting_options, PLACE(lighting)},
    {"Simulation", method_options, 0},
    {"Simulation", pp_room_stop_options, PLACE(room)},
    {"Simulation", pp_room_seed_options, PLACE(room)},
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_annual_options(void *values)
{
    struct annual_options *options = values;
    *options = (struct annual_options){.room = pp_room_options_none,
                                       .light = pp_year_options_default,
                                       .annual = {.patches = 577},
                                       .blinds = {.control = PP_BLINDS_LM83},
                                       .sun_shift_min = NAN};
    options->light.hours.count = 1;
}

static enum pp_status check_annual_options(void *values, char **files, int file_count,
                                           struct pp_error *err)
{
    struct annual_options *options = values;
    struct pp_study_options *study = &options->room.study;
    (void)files;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (!options->light.weather)
        return pp_fail(err, PP_BAD_INPUT, "expected --weather FILE.epw");
    if (options->light.hours.count != 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "--hours has %d periods; expected one, such as 8-18",
                       options->light.hours.count);
    if (study->sky)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--sky does not apply, because the weather file determines the sky");
    if (study->seconds > 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--time does not apply; expected --error or --samples");
    if (study->samples > 0
        && (study->samples > 65536 || (study->samples & (study->samples - 1)) != 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--samples is %ld; expected a power of two up to 65536",
                       study->samples);
    if (hours_are_json(options) && options->format != PP_FORMAT_JSON)
        return pp_fail(err, PP_BAD_INPUT,
                       "--hourly json needs --format json; expected --hourly FILE.csv");
    study->simulate = true;
    enum pp_status status = pp_annual_stores_check(&options->stores, study->error > 0.0,
                                                   options->annual.exact_sky, err);
    if (status == PP_OK)
        status = pp_blinds_option_check(&options->blinds, err);
    if (status == PP_OK)
        status = pp_lighting_option_check(
            &options->lighting,
            options->blinds.control == PP_BLINDS_NEVER      ? "--blinds never"
            : options->blinds.control == PP_BLINDS_ALWAYS   ? "--blinds always"
            : options->blinds.control == PP_BLINDS_SCHEDULE ? "--blinds-schedule"
            : options->annual.exact_sky                     ? "--exact-sky"
                                                            : NULL,
            err);
    if (status == PP_OK)
        status = pp_annual_methods_settle(&options->methods,
                                          options->format == PP_FORMAT_CSV, err);
    return status != PP_OK ? status
                           : pp_availability_options_check(&options->light, err);
}

static void clear_annual_options(void *values)
{
    struct annual_options *options = values;
    pp_availability_options_clear(&options->light);
    pp_room_options_clear(&options->room);
    pp_blinds_option_clear(&options->blinds);
}

const struct pp_command pp_command_annual = {
    .name = "annual",
    .summary = "daylight in every hour of a year",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct annual_options),
    .init = init_annual_options,
    .check = check_annual_options,
    .more_help = pp_annual_methods_help,
    .run = run_annual,
    .clear = clear_annual_options,
};
