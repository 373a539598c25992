/* export - a room in another program's format. */
#include <stdlib.h>
#include <string.h>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/radiance_export.h"
#include "cli/rooms.h"

/* Of the open level ground, where nothing else is asked for. */
static const double DEFAULT_LUX = 10000.0;

static const char about[] =
    "A room as scene files of another program. FILE is a room file; - is standard "
    "input. For Radiance, the directory DIR gets materials, geometry, glazing, sky, "
    "ground, the reference points, and a script that works out the same daylight "
    "factors by rtrace; of a building or several files, one directory in it for each "
    "room. It appears whole or not at all.";

struct export_options {
    const char *to;
    const char *directory;
    bool force;
    double external_lux;
};

static enum pp_status read_program(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "radiance") != 0)
        return pp_fail(err, PP_BAD_INPUT, "radiance");
    *(const char **)place = text;
    return PP_OK;
}

static const struct pp_option to_options[] = {
    {"to", 't', "PROGRAM", "Whose format: radiance.", read_program,
     offsetof(struct export_options, to)},
    {"external", 0, "LUX",
     "Illuminance of the open level ground under the sky that is written (default "
     "10000).",
     pp_read_lux, offsetof(struct export_options, external_lux)},
    {0},
};

static const struct pp_option output_options[] = {
    {"output", 'o', "DIR", "Directory to write: a new or an empty one.", pp_read_text,
     offsetof(struct export_options, directory)},
    {"force", 0, NULL,
     "Replace DIR where it holds an export; where it holds anything else it is left "
     "alone.",
     NULL, offsetof(struct export_options, force)},
    {0},
};

/* ---- folders of several rooms ---- */

/* A room's name as that of a folder, unlike those before; the caller's. */
static char *folder_of(const struct pp_rooms *rooms, int which, char *const *before)
{
    const char *name = rooms->list[which].world->name;
    char fit[80];
    int count = 0;
    for (; name && *name && count < 60; name++) {
        unsigned char c = (unsigned char)*name;
        bool good = c > ' ' && c != 127 && !strchr("/\\:*?\"<>|'`$&;#", c);
        if (good)
            fit[count++] = (char)c;
        else if (count > 0 && fit[count - 1] != '-')
            fit[count++] = '-';
    }
    while (count > 0 && ((unsigned char)fit[count - 1] & 0xC0) == 0x80 && count >= 60)
        count--; /* not in the middle of a character */
    fit[count] = '\0';
    if (count == 0 || fit[0] == '.')
        snprintf(fit, sizeof fit, "room-%d", which + 1);
    char *folder = strdup(fit);
    for (int i = 0; i < which && folder; i++)
        if (strcmp(before[i], folder) == 0) {
            free(folder);
            return asprintf(&folder, "%s-%d", fit, which + 1) < 0 ? NULL : folder;
        }
    return folder;
}

static enum pp_status add_rooms(struct pp_directory *directory,
                                const struct pp_rooms *rooms, double external_lux,
                                struct pp_error *err)
{
    char **folders = calloc((size_t)rooms->count + 1, sizeof *folders);
    enum pp_status status = folders ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < rooms->count && status == PP_OK; i++) {
        const struct pp_loaded_room *room = &rooms->list[i];
        if (rooms->several && !(folders[i] = folder_of(rooms, i, folders)))
            status = pp_fail_memory(err);
        struct pp_error said;
        if (status == PP_OK)
            status =
                pp_radiance_export(directory, folders[i], room, external_lux, &said);
        if (status != PP_OK && folders[i] == NULL && rooms->several)
            break;
        if (status == PP_BAD_INPUT)
            status =
                pp_fail(err, status, "%s: %.900s",
                        strcmp(room->file, "-") == 0 ? "standard input" : room->file,
                        said.message);
        else if (status != PP_OK)
            status = pp_fail(err, status, "%s", said.message);
    }
    for (int i = 0; folders && i < rooms->count; i++)
        free(folders[i]);
    free(folders);
    return status;
}

/* What the scene leaves out. */
static void say_left_out(const struct pp_rooms *rooms)
{
    for (int i = 0; i < rooms->count; i++)
        if (rooms->list[i].world->decorations < 1.0)
            pp_say("%s: the scene leaves out the allowance of %g on the internally "
                   "reflected component for decorations; its daylight factors are "
                   "higher by that",
                   rooms->list[i].file, rooms->list[i].world->decorations);
}

static enum pp_exit run(const struct export_options *options,
                        const struct pp_room_options *room_options, char **files,
                        int file_count)
{
    struct pp_rooms rooms;
    enum pp_exit exit_status =
        pp_rooms_load(&rooms, "export", files, file_count, room_options);
    if (exit_status != PP_EXIT_DONE)
        return exit_status;
    struct pp_error err = {0};
    struct pp_directory directory;
    enum pp_status status = pp_directory_open(&directory, options->directory,
                                              options->force, pp_radiance_files, &err);
    if (status == PP_OK)
        status = add_rooms(&directory, &rooms, options->external_lux, &err);
    if (status == PP_OK)
        status = pp_directory_commit(&directory, &err);
    if (status != PP_OK) {
        pp_directory_abandon(&directory);
        exit_status = pp_say_error(&err);
    } else if (!room_options->quiet) {
        say_left_out(&rooms);
    }
    pp_rooms_clear(&rooms);
    return exit_status;
}

static enum pp_status check(struct export_options *options, int file_count,
                            struct pp_error *err)
{
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    if (!options->to)
        return pp_fail(err, PP_BAD_INPUT, "expected --to radiance");
    if (!options->directory)
        return pp_fail(err, PP_BAD_INPUT, "expected -o DIR, the directory to write");
    if (strcmp(options->directory, "-") == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "-o is \"-\"; expected a directory: an export is several files");
    if (!(options->external_lux > 0.0))
        options->external_lux = DEFAULT_LUX;
    return PP_OK;
}

static const struct pp_option quiet_option[] = {
    {"quiet", 'q', NULL, "Say nothing of what the scene leaves out.", NULL,
     offsetof(struct pp_room_options, quiet)},
    {0},
};

enum pp_exit cmd_export(int argc, char **argv)
{
    struct export_options options = {0};
    struct pp_room_options room_options = pp_room_options_none;
    const struct pp_option_group groups[] = {
        {"What is written", to_options, &options},
        {"What is written", pp_room_place_options, &room_options},
        {"Output", output_options, &options},
        {"Output", quiet_option, &room_options},
        {0},
    };
    const struct pp_command_line line = {"export", "FILE...", about, groups, NULL};

    struct pp_error err = {0};
    int file_count;
    bool wants_help;
    enum pp_exit exit_status;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &file_count, &wants_help, &err);
    if (status == PP_OK && !wants_help)
        status = check(&options, file_count, &err);

    if (pp_command_starts(&line, status, wants_help, &err, &exit_status))
        exit_status = run(&options, &room_options, argv, file_count);
    pp_room_options_clear(&room_options);
    return exit_status;
}
