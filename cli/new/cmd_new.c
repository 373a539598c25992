/* cmd_new.c - the command new: writes a commented room file as a starting point. */
#include <ctype.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/output.h"
#include "model/base/text.h"
#include "reports/parts/format.h"

struct room_template {
    const char *name, *summary, *text;
};

/* FILE.xml in the texts is a placeholder for the name of the file. */
static const struct room_template templates[] = {
    {
        "office",
        "a room with two windows and a building opposite",
#include "cli/new/new_office.inc"
    },
    {
        "flat",
        "two rooms of a building in a street",
#include "cli/new/new_flat.inc"
    },
    {
        "classroom",
        "a room with windows on two sides and a skyline",
#include "cli/new/new_classroom.inc"
    },
    {
        "attic",
        "a room under a pitched roof with roof windows",
#include "cli/new/new_attic.inc"
    },
};
enum { TEMPLATES = sizeof templates / sizeof *templates };

static const char about[] =
    "Writes a commented room file to start from. KIND is one of the rooms below. "
    "Change its numbers, then run pepperpot df FILE.";

struct new_options {
    const char *output;
    bool force;
};

static const struct pp_option output_options[] = {
    {"output", 'o', "FILE", "Write to FILE instead of standard output.",
     pp_options_read_output, offsetof(struct new_options, output)},
    {"force", 0, NULL, "Replace FILE if it exists.", NULL,
     offsetof(struct new_options, force)},
    {0},
};

static void print_templates(FILE *out)
{
    fputs("\nRooms:\n", out);
    for (int i = 0; i < TEMPLATES; i++)
        pp_options_help_word(templates[i].name, templates[i].summary, out);
}

/* Finds a template by name; NULL: there is none. */
static const struct room_template *find_template(const char *name)
{
    for (int i = 0; i < TEMPLATES; i++)
        if (strcmp(templates[i].name, name) == 0)
            return &templates[i];
    return NULL;
}

static void init_new(void *values)
{
    *(struct new_options *)values = (struct new_options){0};
}

/* Checks that the file may be written. An existing regular file requires --force;
 * devices and pipes do not. */
static enum pp_status check_new_file(const struct new_options *options,
                                     struct pp_error *err)
{
    struct stat there;
    const char *path = options->output;
    if (!path || strcmp(path, "-") == 0 || options->force || stat(path, &there) != 0
        || S_ISCHR(there.st_mode) || S_ISFIFO(there.st_mode))
        return PP_OK;
    return pp_fail(
        err, PP_BAD_INPUT,
        "\"%.200s\" already exists; expected another name, or --force to replace it",
        path);
}

static enum pp_status check_new(void *values, char **words, int count,
                                struct pp_error *err)
{
    const struct new_options *options = values;
    const char *names[TEMPLATES];
    char known[128], question[128];
    for (int i = 0; i < TEMPLATES; i++)
        names[i] = templates[i].name;
    pp_text_list_names(known, sizeof known, names, TEMPLATES);
    if (count != 1)
        return pp_fail(err, PP_BAD_INPUT, "expected one kind of room: %s", known);
    if (!find_template(words[0])) {
        pp_text_did_you_mean(question, sizeof question, "",
                             pp_text_nearest(words[0], names, TEMPLATES), "");
        return pp_fail(err, PP_BAD_INPUT, "there is no room \"%s\"%s%s; expected %s",
                       words[0], question[0] ? "; " : "", question, known);
    }
    return check_new_file(options, err);
}

/* Prints the text with the file's name in place of FILE.xml. */
static void print_text(const char *text, const char *file, FILE *out)
{
    static const char placeholder[] = "FILE.xml";
    const char *found;
    for (; (found = strstr(text, placeholder)); text = found + strlen(placeholder)) {
        fwrite(text, 1, (size_t)(found - text), out);
        fputs(file, out);
    }
    fputs(text, out);
}

/* True if an XML comment may contain the name, that is, if the name is UTF-8 without
 * control characters and without "--". */
static bool fits_comment(const char *name)
{
    char *repaired = pp_format_utf8_repair(name);
    bool fits = repaired && strcmp(repaired, name) == 0 && !strstr(name, "--");
    for (const char *at = name; *at && fits; at++)
        fits = !iscntrl((unsigned char)*at) || (unsigned char)*at >= 0x80;
    free(repaired);
    return fits;
}

/* Name of the file for the comments: name of the output, or FILE.xml. */
static const char *file_name(const struct new_options *options)
{
    const char *path = options->output;
    struct stat there;
    if (!path || strcmp(path, "-") == 0
        || (stat(path, &there) == 0 && !S_ISREG(there.st_mode)))
        return "FILE.xml";
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    return fits_comment(name) ? name : "FILE.xml";
}

static enum pp_exit run_new(void *values, char **words, int count)
{
    (void)count;
    const struct new_options *options = values;
    struct pp_output output;
    struct pp_error err = {0};
    enum pp_status status = pp_output_open(&output, options->output, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    print_text(find_template(words[0])->text, file_name(options), output.stream);
    status = pp_output_close(&output, PP_OK, &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

static void clear_new(void *values)
{
    (void)values;
}

static const struct pp_option_group groups[] = {
    {"Output", output_options, 0},
    {0},
};

const struct pp_command pp_command_new = {
    .name = "new",
    .summary = "a commented room file to start from",
    .operands = "KIND",
    .about = about,
    .groups = groups,
    .size = sizeof(struct new_options),
    .more_help = print_templates,
    .init = init_new,
    .check = check_new,
    .run = run_new,
    .clear = clear_new,
    .words_before_files = 1,
};
