/* output_directory.h - results in several files: a directory that is written completely
 * or not at all.
 *
 * Output is collected in memory. pp_output_directory_commit writes it to a new
 * directory beside the named one, which it then replaces in one step. An existing
 * directory must be empty or, with `replace`, an export of the same kind. The names of
 * all its files are checked first, so that no other file is ever lost.
 */
#ifndef PP_CLI_OUTPUT_DIRECTORY_H
#define PP_CLI_OUTPUT_DIRECTORY_H

#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_output_directory_file {
    char *path;   /* path in the directory, with at most one "/" */
    bool runs;    /* a program */
    FILE *stream; /* NULL once closed */
    struct pp_gathered {
        char *bytes;
        size_t size;
    } * gathered; /* the array must not move: streams point to its elements */
};

struct pp_output_directory {
    char *path;
    bool replace;
    const char *const *known; /* names of files that may be replaced; ends with NULL;
                               * not owned */
    struct pp_output_directory_file *files;
    int count;
};

/* Fails at once if the directory cannot be written later. `replace`: an existing export
 * may be replaced. */
enum pp_status pp_output_directory_open(struct pp_output_directory *directory,
                                        const char *path, bool replace,
                                        const char *const *known, struct pp_error *err);

/* Adds a file, whose content is printed to *stream by the caller; runs: it is
 * executable. */
enum pp_status pp_output_directory_add(struct pp_output_directory *directory,
                                       const char *path, bool runs, FILE **stream,
                                       struct pp_error *err);

/* Writes all files, and closes the directory even on failure. */
enum pp_status pp_output_directory_commit(struct pp_output_directory *directory,
                                          struct pp_error *err);

/* Closes the directory without changing anything. May follow a commit. */
void pp_output_directory_clear(struct pp_output_directory *directory);

/* Removes a directory made by this program, with its files and with its subdirectories,
 * which contain only files. */
int pp_output_directory_remove(const char *path);

#endif
