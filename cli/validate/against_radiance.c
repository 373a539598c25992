/* against_radiance.c - exports each room, runs Radiance's script on it, and prints
 * both results. */
#include "cli/validate/against_radiance.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "reports/parts/format.h"
#include "studies/study_report.h"
#include "cli/interrupt.h"
#include "reports/parts/json.h"
#include "cli/message.h"
#include "cli/job.h"
#include "cli/validate/run_suite.h"
#include "reports/parts/print.h"
#include "cli/radiance/radiance_export.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "studies/validation/room_cases.h"

/* Each point is asked so often: rtrace has no standard error, their spread gives one.
 */
enum { REPEATS = 16 };

/* Of both programs at one point, fractions. */
struct beside {
    struct pp_receiver at;
    double traced, traced_error, radiance, radiance_error;
};

static double off_by(const struct beside *b)
{
    return (b->radiance - b->traced) / hypot(b->traced_error, b->radiance_error);
}

/* ---- running rtrace ---- */

static bool on_path(const char *program)
{
    const char *path = getenv("PATH");
    for (const char *at = path; at && *at;) {
        size_t length = strcspn(at, ":");
        char *file;
        if (asprintf(&file, "%.*s/%s", (int)length, at, program) < 0)
            return false;
        bool found = length > 0 && access(file, X_OK) == 0;
        free(file);
        if (found)
            return true;
        at += length + (at[length] == ':');
    }
    return false;
}

/* The script's factors, *text the caller's; its messages go to standard error. */
static enum pp_status run_script(const char *directory, char **text,
                                 struct pp_error *err)
{
    int ends[2];
    *text = NULL;
    if (pipe(ends) != 0)
        return pp_fail(err, PP_SYSTEM, "rtrace can't be run: %s", strerror(errno));
    pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        if (chdir(directory) == 0)
            execlp("sh", "sh", "./daylight_factors.sh", "-ab", "22", "-lr", "0", "-ad",
                   "1024", "-as", "0", "-aa", "0", "-lw", "1e-7", (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    size_t size = 0, count = 0;
    FILE *in = child > 0 ? fdopen(ends[0], "r") : NULL;
    if (in) {
        ssize_t got = getdelim(text, &size, '\0', in);
        count = got > 0 ? (size_t)got : 0;
        fclose(in);
    } else {
        close(ends[0]);
    }
    int state = -1;
    while (child > 0 && waitpid(child, &state, 0) < 0 && errno == EINTR)
        ;
    if (child > 0 && state == 0 && count > 0)
        return PP_OK;
    return pp_interrupt_came() ? pp_fail(err, PP_INTERRUPTED, "interrupted")
                               : pp_fail(err, PP_SYSTEM, "rtrace failed");
}

/* The fourth word of each line: REPEATS lines a point. */
static enum pp_status read_factors(struct beside *list, int count, char *text,
                                   struct pp_error *err)
{
    char *rest = text;
    for (int i = 0; i < count; i++) {
        double values[REPEATS], sum = 0.0, squares = 0.0;
        for (int k = 0; k < REPEATS; k++) {
            char *line = strsep(&rest, "\n"), *word = line ? strrchr(line, ' ') : NULL;
            if (!word || !pp_text_parse_number(word, &values[k]))
                return pp_fail(err, PP_SYSTEM, "rtrace gave fewer factors than points");
            sum += values[k] / 100.0;
        }
        double mean = sum / REPEATS;
        for (int k = 0; k < REPEATS; k++)
            squares += (values[k] / 100.0 - mean) * (values[k] / 100.0 - mean);
        list[i].radiance = mean;
        list[i].radiance_error = sqrt(squares / REPEATS / (REPEATS - 3));
    }
    return PP_OK;
}

/* The room with each point as often as it is asked. */
static enum pp_status export_repeated(const char *path,
                                      const struct pp_study_room *room,
                                      struct pp_error *err)
{
    struct pp_study_room many = *room;
    many.receiver_count = REPEATS * room->receiver_count;
    many.receivers = calloc((size_t)many.receiver_count + 1, sizeof *many.receivers);
    if (!many.receivers)
        return pp_fail_memory(err);
    for (int i = 0; i < many.receiver_count; i++)
        many.receivers[i] = room->receivers[i / REPEATS];
    struct pp_output_directory directory;
    enum pp_status status =
        pp_output_directory_open(&directory, path, false, pp_radiance_files, err);
    if (status == PP_OK)
        status = pp_radiance_export(&directory, NULL, &many, 10000.0, false, err);
    if (status == PP_OK)
        status = pp_output_directory_commit(&directory, err);
    else
        pp_output_directory_clear(&directory);
    free(many.receivers);
    return status;
}

static enum pp_status ask_radiance(struct beside *list,
                                   const struct pp_study_room *room,
                                   struct pp_error *err)
{
    const char *place = getenv("TMPDIR");
    char *path, *text = NULL;
    if (asprintf(&path, "%s/pepperpot-XXXXXX", place && *place ? place : "/tmp") < 0)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    if (!mkdtemp(path)) {
        status = pp_fail(err, PP_SYSTEM, "%s can't be made: %s", path, strerror(errno));
        free(path);
        return status;
    }
    status = export_repeated(path, room, err);
    if (status == PP_OK)
        status = run_script(path, &text, err);
    if (status == PP_OK)
        status = read_factors(list, room->receiver_count, text, err);
    pp_output_directory_remove(path);
    free(text);
    free(path);
    return status;
}

static enum pp_status ask_tracer(struct beside *list, const struct pp_study_room *room,
                                 const struct pp_room_options *options,
                                 struct pp_error *err)
{
    struct pp_report report;
    bool by_clock = false;
    enum pp_status status =
        pp_study_report_methods(&report, room, &options->study, err);
    if (status == PP_OK)
        status = pp_study_report_traced(&report, &options->study, &by_clock, err);
    const struct pp_column *traced = NULL;
    for (int i = 0; i < report.column_count && status == PP_OK; i++)
        if (report.columns[i].component == PP_DF
            && strcmp(report.columns[i].name, "traced") == 0)
            traced = &report.columns[i];
    for (int i = 0; i < room->receiver_count && traced; i++) {
        list[i].at = room->receivers[i];
        list[i].traced = traced->points[i].value;
        list[i].traced_error = traced->points[i].std_error;
    }
    if (status == PP_OK && !report.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted");
    pp_report_clear(&report);
    return status;
}

/* ---- printing ---- */

static void print_text(const struct beside *list, int count, FILE *out)
{
    double worst = 0.0;
    fputs("\n         x       y       z   traced %       +-  rtrace %       +-   off "
          "by\n",
          out);
    for (int i = 0; i < count; i++) {
        const struct beside *b = &list[i];
        worst = fmax(worst, fabs(off_by(b)));
        fprintf(out, "  %8.3f%8.3f%8.3f  %9.4f %8.4f %9.4f %8.4f %8.2f\n",
                b->at.position.x, b->at.position.y, b->at.position.z, 100.0 * b->traced,
                100.0 * b->traced_error, 100.0 * b->radiance, 100.0 * b->radiance_error,
                off_by(b));
    }
    fprintf(
        out,
        "\n  \"off by\" counts the standard error of the difference; worst %.2f. That "
        "of\n  rtrace is from the spread of %d runs a point.\n",
        worst, REPEATS);
}

static void print_csv(const char *name, const struct beside *list, int count, FILE *out)
{
    for (int i = 0; i < count; i++) {
        const double numbers[] = {
            list[i].at.position.x,          list[i].at.position.y,
            list[i].at.position.z,          100.0 * list[i].traced,
            100.0 * list[i].traced_error,   100.0 * list[i].radiance,
            100.0 * list[i].radiance_error, off_by(&list[i])};
        pp_format_csv_field(name, out);
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
            pp_format_csv_number(numbers[k], out);
        fputs("\r\n", out);
    }
}

static bool add_value(struct json_object *object, const char *key, double value,
                      double error)
{
    struct json_object *entry = json_object_new_object();
    bool good = entry && pp_json_number(entry, "value", 100.0 * value)
                && pp_json_number(entry, "se", 100.0 * error);
    if (good)
        pp_json_on_one_line(entry);
    return pp_json_add(object, key, pp_json_whole(entry, good));
}

static struct json_object *point_object(const struct beside *b)
{
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "x", b->at.position.x)
                && pp_json_number(object, "y", b->at.position.y)
                && pp_json_number(object, "z", b->at.position.z)
                && add_value(object, "traced", b->traced, b->traced_error)
                && add_value(object, "rtrace", b->radiance, b->radiance_error)
                && pp_json_number(object, "off-by", off_by(b));
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *room_object(const struct pp_study_room *room,
                                       const struct beside *list)
{
    struct json_object *object = json_object_new_object();
    struct json_object *points = json_object_new_array();
    bool good = object && pp_json_text(object, "file", room->file)
                && pp_json_text(object, "room", room->world->name);
    good = pp_json_add(object, "points", points) && good;
    for (int i = 0; i < room->receiver_count && good; i++)
        good = pp_json_append(points, point_object(&list[i]));
    return pp_json_whole(object, good);
}

static enum pp_status print_json(const struct pp_rooms *rooms,
                                 struct beside *const *lists, FILE *out,
                                 struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    struct json_object *all = json_object_new_array();
    bool good = object && pp_json_text(object, "format", "pepperpot-validate-1")
                && pp_json_text(object, "against", "radiance");
    good = pp_json_add(object, "rooms", all) && good;
    for (int i = 0; i < rooms->count && good; i++)
        good = pp_json_append(all, room_object(&rooms->list[i], lists[i]));
    return pp_json_print(out, pp_json_whole(object, good), err);
}

static enum pp_status print(const struct pp_rooms *rooms, struct beside *const *lists,
                            enum pp_format format, FILE *out, struct pp_error *err)
{
    if (format == PP_FORMAT_JSON)
        return print_json(rooms, lists, out, err);
    if (format == PP_FORMAT_CSV)
        fputs("room,x,y,z,traced,traced_se,radiance,radiance_se,off_by\r\n", out);
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_study_room *room = &rooms->list[i];
        if (format == PP_FORMAT_CSV) {
            print_csv(room->world->name, lists[i], room->receiver_count, out);
        } else {
            fputs(i > 0 ? "\n\n" : "", out);
            pp_print_title(room->world, room->file, out);
            print_text(lists[i], room->receiver_count, out);
        }
    }
    return PP_OK;
}

/* ---- all rooms ---- */

static enum pp_status compare_room(struct beside **list,
                                   const struct pp_study_room *room,
                                   const struct pp_room_options *options,
                                   struct pp_error *err)
{
    *list = calloc((size_t)room->receiver_count + 1, sizeof **list);
    if (!*list)
        return pp_fail_memory(err);
    if (room->world->decorations < 1.0 && !options->quiet)
        pp_message(
            "%.200s: traced daylight factors allow for decorations of %g, those of "
            "Radiance don't",
            pp_read_file_title(room->file), room->world->decorations);
    enum pp_status status = ask_tracer(*list, room, options, err);
    return status == PP_OK ? ask_radiance(*list, room, err) : status;
}

struct against_run {
    const struct pp_room_options *options;
    enum pp_format format;
    const struct pp_rooms *rooms;
    struct beside **lists; /* one a room */
};

static enum pp_status compare_rooms(void *data, struct pp_error *err)
{
    struct against_run *run = data;
    const struct pp_rooms *rooms = run->rooms;
    enum pp_status status = PP_OK;
    run->lists = calloc((size_t)rooms->count + 1, sizeof *run->lists);
    if (!run->lists)
        return pp_fail_memory(err);
    pp_interrupt_watch();
    for (int i = 0; i < rooms->count && status == PP_OK; i++)
        status = compare_room(&run->lists[i], &rooms->list[i], run->options, err);
    return status;
}

static enum pp_status print_rooms(const void *data, FILE *out, struct pp_error *err)
{
    const struct against_run *run = data;
    return print(run->rooms, run->lists, run->format, out, err);
}

static bool is_there(void)
{
    if (on_path("rtrace") && on_path("oconv"))
        return true;
    pp_message("to compare with Radiance takes its oconv and rtrace, and they are not "
               "on PATH: nothing was compared");
    return false;
}

static void clear(struct against_run *run)
{
    for (int i = 0; run->lists && i < run->rooms->count; i++)
        free(run->lists[i]);
    free(run->lists);
}

enum pp_exit pp_against_radiance(const struct pp_rooms *rooms,
                                 const struct pp_room_options *options,
                                 enum pp_format format)
{
    if (!is_there())
        return PP_EXIT_MACHINE;
    struct against_run run = {.options = options, .format = format, .rooms = rooms};
    enum pp_exit exit_status = pp_job_run(
        &(struct pp_job){options->output, compare_rooms, print_rooms, NULL, &run});
    clear(&run);
    return exit_status;
}

static enum pp_status find_cases(void *data, struct pp_known_cases *cases,
                                 struct pp_error *err)
{
    struct against_run *run = data;
    enum pp_status status = compare_rooms(run, err);
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++) {
        const struct pp_study_room *room = &run->rooms->list[i];
        for (int k = 0; k < room->receiver_count; k++) {
            const struct beside *one = &run->lists[i][k];
            pp_room_cases_of_radiance(
                cases, room->file, room->world, one->at.position,
                (struct pp_reading){.value = one->traced,
                                    .std_error = one->traced_error},
                (struct pp_reading){.value = one->radiance,
                                    .std_error = one->radiance_error});
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
    clear(&run);
    return exit_status;
}
