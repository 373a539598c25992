/* cmd_glare.c - the command glare: daylight glare probability of views in a room. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/availability/availability_options.h"
#include "cli/command.h"
#include "cli/format_option.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/moment_choice.h"
#include "cli/rooms.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "model/base/array.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/room/position.h"
#include "reports/glare/glare_json.h"
#include "reports/glare/glare_report.h"
#include "studies/glare/glare_study.h"

static const char about[] =
    "Calculates the daylight glare probability (DGP) of views in a room, from the "
    "simulated illuminance at the eye and the sources in the field of view. With "
    "--weather alone: in the occupied hours of a year, with the level of EN 17037. "
    "With "
    "--when, or with a --sky that has irradiances or illuminances: at one moment. "
    "Views "
    "are the <view> elements of the room file, or those of --view. FILE is a room "
    "file; "
    "- is standard input.";

/* Target error of the simulation of a moment if neither --error nor --samples is
 * given. */
static const double moment_error = 0.005;

/* A view given by --view. */
struct typed_view {
    struct pp_vec3 eye;
    double bearing_rad;
};

struct glare_options {
    struct pp_room_options room;
    struct pp_moment_choice moment;
    struct pp_year_options light; /* weather file, for glare over a year */
    struct typed_views {
        struct typed_view *list;
        int count;
    } views;
    double threshold_cd_m2;
    enum pp_format format;
};

struct glare_run {
    struct glare_options *options;
    const struct pp_rooms *rooms;
    struct pp_weather_year year; /* empty for a single moment */
    bool is_year;
    struct pp_world_view **views; /* for each room: the views of --view; NULL: none */
    struct pp_glare_results results;
};

/* ---- the work ---- */

/* Makes the views of --view for a room; the caller frees them. */
static enum pp_status place_views(struct pp_world_view **views,
                                  const struct typed_views *typed,
                                  const struct pp_study_room *room,
                                  struct pp_error *err)
{
    *views = calloc((size_t)typed->count, sizeof **views);
    if (!*views)
        return pp_fail_memory(err);
    for (int i = 0; i < typed->count; i++) {
        struct pp_world_view *view = &(*views)[i];
        *view = pp_position_view(room->world, typed->list[i].eye,
                                 typed->list[i].bearing_rad);
        const char *fault =
            pp_position_receiver_fault(room->world, view->eye, view->direction);
        if (fault)
            return pp_fail(err, PP_BAD_INPUT,
                           "%s: --view: the eye at (%g, %g, %g) %s; expected a point "
                           "in the free space of the room",
                           pp_read_file_title(room->file), view->eye.x, view->eye.y,
                           view->eye.z, fault);
    }
    return PP_OK;
}

static enum pp_status compute_glare_room(struct glare_run *run, int index,
                                         struct pp_error *err)
{
    const struct glare_options *options = run->options;
    const struct pp_study_options *study = &options->room.study;
    const struct pp_study_room *room = &run->rooms->list[index];
    struct pp_glare_result *result = &run->results.list[index];
    struct pp_glare_options glare = pp_glare_options_default;
    struct pp_moment moment;
    const struct pp_world_view *views = room->world->views;
    int view_count = room->world->view_count;
    enum pp_status status = PP_OK;
    result->file = room->file;
    if (options->views.count > 0) {
        status = place_views(&run->views[index], &options->views, room, err);
        views = run->views[index];
        view_count = options->views.count;
    } else if (view_count == 0) {
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s: the room has no view; expected --view X,Y,BEARING, or "
                         "<view x=\"2\" y=\"3\" bearing=\"180\"/> in the room file",
                         pp_read_file_title(room->file));
    }
    if (status == PP_OK && !run->is_year) {
        struct pp_error own = {0};
        status = pp_moment_choice_find(&moment, &options->moment, room->world, &own);
        if (status == PP_OK)
            status = pp_moment_turn_slats(room->world, &moment, &own);
        if (status != PP_OK)
            pp_fail(err, status, "%s: %s", pp_read_file_title(room->file), own.message);
    }
    if (status != PP_OK)
        return status;
    glare.threshold_cd_m2 = options->threshold_cd_m2;
    glare.annual.hours = options->light.hours.list[0];
    glare.annual.hours.days = options->light.days;
    if (run->is_year)
        glare.annual.summer =
            options->light.summer.of_file
                ? (struct pp_summer_time){options->light.epw->summer_from,
                                          options->light.epw->summer_to}
                : options->light.summer.time;
    glare.annual.samples = (int)study->samples;
    glare.annual.error = study->error;
    glare.annual.strict = study->strict;
    glare.annual.seed = study->seed;
    glare.annual.threads = study->threads;
    glare.annual.watch = study->watch;
    return pp_glare_study_run(&result->sheet, room, views, view_count,
                              run->is_year ? NULL : &moment, &run->year, &glare, err);
}

static enum pp_status compute_glare(void *data, struct pp_error *err)
{
    struct glare_run *run = data;
    const struct glare_options *options = run->options;
    int count = run->rooms->count;
    run->results.list = calloc((size_t)count + 1, sizeof *run->results.list);
    run->views = calloc((size_t)count + 1, sizeof *run->views);
    if (!run->results.list || !run->views)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    if (run->is_year)
        status =
            pp_weather_year_of_epw(&run->year, options->light.epw,
                                   &(struct pp_weather_options){.sun_shift_h = NAN},
                                   pp_read_file_title(options->light.weather), err);
    pp_interrupt_watch();
    for (int i = 0; i < count && status == PP_OK; i++) {
        run->results.count = i + 1;
        status = compute_glare_room(run, i, err);
        if (status == PP_OK && !run->results.list[i].sheet.annual.finished) {
            run->results.count = i;
            break;
        }
    }
    return status;
}

static enum pp_status print_glare(const void *data, FILE *out, struct pp_error *err)
{
    const struct glare_run *run = data;
    switch (run->options->format) {
    case PP_FORMAT_JSON:
        return pp_glare_json(&run->results, out, err);
    case PP_FORMAT_CSV:
        return pp_glare_report_csv(&run->results, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_glare_report_text(&run->results,
                                pp_terminal_width(run->options->room.output), out, err);
}

static bool glare_is_finished(const void *data)
{
    const struct glare_run *run = data;
    return run->results.count == run->rooms->count;
}

static void clear_glare_run(struct glare_run *run)
{
    for (int i = 0; i < run->rooms->count; i++) {
        if (run->results.list)
            pp_glare_sheet_clear(&run->results.list[i].sheet);
        if (run->views)
            free(run->views[i]);
    }
    free(run->results.list);
    free(run->views);
    pp_weather_year_clear(&run->year);
}

static enum pp_exit run_glare(void *values, char **files, int file_count)
{
    struct glare_options *options = values;
    struct pp_terminal_watch watch;
    struct pp_rooms rooms;
    bool is_year = options->light.weather != NULL, strict = options->room.study.strict;
    options->room.study.watch = pp_watch_of_terminal(&watch, options->room.quiet);
    enum pp_exit result = is_year
                              ? pp_availability_options_load(&options->light, strict)
                              : pp_moment_choice_load(&options->moment, strict);
    if (result == PP_EXIT_DONE)
        result = pp_rooms_load(&rooms, "glare", files, file_count, &options->room);
    if (result != PP_EXIT_DONE)
        return result;
    struct glare_run run = {
        .options = options,
        .rooms = &rooms,
        .is_year = is_year,
        .results = {.several = rooms.several, .when = options->moment.when}};
    result = pp_job_run(&(struct pp_job){options->room.output, compute_glare,
                                         print_glare, glare_is_finished, &run});
    clear_glare_run(&run);
    pp_rooms_clear(&rooms);
    return result;
}

/* ---- the command line ---- */

static enum pp_status read_typed_view(const char *text, void *place,
                                      struct pp_error *err)
{
    struct typed_views *views = place;
    double v[4];
    int count = pp_options_numbers(text, ',', v, 4);
    bool good = count == 3 || count == 4;
    for (int i = 0; i < count && good; i++)
        good = fabs(v[i]) <= (i == count - 1 ? 360.0 : 1e6);
    if (!good)
        return pp_fail(err, PP_BAD_INPUT,
                       "X,Y,BEARING or X,Y,Z,BEARING, in metres and degrees, such as "
                       "2,3.5,180");
    if (pp_array_append(&views->list, views->count, sizeof *views->list, err) != PP_OK)
        return PP_SYSTEM;
    views->list[views->count++] = (struct typed_view){
        pp_vec(v[0], v[1], count == 4 ? v[2] : PP_GLARE_STUDY_EYE_M),
        v[count - 1] * PP_RAD};
    return PP_OK;
}

static enum pp_status read_threshold(const char *text, void *place,
                                     struct pp_error *err)
{
    double cd_m2;
    if (!pp_text_parse_number(text, &cd_m2) || !(cd_m2 >= 1.0 && cd_m2 <= 1e6))
        return pp_fail(err, PP_BAD_INPUT, "a luminance from 1 to 1000000 cd/m2");
    *(double *)place = cd_m2;
    return PP_OK;
}

#define PLACE(member) offsetof(struct glare_options, member)

static const struct pp_option view_options[] = {
    {"view", 0, "X,Y[,Z],BEARING",
     "Position of an eye in metres, and the bearing of its horizontal line of sight in "
     "degrees clockwise from north, instead of the views in the file. Without Z the "
     "eye "
     "is 1.2 m above the floor. Repeat the option for more views.",
     read_typed_view, PLACE(views)},
    {"threshold", 0, "CD/M2",
     "A surface is a source of glare if its luminance is at least this value (default "
     "2000).",
     read_threshold, PLACE(threshold_cd_m2)},
    {0},
};

static const struct pp_option_group groups[] = {
    {"Calculation", view_options, 0},
    {"Calculation", pp_moment_weather_option, PLACE(moment)},
    {"Calculation", pp_moment_when_option, PLACE(moment)},
    {"Calculation", pp_room_sky_options, PLACE(room)},
    {"Occupied hours", pp_working_time_options, PLACE(light)},
    PP_ROOM_STOP_GROUPS(PLACE(room)),
    {"Output", pp_format_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_glare_options(void *values)
{
    struct glare_options *options = values;
    *options = (struct glare_options){.room = pp_room_options_none,
                                      .light = pp_year_options_default,
                                      .threshold_cd_m2 =
                                          pp_glare_options_default.threshold_cd_m2};
    options->light.hours.count = 1;
}

static enum pp_status check_glare_options(void *values, char **files, int file_count,
                                          struct pp_error *err)
{
    struct glare_options *options = values;
    struct pp_study_options *study = &options->room.study;
    (void)files;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (study->seconds > 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--time does not apply; expected --error or --samples");
    enum pp_status status = pp_moment_choice_check_paths(&options->room, err);
    if (status != PP_OK)
        return status;
    study->simulate = true;
    if (options->moment.weather && !options->moment.when && !study->sky) {
        if (options->light.hours.count != 1)
            return pp_fail(err, PP_BAD_INPUT,
                           "--hours has %d periods; expected one, such as 8-18",
                           options->light.hours.count);
        options->light.weather = options->moment.weather;
        options->moment.weather = NULL;
        if (study->error > 0.0 && study->samples > 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "--error and --samples both determine when the simulation "
                           "stops; expected only one of them");
        return pp_availability_options_check(&options->light, err);
    }
    status = pp_moment_choice_settle(&options->moment, &options->room, err);
    if (status == PP_OK && !pp_moment_choice_said(&options->moment))
        status = pp_fail(err, PP_BAD_INPUT,
                         "expected --weather FILE.epw, or a --sky with its light, such "
                         "as overcast,20000");
    const char *of_year = pp_availability_options_typed(&options->light);
    if (status == PP_OK && of_year)
        status =
            pp_fail(err, PP_BAD_INPUT,
                    "%s is for a year; expected --weather without --when, or no %s",
                    of_year, of_year);
    if (!(study->error > 0.0) && study->samples == 0)
        study->error = moment_error;
    return status == PP_OK ? pp_room_options_settle(&options->room, err) : status;
}

static void clear_glare_options(void *values)
{
    struct glare_options *options = values;
    pp_availability_options_clear(&options->light);
    pp_moment_choice_clear(&options->moment);
    pp_room_options_clear(&options->room);
    free(options->views.list);
}

const struct pp_command pp_command_glare = {
    .name = "glare",
    .summary = "daylight glare probability of views",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct glare_options),
    .init = init_glare_options,
    .check = check_glare_options,
    .run = run_glare,
    .clear = clear_glare_options,
};
