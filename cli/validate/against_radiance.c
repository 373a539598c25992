/* against_radiance.c - makes a report for each room, with columns of the simulation and
 * of rtrace, and prints the comparison. */
#include "cli/validate/against_radiance.h"

#include <math.h>
#include <stdlib.h>

#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/ranks/room_queue.h"
#include "cli/validate/rtrace_factors.h"
#include "cli/validate/run_suite.h"
#include "model/base/read_file.h"
#include "reports/df_result.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"
#include "studies/study_report.h"
#include "studies/research/validation/room_cases.h"

struct against_run {
    const struct pp_room_options *options;
    enum pp_format format;
    const struct pp_rooms *rooms;
    struct pp_result *results; /* one for each room */
    int count;
};

/* ---- one room ---- */

/* Daylight factors of both programs at one point, as fractions. */
struct beside {
    struct pp_vec3 at;
    struct pp_reading traced, radiance;
};

static struct beside beside_of(const struct pp_report *report, int point)
{
    return (struct beside){report->receivers[point].position,
                           pp_report_find(report, PP_DF, "traced")->points[point],
                           pp_report_find(report, PP_DF, "rtrace")->points[point]};
}

static double off_by(const struct beside *b)
{
    return pp_reading_apart(&b->radiance, &b->traced);
}

static struct pp_room_figures against_room_figures(void *data, int index)
{
    struct pp_result *result = &((struct against_run *)data)->results[index];
    return (struct pp_room_figures){&result->report, &result->by_clock};
}

/* Simulates a room, and runs rtrace for the same points. An interrupted simulation is
 * not compared. */
static enum pp_status simulate_against_room(const void *data, int index,
                                            struct pp_report *report, bool *by_clock,
                                            struct pp_error *err)
{
    const struct against_run *run = data;
    enum pp_status status =
        pp_study_report_traced(report, &run->options->study, by_clock, err);
    if (status != PP_OK || !report->finished)
        return status == PP_OK ? pp_fail(err, PP_INTERRUPTED, "interrupted") : status;
    struct pp_column *column = pp_report_add(report, PP_DF, "rtrace", true);
    return column ? pp_rtrace_factors(column->points, &run->rooms->list[index], err)
                  : pp_fail_memory(err);
}

/* ---- printing ---- */

static void print_text(const struct pp_report *report, FILE *out)
{
    double worst = 0.0;
    fputs(
        "\n         x       y       z    sim. %       +-  rtrace %       +-   off by\n",
        out);
    for (int i = 0; i < report->receiver_count; i++) {
        struct beside b = beside_of(report, i);
        worst = fmax(worst, fabs(off_by(&b)));
        fprintf(out, "  %8.3f%8.3f%8.3f  %9.4f %8.4f %9.4f %8.4f %8.2f\n", b.at.x,
                b.at.y, b.at.z, 100.0 * b.traced.value, 100.0 * b.traced.std_error,
                100.0 * b.radiance.value, 100.0 * b.radiance.std_error, off_by(&b));
    }
    fprintf(out,
            "\n  \"off by\" is the difference in standard errors; the largest is %.2f. "
            "The standard error of\n  rtrace is calculated from the spread of %d runs "
            "per point.\n",
            worst, PP_RTRACE_REPEATS);
}

static void print_csv(const struct pp_report *report, FILE *out)
{
    for (int i = 0; i < report->receiver_count; i++) {
        struct beside b = beside_of(report, i);
        const double numbers[] = {b.at.x,
                                  b.at.y,
                                  b.at.z,
                                  100.0 * b.traced.value,
                                  100.0 * b.traced.std_error,
                                  100.0 * b.radiance.value,
                                  100.0 * b.radiance.std_error,
                                  off_by(&b)};
        pp_format_csv_field(report->world->name, out);
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
            pp_format_csv_number(numbers[k], out);
        fputs("\r\n", out);
    }
}

static bool add_reading_value(struct json_object *object, const char *key,
                              const struct pp_reading *reading)
{
    struct json_object *entry = json_object_new_object();
    bool good = entry && pp_json_number(entry, "value", 100.0 * reading->value)
                && pp_json_number(entry, "se", 100.0 * reading->std_error);
    if (good)
        pp_json_on_one_line(entry);
    return pp_json_add(object, key, pp_json_whole(entry, good));
}

static struct json_object *point_object(const struct beside *b)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "x", b->at.x)
                && pp_json_number(object, "y", b->at.y)
                && pp_json_number(object, "z", b->at.z)
                && add_reading_value(object, "traced", &b->traced)
                && add_reading_value(object, "rtrace", &b->radiance)
                && pp_json_number(object, "off-by", off_by(b));
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *room_object(const struct pp_result *result)
{
    const struct pp_report *report = &result->report;
    struct json_object *object = json_object_new_object();
    struct json_object *points = json_object_new_array();
    bool good = object && pp_json_text(object, "file", result->file)
                && pp_json_text(object, "room", report->world->name);
    good = pp_json_add(object, "points", points) && good;
    for (int i = 0; i < report->receiver_count && good; i++) {
        struct beside b = beside_of(report, i);
        good = pp_json_append(points, point_object(&b));
    }
    return pp_json_whole(object, good);
}

static enum pp_status print_json(const struct against_run *run, FILE *out,
                                 struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    struct json_object *all = json_object_new_array();
    bool good = object && pp_json_text(object, "format", "pepperpot-validate-1")
                && pp_json_text(object, "against", "radiance");
    good = pp_json_add(object, "rooms", all) && good;
    for (int i = 0; i < run->count && good; i++)
        good = pp_json_append(all, room_object(&run->results[i]));
    return pp_json_print(out, pp_json_whole(object, good), err);
}

static enum pp_status print_against_radiance(const void *data, FILE *out,
                                             struct pp_error *err)
{
    const struct against_run *run = data;
    if (run->format == PP_FORMAT_JSON)
        return print_json(run, out, err);
    if (run->format == PP_FORMAT_CSV)
        fputs("room,x,y,z,traced,traced_se,radiance,radiance_se,off_by\r\n", out);
    for (int i = 0; i < run->count; i++) {
        const struct pp_result *result = &run->results[i];
        if (run->format == PP_FORMAT_CSV) {
            print_csv(&result->report, out);
        } else {
            fputs(i > 0 ? "\n\n" : "", out);
            pp_print_title(result->report.world, result->file, out);
            print_text(&result->report, out);
        }
    }
    return PP_OK;
}

/* ---- all rooms ---- */

/* Evaluates the hand methods, and warns if the room has an allowance for
 * decorations. */
static enum pp_status begin_against_run(struct against_run *run,
                                        const struct pp_study_room *room,
                                        struct pp_error *err)
{
    struct pp_result *result = &run->results[run->count++];
    result->file = room->file;
    if (room->world->decorations < 1.0 && !run->options->quiet)
        pp_message("%.200s: simulated daylight factors include an allowance of %g "
                   "for deterioration of decorations, but those of Radiance do not",
                   pp_read_file_title(room->file), room->world->decorations);
    return pp_study_report_methods(&result->report, room, &run->options->study, err);
}

static enum pp_status compare_rooms(void *data, struct pp_error *err)
{
    struct against_run *run = data;
    enum pp_status status = PP_OK;
    run->results = calloc((size_t)run->rooms->count + 1, sizeof *run->results);
    if (!run->results)
        return pp_fail_memory(err);
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++)
        status = begin_against_run(run, &run->rooms->list[i], err);
    pp_interrupt_watch();
    return status == PP_OK ? pp_room_queue_run(
               &(struct pp_room_queue){run->count, run->options->ranks,
                                       against_room_figures, simulate_against_room,
                                       run},
               err)
                           : status;
}

static bool is_there(void)
{
    if (pp_rtrace_is_there())
        return true;
    pp_message("a comparison with Radiance needs oconv and rtrace on PATH; nothing was "
               "compared");
    return false;
}

static void clear_against_run(struct against_run *run)
{
    for (int i = 0; i < run->count; i++)
        pp_report_clear(&run->results[i].report);
    free(run->results);
}

enum pp_exit pp_against_radiance(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format)
{
    if (!is_there())
        return PP_EXIT_MACHINE;
    struct against_run run = {.options = options, .format = format, .rooms = rooms};
    enum pp_exit exit_status = pp_job_run(&(struct pp_job){
        options->output, compare_rooms, print_against_radiance, NULL, &run});
    clear_against_run(&run);
    return exit_status;
}

static enum pp_status find_cases(void *data, struct pp_known_cases *cases,
                                 struct pp_error *err)
{
    struct against_run *run = data;
    enum pp_status status = compare_rooms(run, err);
    for (int i = 0; i < run->count && status == PP_OK; i++) {
        const struct pp_report *report = &run->results[i].report;
        for (int k = 0; k < report->receiver_count; k++) {
            struct beside b = beside_of(report, k);
            pp_room_cases_of_radiance(cases, run->results[i].file, report->world, b.at,
                                      b.traced, b.radiance);
        }
    }
    return status;
}

enum pp_exit pp_against_radiance_suite(const struct pp_rooms *rooms,
                                       const struct pp_room_options *options,
                                       enum pp_format format, const char *page)
{
    if (!is_there())
        return PP_EXIT_MACHINE;
    struct against_run run = {.options = options, .format = format, .rooms = rooms};
    enum pp_exit exit_status = pp_run_suite(
        &(struct pp_suite_source){&pp_suite_radiance, find_cases, NULL, &run}, options,
        format, page);
    clear_against_run(&run);
    return exit_status;
}
