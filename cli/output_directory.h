/* output_directory.h - writes results in several files: a directory that is written
 * completely or not at all.
 *
 * Output is collected in memory. pp_output_directory_commit writes it to a new
 * directory, which then replaces the named directory in one step. An existing directory
 * must be empty or, with `replace`, an export of the same kind. The names of all files
 * in the existing directory are checked first, so that no other file is lost.
 */
#ifndef PP_CLI_OUTPUT_DIRECTORY_H
#define PP_CLI_OUTPUT_DIRECTORY_H

#include <stdbool.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_output_directory_file {
    char *path;   /* path relative to the directory, with at most one "/" */
    bool runs;    /* true if the file is executable */
    FILE *stream; /* stream for the content of the file; NULL once closed */
    struct pp_gathered {
        char *bytes;
        size_t size;
    } * gathered; /* separate allocation, because streams keep its address */
};

struct pp_output_directory {
    char *path;
    bool replace;
    const char *const *known; /* names of files that may be replaced, ended by NULL; not
                               * owned */
    struct pp_output_directory_file *files;
    int count;
};

/* Opens the directory. Fails at once if it could not be written later. replace: an
 * existing export may be replaced. */
enum pp_status pp_output_directory_open(struct pp_output_directory *directory,
                                        const char *path, bool replace,
                                        const char *const *known, struct pp_error *err);

/* Adds a file. The caller prints its content to *stream. runs: the file is
 * executable. */
enum pp_status pp_output_directory_add(struct pp_output_directory *directory,
                                       const char *path, bool runs, FILE **stream,
                                       struct pp_error *err);

/* Writes all files. Closes the directory even after a failure. */
enum pp_status pp_output_directory_commit(struct pp_output_directory *directory,
                                          struct pp_error *err);

/* Closes the directory without changing anything. May be called after a commit. */
void pp_output_directory_clear(struct pp_output_directory *directory);

/* Removes a directory with everything in it. Returns 0 or an error number. */
int pp_output_directory_remove(const char *path);

#endif
