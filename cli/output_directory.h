/* output_directory.h - results of several files: a directory that appears whole or not
 * at all.
 *
 * Output is collected in memory. pp_output_directory_commit writes it to a new
 * directory beside the named one, which then replaces that in one step. An existing
 * directory must be empty, or an export of the same kind. The names of all its files
 * are checked first, so that no other file is ever lost.
 */
#ifndef PP_CLI_OUTPUT_DIRECTORY_H
#define PP_CLI_OUTPUT_DIRECTORY_H

#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_output_directory_file {
    char *path;   /* in the directory; with one "/" at most */
    bool runs;    /* a program */
    FILE *stream; /* NULL once closed */
    struct pp_gathered {
        char *bytes;
        size_t size;
    } * gathered; /* stays where it is: the stream writes to it */
};

struct pp_output_directory {
    char *path;
    bool replace;
    const char *const *known; /* names of files that may be replaced; ends with NULL;
                               * not owned */
    struct pp_output_directory_file *files;
    int count;
};

/* Fails early where it could not be written later on. `replace`: an existing export may
 * be. */
enum pp_status pp_output_directory_open(struct pp_output_directory *directory,
                                        const char *path, bool replace,
                                        const char *const *known, struct pp_error *err);

/* A new file; print to *stream. */
enum pp_status pp_output_directory_add(struct pp_output_directory *directory,
                                       const char *path, bool runs, FILE **stream,
                                       struct pp_error *err);

/* Writes all, and closes the directory whether it succeeds or not. */
enum pp_status pp_output_directory_commit(struct pp_output_directory *directory,
                                          struct pp_error *err);

/* Closes it and leaves everything as it was. May follow a commit. */
void pp_output_directory_clear(struct pp_output_directory *directory);

/* Takes a directory made by this program away, with its files and theirs, one deep. */
int pp_output_directory_remove(const char *path);

#endif
