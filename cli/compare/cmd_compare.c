/* cmd_compare.c - the command compare: compares values of another program with values
 * of this one, and states causes of the differences. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/compare/compare_scene.h"
#include "cli/compare/other_values.h"
#include "cli/format_option.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/rooms.h"
#include "cli/terminal.h"
#include "cli/watch.h"
#include "model/pictures/quantity.h"
#include "model/light/scene_horizontal.h"
#include "reports/compare/compare_report.h"

struct compare_options {
    struct pp_room_options room;
    const char *variant;
    enum pp_other_unit unit;
    double noise;
    enum pp_format format;
};

#define PLACE(member) offsetof(struct compare_options, member)

static const char about[] =
    "Compares daylight factors of another program with the simulation at the same "
    "points, and finds the cause of the difference. It tests switches that imitate "
    "other programs (--as-if) and shows the probability of each and its share of the "
    "difference. OTHER.csv has a header with the column names (x, y, z and df_percent, "
    "df_fraction or lux) and one line per point. Without OTHER.csv, --as-if compares "
    "the simulation with and without the switches. ROOM is a room file; - is standard "
    "input. Radiance scene files can replace ROOM, as in import; then OTHER.csv comes "
    "last and has x, y and z.";

/* ---- options ---- */

static enum pp_status read_unit(const char *text, void *place, struct pp_error *err)
{
    static const char *const words[] = {"percent", "fraction", "lux"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, words[i]) == 0) {
            *(enum pp_other_unit *)place = (enum pp_other_unit)(PP_OTHER_PERCENT + i);
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "percent, fraction or lux");
}

static const struct pp_option compare_options[] = {
    {"as-if", 0, "SWITCHES",
     "Simulate the room as another program might: switches from the list below, "
     "separated by commas.",
     pp_options_read_text, PLACE(variant)},
    {"as", 0, "UNIT",
     "Unit of the other values, if their column name does not give it: percent, "
     "fraction or lux.",
     read_unit, PLACE(unit)},
    {"external", 0, "LUX",
     "External horizontal illuminance, if the other values are in lux.",
     pp_options_read_lux, PLACE(room.study.external_lux)},
    {"noise", 0, "E%",
     "Standard deviation of the other program's values between runs, as a share of "
     "them (default: estimated from their scatter).",
     pp_options_read_per_cent, PLACE(noise)},
    {0},
};

static const struct pp_option error_option[] = {
    {"error", 0, "E%",
     "Standard error of the simulation, as a share of the values (default 0.5%; for "
     "scenes 1%).",
     pp_options_read_per_cent, PLACE(room.study.error)},
    {0},
};

static void help_on_switches(FILE *out)
{
    static const char *const switches[][2] = {
        {"bounces=N",
         "at most N reflections between surfaces; the ground is a light source"},
        {"ab=N", "at most N-1 reflections, including those at the ground, as in "
                 "Radiance with a ground surface; ab=0: no light from the sky"},
        {"glass=normal", "glass has its normal transmittance at all angles"},
        {"glass=transmissivity", "the transmittance was entered as a transmissivity"},
        {"glass=none", "openings without glass"},
        {"panes=1", "single panes instead of multiple panes"},
        {"frame=none", "no frames"},
        {"dirt=none", "no dirt on the glass"},
        {"plane=Z", "the points are at this height in metres"},
        {"sky=TYPE",
         "another sky: a value of --sky, or gensky (overcast, blended into the "
         "ground at the horizon)"},
        {"ground=R", "ground reflectance, or open: the whole sky lights the ground"},
        {"outside=none", "no external obstructions"},
        {"colour=grey",
         "in a scene: materials are grey, with the luminous reflectance of their "
         "colours"},
        {"colour=mean", "red, green and blue have equal weight in luminance; green: "
                        "only green counts"},
        {"factor=F", "all values multiplied by F"},
    };
    fputs("\nSwitches:\n", out);
    for (size_t i = 0; i < sizeof switches / sizeof switches[0]; i++)
        pp_options_help_word(switches[i][0], switches[i][1], out);
    fputs("\nNames for sets of switches:\n", out);
    const struct pp_room_variant_preset *preset;
    for (int i = 0; (preset = pp_room_variant_preset_at(i)) != NULL; i++) {
        char text[200];
        snprintf(text, sizeof text, "%s (%s)", preset->what, preset->words);
        pp_options_help_word(preset->name, text, out);
    }
}

static const struct pp_option_group groups[] = {
    {"Comparison", compare_options, 0},
    {"Comparison", pp_room_sky_options, PLACE(room)},
    {"Simulation", error_option, 0},
    {"Simulation", pp_room_seed_options, PLACE(room)},
    {"Output", pp_text_or_json_option, PLACE(format)},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

static void init_compare_options(void *values)
{
    *(struct compare_options *)values =
        (struct compare_options){.room = pp_room_options_none};
}

/* Reports an error if an option is given that applies only to rooms, or if there is no
 * file besides the scene. */
static enum pp_status check_scene(const struct compare_options *options, int file_count,
                                  struct pp_error *err)
{
    const char *stray = options->room.study.sky                ? "--sky"
                        : options->room.room                   ? "--room"
                        : options->room.state != PP_STATE_BOTH ? "--state"
                                                               : NULL;
    if (stray)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is for room files; a scene has its own sky and surfaces",
                       stray);
    if (file_count < 2)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected scene files, then a CSV file with the other program's "
                       "values and points");
    return PP_OK;
}

static enum pp_status check_compare_options(void *values, char **files, int file_count,
                                            struct pp_error *err)
{
    struct compare_options *options = values;
    struct pp_room_variant variant = pp_room_variant_nothing();
    struct pp_error own = {0};
    bool is_scene = file_count > 0 && pp_compare_scene_is(files[0]);
    if (is_scene) {
        enum pp_status status = check_scene(options, file_count, err);
        if (status != PP_OK)
            return status;
    } else if (file_count == 0 || file_count > 2) {
        return pp_fail(
            err, PP_BAD_INPUT,
            "expected a room file, and a CSV file with the other program's values");
    }
    if (file_count == 1 && !options->variant)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a CSV file with the other program's values after the "
                       "room file, or --as-if");
    if (file_count == 1 && options->noise > 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--noise describes the other program's values; expected a file "
                       "with these values");
    if (options->variant
        && pp_room_variant_add(&variant, options->variant, &own) != PP_OK)
        return pp_fail(err, PP_BAD_INPUT, "--as-if: %s", own.message);
    if (options->room.study.error == 0.0)
        options->room.study.error = is_scene ? 0.01 : 0.005;
    return PP_OK;
}

/* ---- values ---- */

/* Converts the values selected by `chosen` (indices) to fractions. lux: horizontal
 * illuminance under the open sky; 0: unknown. */
static enum pp_status to_fractions(double *theirs, const struct pp_other_values *values,
                                   const int *chosen, int count,
                                   const struct compare_options *options, double lux,
                                   const char *path, struct pp_error *err)
{
    enum pp_other_unit unit = options->unit ? options->unit : values->unit;
    if (options->unit && values->unit && options->unit != values->unit)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s: --as and the column name give different units; "
                       "expected the same unit",
                       path);
    if (unit == PP_OTHER_UNKNOWN)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s: the column name does not give the unit; expected --as "
                       "percent, fraction or lux",
                       path);
    if (unit == PP_OTHER_LUX && lux == 0.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s: values in lux need the external horizontal "
                       "illuminance; expected --external LUX",
                       path);
    double most = 0.0, of_unit = unit == PP_OTHER_PERCENT ? 100.0
                                 : unit == PP_OTHER_LUX   ? lux
                                                          : 1.0;
    for (int i = 0; i < count; i++) {
        theirs[i] = values->list[chosen[i]].value / of_unit;
        most = fmax(most, theirs[i]);
    }
    if (most > 2.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%.200s: a daylight factor is %.4g %%; expected 200 %% at most: "
                       "check the unit",
                       path, 100.0 * most);
    return PP_OK;
}

/* ---- the run ---- */

struct compare_run {
    const struct compare_options *options;
    struct pp_study_room *room; /* NULL: a scene is compared instead of a room */
    struct pp_compare_scene scene;
    struct pp_compare_subject subject;
    const char *other;
    struct pp_other_values values;
    int *chosen;
    struct pp_watch watch;
    struct pp_compare *compare, *plain;
    struct pp_compare_result result;
};

static bool compare_goes_on(void *data, double done)
{
    const struct pp_watch *watch = &((struct compare_run *)data)->watch;
    return watch->look(watch->data, done, NAN);
}

static enum pp_status ours(struct pp_compare **compare, struct compare_run *run,
                           bool plain, struct pp_error *err)
{
    const struct pp_study_options *study = &run->options->room.study;
    struct pp_compare_options options = {.variant = pp_room_variant_nothing(),
                                         .tracing = {.error = study->error,
                                                     .seed = study->seed,
                                                     .threads = study->threads,
                                                     .look = compare_goes_on,
                                                     .data = run},
                                         .noise = run->options->noise};
    enum pp_status status = PP_OK;
    if (run->options->variant && !plain)
        status = pp_room_variant_add(&options.variant, run->options->variant, err);
    return status == PP_OK ? pp_compare_create(compare, &run->subject, &options, err)
                           : status;
}

/* External illuminance (lx) given by the user, or else that of the sky in the scene. */
static double external_lux(const struct compare_run *run)
{
    double asked = run->options->room.study.external_lux;
    return run->room || asked > 0.0
               ? asked
               : PP_LUMENS_PER_WATT
                     * pp_rgb_luminance(pp_scene_horizontal(&run->scene.description));
}

static enum pp_status explain(struct compare_run *run, struct pp_error *err)
{
    struct pp_compare_result *result = &run->result;
    double theirs[PP_COMPARE_POINTS_MOST];
    enum pp_status status =
        to_fractions(theirs, &run->values, run->chosen, run->subject.count,
                     run->options, external_lux(run), run->other, err);
    if (status == PP_OK)
        status = ours(&run->compare, run, false, err);
    if (status == PP_OK)
        status = pp_compare_explain(&result->compared, run->compare, theirs, err);
    if (status == PP_OK)
        result->cause_count = pp_compare_causes(run->compare, &result->causes);
    return status;
}

static enum pp_status only_ours(struct compare_run *run, struct pp_error *err)
{
    const double *errors;
    enum pp_status status = ours(&run->compare, run, false, err);
    if (status == PP_OK)
        status = ours(&run->plain, run, true, err);
    if (status != PP_OK)
        return status;
    run->result.plain = pp_compare_ours(run->plain, &errors);
    run->result.compared.ours = pp_compare_ours(run->compare, &errors);
    run->result.compared.errors = errors;
    run->result.compared.count = run->subject.count;
    return PP_OK;
}

static enum pp_status compute_comparison(void *data, struct pp_error *err)
{
    struct compare_run *run = data;
    pp_interrupt_watch();
    run->watch.begin(run->watch.data, run->subject.name);
    enum pp_status status = run->other ? explain(run, err) : only_ours(run, err);
    run->watch.end(run->watch.data);
    return status;
}

static enum pp_status print_compare(const void *data, FILE *out, struct pp_error *err)
{
    const struct compare_run *run = data;
    if (run->options->format == PP_FORMAT_JSON)
        return pp_compare_report_json(&run->result, out, err);
    pp_compare_report(&run->result, pp_terminal_width(run->options->room.output), out);
    return PP_OK;
}

/* Replaces the points of the room or scene by the points of the other program. Values
 * without coordinates belong to the room's own points. If there are too many points, an
 * evenly spread subset is used. */
static enum pp_status take_points(struct compare_run *run, struct pp_error *err)
{
    struct pp_other_values own = {0};
    enum pp_status status =
        run->other ? pp_other_values_read(&run->values, run->other, err) : PP_OK;
    if (status != PP_OK)
        return status;
    if (!run->room)
        return pp_compare_scene_place(&run->chosen, &run->scene, &run->values,
                                      run->other, PP_COMPARE_POINTS_MOST, err);
    if (run->other)
        return pp_other_values_place(&run->chosen, run->room, &run->values, run->other,
                                     PP_COMPARE_POINTS_MOST, err);
    own.count = run->room->receiver_count;
    return pp_other_values_place(&run->chosen, run->room, &own, "",
                                 PP_COMPARE_POINTS_MOST, err);
}

static enum pp_exit run_comparison(struct compare_run *run)
{
    struct pp_terminal_watch terminal;
    struct pp_error err;
    run->watch = pp_watch_of_terminal(&terminal, run->options->room.quiet);
    enum pp_status status = take_points(run, &err);
    enum pp_exit exit_status = PP_EXIT_DONE;
    run->subject = run->room
                       ? pp_compare_subject_of_room(run->room)
                       : (struct pp_compare_subject){.file = run->scene.title,
                                                     .points = run->scene.points,
                                                     .count = run->scene.count,
                                                     .scene = &run->scene.description};
    run->result.subject = &run->subject;
    run->result.other = run->other;
    run->result.variant = run->options->variant;
    run->result.given = run->values.count;
    if (status == PP_OK)
        exit_status = pp_job_run(&(struct pp_job){
            run->options->room.output, compute_comparison, print_compare, NULL, run});
    else
        exit_status = pp_message_error(&err);
    if (run->other)
        pp_compare_clear(&run->result.compared);
    pp_compare_destroy(run->compare);
    pp_compare_destroy(run->plain);
    pp_other_values_clear(&run->values);
    free(run->chosen);
    return exit_status;
}

/* Runs the command for scene files. The last file contains the values of the other
 * program. */
static enum pp_exit run_in_scene(struct compare_options *options, char **files,
                                 int file_count)
{
    struct compare_run compare = {.options = options, .other = files[file_count - 1]};
    struct pp_error err;
    if (pp_compare_scene_read(&compare.scene, (const char *const *)files,
                              file_count - 1, &err)
        != PP_OK)
        return pp_message_error(&err);
    enum pp_exit exit_status = run_comparison(&compare);
    pp_compare_scene_clear(&compare.scene);
    return exit_status;
}

static enum pp_exit run_compare(void *values, char **files, int file_count)
{
    struct compare_options *options = values;
    if (pp_compare_scene_is(files[0]))
        return run_in_scene(options, files, file_count);
    struct pp_rooms rooms;
    struct pp_error err;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "compare", files, 1, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct compare_run compare = {.options = options,
                                  .room = rooms.list,
                                  .other = file_count > 1 ? files[1] : NULL};
    if (rooms.count == 1) {
        exit_status = run_comparison(&compare);
    } else {
        pp_fail(&err, PP_BAD_INPUT,
                "%.200s: there are %d rooms; expected one, selected by --room NAME",
                files[0], rooms.count);
        exit_status = pp_message_error(&err);
    }
    pp_rooms_clear(&rooms);
    return exit_status;
}

static void clear_compare_options(void *values)
{
    pp_room_options_clear(&((struct compare_options *)values)->room);
}

const struct pp_command pp_command_compare = {
    .name = "compare",
    .summary = "compare another program's values with the simulation and find causes",
    .operands = "ROOM|SCENE... [OTHER.csv]",
    .about = about,
    .groups = groups,
    .size = sizeof(struct compare_options),
    .more_help = help_on_switches,
    .init = init_compare_options,
    .check = check_compare_options,
    .run = run_compare,
    .clear = clear_compare_options,
};
