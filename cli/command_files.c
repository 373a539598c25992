/* command_files.c - tells by device and inode whether two files that are named are
 * one. */
#include "cli/command_files.h"

#include <libgen.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { FILES_MOST = 16 };

struct named_file {
    const char *option; /* "--output"; without its dashes */
    const char *path;
    bool written;
};

/* The directory of a path, and the file's name in it. */
static bool split(const char *path, struct stat *directory, char name[PATH_MAX])
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

/* Do both name one file, or would they once it is written? Devices are no files here:
 * what goes to /dev/null may go there twice. */
static bool is_same_file(const char *a, const char *b)
{
    if (strcmp(a, "-") == 0 || strcmp(b, "-") == 0)
        return false;
    struct stat of_a, of_b;
    bool is_a = stat(a, &of_a) == 0, is_b = stat(b, &of_b) == 0;
    if (is_a && is_b)
        return S_ISREG(of_a.st_mode) && is_same_place(&of_a, &of_b);
    char name_a[PATH_MAX], name_b[PATH_MAX];
    return !is_a && !is_b && split(a, &of_a, name_a) && split(b, &of_b, name_b)
           && strcmp(name_a, name_b) == 0 && is_same_place(&of_a, &of_b);
}

/* The files that options name. */
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

enum pp_status pp_command_files_apart(const struct pp_command_line *line, char **files,
                                      int file_count, struct pp_error *err)
{
    struct named_file list[FILES_MOST];
    int count = list_files(list, line);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < count; k++)
            if (k != i && list[i].written && is_same_file(list[i].path, list[k].path))
                return pp_fail(err, PP_BAD_INPUT,
                               "--%s and --%s are one file, \"%.200s\"; expected two",
                               list[i].option, list[k].option, list[i].path);
        for (int k = 0; k < file_count && list[i].written; k++)
            if (is_same_file(list[i].path, files[k]))
                return pp_fail(err, PP_BAD_INPUT,
                               "--%s would write over \"%.200s\", which is read; "
                               "expected another file",
                               list[i].option, files[k]);
    }
    return PP_OK;
}
