/* command.c - runs a command: reads and checks its options, runs it, cleans up. Also
 * checks that no output file is named elsewhere on the command line. */
#include "cli/command.h"

#include <libgen.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/message.h"

static struct pp_command_line line_of(const struct pp_command *command, void *options)
{
    return (struct pp_command_line){.command = command->name,
                                    .operands = command->operands,
                                    .about = command->about,
                                    .groups = command->groups,
                                    .more_help = command->more_help,
                                    .values = options};
}

void pp_command_help(const struct pp_command *command, FILE *out)
{
    const struct pp_command_line line = line_of(command, NULL);
    pp_options_help(&line, out);
}

/* ---- files of a command line ---- */

enum { FILES_MOST = 16 };

struct named_file {
    const char *option; /* name of the option without dashes, such as "output" */
    const char *path;
    bool written;
};

/* Splits a path into directory and file name. Returns false if there is no such
 * directory, or if the path is too long. */
static bool split_path(const char *path, struct stat *directory, char name[PATH_MAX])
{
    char copy[PATH_MAX];
    if (strlen(path) >= sizeof copy)
        return false;
    strcpy(copy, path);
    strcpy(name, basename(copy));
    strcpy(copy, path);
    return stat(dirname(copy), directory) == 0;
}

static bool is_same_place(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* True if both names denote the same file, or will do so once the file is written.
 * Devices are never the same, since two outputs may go to /dev/null. */
static bool is_same_file(const char *a, const char *b)
{
    if (strcmp(a, "-") == 0 || strcmp(b, "-") == 0)
        return false;
    struct stat of_a, of_b;
    bool is_a = stat(a, &of_a) == 0, is_b = stat(b, &of_b) == 0;
    if (is_a && is_b)
        return S_ISREG(of_a.st_mode) && is_same_place(&of_a, &of_b);
    char name_a[PATH_MAX], name_b[PATH_MAX];
    return !is_a && !is_b && split_path(a, &of_a, name_a)
           && split_path(b, &of_b, name_b) && strcmp(name_a, name_b) == 0
           && is_same_place(&of_a, &of_b);
}

/* Lists the files that options name. */
static int list_files(struct named_file *list, const struct pp_command_line *line)
{
    int count = 0;
    for (const struct pp_option_group *group = line->groups; group->title; group++)
        for (const struct pp_option *option = group->options; option->name; option++) {
            bool written = option->read == pp_options_read_output
                           || option->read == pp_options_read_updated;
            if ((!written && option->read != pp_options_read_input)
                || count == FILES_MOST)
                continue;
            const char *path =
                *(const char **)((char *)line->values + group->offset + option->offset);
            if (path)
                list[count++] = (struct named_file){option->name, path, written};
        }
    return count;
}

/* Checks that a file written by an option is not also named by another option or
 * operand (`files`); otherwise PP_BAD_INPUT. Files are compared by device and inode, so
 * different names of the same file are found. Options with the reader
 * pp_options_read_output or pp_options_read_updated write files; those with
 * pp_options_read_input read files. */
static enum pp_status check_files_apart(const struct pp_command_line *line,
                                        char **files, int file_count,
                                        struct pp_error *err)
{
    struct named_file list[FILES_MOST];
    int count = list_files(list, line);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < count; k++)
            if (k != i && list[i].written && is_same_file(list[i].path, list[k].path))
                return pp_fail(err, PP_BAD_INPUT,
                               "--%s and --%s are the same file, \"%.200s\"; expected "
                               "two different files",
                               list[i].option, list[k].option, list[i].path);
        for (int k = 0; k < file_count && list[i].written; k++)
            if (is_same_file(list[i].path, files[k]))
                return pp_fail(err, PP_BAD_INPUT,
                               "--%s would overwrite the input file \"%.200s\"; "
                               "expected another file",
                               list[i].option, files[k]);
    }
    return PP_OK;
}

/* Checks that standard input is named at most once among options and operands
 * (`files`); otherwise PP_BAD_INPUT. */
static enum pp_status check_input_once(const struct pp_command_line *line, char **files,
                                       int file_count, struct pp_error *err)
{
    struct named_file list[FILES_MOST];
    int count = list_files(list, line), operands = 0;
    const char *first = NULL;
    for (int i = 0; i < file_count; i++)
        operands += strcmp(files[i], "-") == 0;
    if (operands > 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "standard input can be read only once, but %d files are -; "
                       "expected the names of files",
                       operands);
    for (int i = 0; i < count; i++) {
        if (list[i].written || strcmp(list[i].path, "-") != 0)
            continue;
        if (first || operands > 0)
            return pp_fail(err, PP_BAD_INPUT,
                           "standard input can be read only once, but --%s and %s%s "
                           "are both -; expected the name of a file",
                           list[i].option, first ? "--" : "", first ? first : "FILE");
        first = list[i].option;
    }
    return PP_OK;
}

/* ---- a command ---- */

static enum pp_exit run_with(const struct pp_command *command, void *options, int argc,
                             char **argv)
{
    const struct pp_command_line line = line_of(command, options);
    struct pp_error err = {0};
    int count;
    bool wants_help;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &count, &wants_help, &err);
    if (status == PP_OK && wants_help) {
        pp_options_help(&line, stdout);
        return PP_EXIT_DONE;
    }
    int words =
        count < command->words_before_files ? count : command->words_before_files;
    if (status == PP_OK)
        status = check_input_once(&line, argv + words, count - words, &err);
    if (status == PP_OK)
        status = command->check(options, argv, count, &err);
    if (status == PP_OK)
        status = check_files_apart(&line, argv + words, count - words, &err);
    if (status == PP_SYSTEM)
        return pp_message_error(&err);
    return status == PP_OK ? command->run(options, argv, count)
                           : pp_message_usage(command->name, &err);
}

enum pp_exit pp_command_run(const struct pp_command *command, int argc, char **argv,
                            const struct pp_ranks *ranks)
{
    struct pp_error err;
    if (ranks && ranks->rank > 0 && !command->uses_ranks)
        return PP_EXIT_DONE;
    void *options = calloc(1, command->size);
    if (!options) {
        pp_fail_memory(&err);
        return pp_message_error(&err);
    }
    command->init(options);
    if (command->uses_ranks)
        *(const struct pp_ranks **)((char *)options + command->ranks_place) = ranks;
    enum pp_exit exit_status = run_with(command, options, argc, argv);
    command->clear(options);
    free(options);
    return exit_status;
}
