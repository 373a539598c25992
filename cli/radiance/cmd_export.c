/* cmd_export.c - the command export: writes rooms in the format of another program. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/moment_choice.h"
#include "cli/radiance/radiance_export.h"
#include "cli/rooms.h"
#include "reports/parts/format.h"
#include "model/base/read_file.h"
#include "model/light/rough/rough_finishes.h"
#include "formats/radiance/write/rad_room.h"

/* Default horizontal illuminance under the open sky (lx). */
static const double DEFAULT_LUX = 10000.0;

static const char about[] =
    "Writes a room as scene files for another program. FILE is a room file; - is "
    "standard input. For Radiance, materials, geometry, glazing, sky, ground and "
    "reference points are written to the directory DIR. A script in DIR calculates "
    "the same daylight factors with rtrace. If there are several rooms, each gets "
    "its own directory. DIR is written completely or not at all.";

struct export_options {
    struct pp_room_options room;
    const char *to;
    const char *directory;
    bool force, gloss;
    double external_lux;
    struct pp_moment_choice moment;
};

static enum pp_status read_program(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "radiance") != 0)
        return pp_fail(err, PP_BAD_INPUT, "radiance");
    *(const char **)place = text;
    return PP_OK;
}

static const struct pp_option to_options[] = {
    {"to", 't', "PROGRAM", "Target format: radiance.", read_program,
     offsetof(struct export_options, to)},
    {"external", 0, "LUX",
     "External horizontal illuminance under the exported sky (default 10000).",
     pp_options_read_lux, offsetof(struct export_options, external_lux)},
    {"gloss", 0, NULL,
     "Export the colour and gloss of finishes, for pictures. By default they are matt "
     "and grey, as for daylight factors.",
     NULL, offsetof(struct export_options, gloss)},
    {0},
};

static const struct pp_option output_options[] = {
    {"output", 'o', "DIR", "Directory for the files; it must be new or empty.",
     pp_options_read_text, offsetof(struct export_options, directory)},
    {"force", 0, NULL,
     "Replace DIR if it contains an export; other directories are never replaced.",
     NULL, offsetof(struct export_options, force)},
    {0},
};

/* ---- folders of several rooms ---- */

enum { FOLDER_MOST = 60 }; /* bytes, without the number that may be appended */

static bool is_taken(const char *folder, char *const *before, int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(before[i], folder) == 0)
            return true;
    return false;
}

/* True if the first character of `text`, which has `length` bytes, is allowed in the
 * name of a folder. */
static bool is_fit(const char *text, int length)
{
    unsigned char c = (unsigned char)text[0];
    if (length > 1)
        return c != 0xc2 || (unsigned char)text[1] >= 0xa0; /* C1 control characters are
                                                             * not allowed */
    return c > ' ' && c < 127 && !strchr("/\\:*?\"<>|'`$&;#", c);
}

/* Makes a folder name for a room that differs from the names in `before`. The caller
 * frees the name. NULL: out of memory. */
static char *folder_of(const struct pp_rooms *rooms, int which, char *const *before)
{
    const char *name = rooms->list[which].world->name;
    char fit[FOLDER_MOST + 20];
    int count = 0;
    for (int length; name && *name; name += length) {
        length = pp_format_utf8_length(name);
        if (count + length > FOLDER_MOST)
            break;
        if (is_fit(name, length)) {
            memcpy(fit + count, name, (size_t)length);
            count += length;
        } else if (count > 0 && fit[count - 1] != '-') {
            fit[count++] = '-';
        }
    }
    while (count > 0 && fit[count - 1] == '-')
        count--;
    fit[count] = '\0';
    if (count == 0 || fit[0] == '.' || fit[0] == '-')
        count = snprintf(fit, sizeof fit, "room-%d", which + 1);
    for (int next = which + 1; is_taken(fit, before, which); next++)
        snprintf(fit + count, sizeof fit - (size_t)count, "-%d", next);
    return strdup(fit);
}

/* Replaces a room's sky by the sky and sun of the moment. *external_lux: horizontal
 * illuminance from that sky; note: comment with the Radiance command for a similar sky;
 * empty for standard skies. */
static enum pp_status take_moment(struct pp_study_room *room,
                                  const struct pp_moment_choice *choice,
                                  double *external_lux, char *note, size_t size,
                                  struct pp_error *err)
{
    struct pp_moment moment;
    double north_rad = room->world->north_rad;
    enum pp_status status = pp_moment_choice_find(&moment, choice, room->world, err);
    if (status == PP_OK)
        status = pp_moment_turn_slats(room->world, &moment, err);
    if (status == PP_OK)
        status = pp_moment_light(&room->light, &moment, north_rad, err);
    if (status != PP_OK)
        return status;
    struct pp_vec3 sun = room->light.sky.sun;
    double west_of_south = atan2(-sun.x, -sun.y) / PP_RAD;
    *external_lux = moment.sky.diffuse_lx;
    *note = '\0';
    if (strcmp(moment.sky_name, "perez") == 0)
        snprintf(
            note, size,
            "approximately the same sky by illuminances: !gendaylit -ang %.3f %.3f -L "
            "%.0f %.0f",
            asin(sun.z) / PP_RAD, west_of_south, moment.sky.direct_lx,
            moment.sky.diffuse_lx);
    return PP_OK;
}

static enum pp_status add_rooms(struct pp_output_directory *directory,
                                const struct pp_rooms *rooms,
                                const struct export_options *options,
                                struct pp_error *err)
{
    char **folders = calloc((size_t)rooms->count + 1, sizeof *folders);
    enum pp_status status = folders ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        struct pp_study_room *room = &rooms->list[i];
        double external_lux = options->external_lux;
        char note[160] = "";
        bool of_moment = pp_moment_choice_said(&options->moment);
        if (rooms->several && !(folders[i] = folder_of(rooms, i, folders)))
            status = pp_fail_memory(err);
        struct pp_error said;
        if (status == PP_OK && of_moment)
            status = take_moment(room, &options->moment, &external_lux, note,
                                 sizeof note, &said);
        if (status == PP_OK)
            status = pp_radiance_export(directory, folders[i], room, external_lux,
                                        options->gloss, *note ? note : NULL, &said);
        if (status != PP_OK && folders[i] == NULL && rooms->several)
            break;
        if (status == PP_BAD_INPUT)
            status = pp_fail(err, status, "%s: %.600s", pp_read_file_title(room->file),
                             said.message);
        else if (status != PP_OK)
            status = pp_fail(err, status, "%s", said.message);
    }
    for (int i = 0; folders && i < rooms->count; i++)
        free(folders[i]);
    free(folders);
    return status;
}

/* ---- parts omitted from the scene ---- */

static bool has_pattern(const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].pattern_mean > 0.0)
            return true;
    return false;
}

static void say_left_out(const struct pp_rooms *rooms, bool gloss)
{
    for (int i = 0; i < rooms->count; i++) {
        const struct pp_world *world = rooms->list[i].world;
        const char *file = pp_read_file_title(rooms->list[i].file);
        if (world->decorations < 1.0)
            pp_message("%.200s: the scene does not include the allowance of %g for "
                       "deterioration of decorations in the internally reflected "
                       "component, so its daylight factors are higher",
                       file, world->decorations);
        if (gloss && pp_rough_finishes_rough_count(world->materials) > 0
            && (i == 0 || strcmp(rooms->list[i].file, rooms->list[i - 1].file) != 0))
            pp_message(
                "%.200s: each rough <material> becomes a metal or plastic with the "
                "same reflectance for diffuse light; its spike, and the change "
                "of its lobe with angle and wavelength, are lost",
                file);
        if (has_pattern(world))
            pp_message("%.200s: each surface with a pattern or bumps is even in the "
                       "scene, with the mean of its reflectance",
                       file);
        if (!gloss && pp_rad_room_has_gloss(world))
            pp_message("%.200s: finishes in the scene are matt and grey, as for "
                       "daylight factors; use --gloss to export colour and gloss",
                       file);
    }
}

static enum pp_exit run_export(void *values, char **files, int file_count)
{
    struct export_options *options = values;
    struct pp_rooms rooms;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "export", files, file_count, &options->room);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    exit_status = pp_moment_choice_load(&options->moment, options->room.study.strict);
    if (exit_status != PP_EXIT_DONE) {
        pp_rooms_clear(&rooms);
        return exit_status;
    }
    struct pp_error err = {0};
    struct pp_output_directory directory;
    enum pp_status status = pp_output_directory_open(
        &directory, options->directory, options->force, pp_radiance_files, &err);
    if (status == PP_OK)
        status = add_rooms(&directory, &rooms, options, &err);
    if (status == PP_OK)
        status = pp_output_directory_commit(&directory, &err);
    if (status != PP_OK) {
        pp_output_directory_clear(&directory);
        exit_status = pp_message_error(&err);
    } else if (!options->room.quiet) {
        say_left_out(&rooms, options->gloss);
    }
    pp_rooms_clear(&rooms);
    return exit_status;
}

static enum pp_status check_export_options(void *values, char **files, int file_count,
                                           struct pp_error *err)
{
    struct export_options *options = values;
    (void)files;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (!options->to)
        return pp_fail(err, PP_BAD_INPUT, "expected --to radiance");
    if (!options->directory)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected -o DIR, the directory for the files");
    if (strcmp(options->directory, "-") == 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "-o is \"-\"; expected a directory, because an export has several files");
    options->room.study.external_lux = options->external_lux;
    enum pp_status status =
        pp_moment_choice_settle(&options->moment, &options->room, err);
    if (status != PP_OK)
        return status;
    if (!(options->external_lux > 0.0))
        options->external_lux = DEFAULT_LUX;
    return PP_OK;
}

static const struct pp_option quiet_option[] = {
    {"quiet", 'q', NULL, "Do not list features that the scene does not include.", NULL,
     offsetof(struct export_options, room.quiet)},
    {0},
};

static const struct pp_option_group groups[] = {
    {"Export", to_options, 0},
    PP_ROOM_PLACE_GROUPS("Export", offsetof(struct export_options, room)),
    {"Export", pp_moment_when_option, offsetof(struct export_options, moment)},
    {"Export", pp_moment_weather_option, offsetof(struct export_options, moment)},
    {"Output", output_options, 0},
    {"Output", quiet_option, 0},
    {0},
};

static void init_export_options(void *values)
{
    *(struct export_options *)values =
        (struct export_options){.room = pp_room_options_none};
}

static void clear_export_options(void *values)
{
    struct export_options *options = values;
    pp_moment_choice_clear(&options->moment);
    pp_room_options_clear(&options->room);
}

const struct pp_command pp_command_export = {
    .name = "export",
    .summary = "export a room to Radiance",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct export_options),
    .init = init_export_options,
    .check = check_export_options,
    .run = run_export,
    .clear = clear_export_options,
};
