/* output.h - writes results completely or not at all.
 *
 * Output is collected in memory. pp_output_commit writes it to standard output, or to a
 * new file, which then replaces the target in one step. Until then an existing target
 * is unchanged, even if `path` is a symbolic link to it. The permissions of the target
 * are kept. Files that are not regular (a terminal, a pipe, /dev/null) are written
 * directly.
 */
#ifndef PP_CLI_OUTPUT_H
#define PP_CLI_OUTPUT_H

#include <stddef.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_output {
    FILE *stream; /* stream for printing the output */
    char *path;   /* path of the file, with symbolic links resolved; NULL: standard
                   * output */
    char *bytes;
    size_t size;
    char *temporary; /* path of the new file before it is renamed; NULL: none */
};

/* Opens an output; path NULL or "-": standard output. Fails at once if the file could
 * not be written later because its directory does not exist, it is a directory, or
 * permission is missing. */
enum pp_status pp_output_open(struct pp_output *output, const char *path,
                              struct pp_error *err);

/* Checks, before a long computation, that the file can be written later. Does not
 * change anything. */
enum pp_status pp_output_try(const char *path, struct pp_error *err);

/* Writes the collected output, and closes the output even after a failure. */
enum pp_status pp_output_commit(struct pp_output *output, struct pp_error *err);

/* Commits several outputs, which must all be different files. No file is replaced
 * before the new contents of all files are on the disk. */
enum pp_status pp_output_commit_all(struct pp_output *outputs, int count,
                                    struct pp_error *err);

/* Closes the output without changing any file. May be called after a commit. */
void pp_output_clear(struct pp_output *output);

/* Writer for pp_canvas_write (charts/sheet/canvas.h). stream: a FILE *. */
enum pp_status pp_output_put(void *stream, const unsigned char *bytes, size_t length,
                             struct pp_error *err);

/* Commits the output if `status` is PP_OK, else discards it. Returns `status`, or the
 * status of the commit. */
enum pp_status pp_output_close(struct pp_output *output, enum pp_status status,
                               struct pp_error *err);

#endif
