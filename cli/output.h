/* output.h - results that are written completely or not at all.
 *
 * Output is collected in memory. pp_output_commit writes it to standard output, or to a
 * new file beside the named one, which then replaces that file in one step. Until then
 * an existing file is unchanged, even if `path` is a symbolic link to it. Its
 * permissions are kept. Files that are not regular (a terminal, a pipe, /dev/null) are
 * written directly.
 */
#ifndef PP_CLI_OUTPUT_H
#define PP_CLI_OUTPUT_H

#include <stddef.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_output {
    FILE *stream; /* print here */
    char *path;   /* the file, symbolic links resolved; NULL: standard output */
    char *bytes;
    size_t size;
    char *temporary; /* new file beside `path`, not yet renamed; NULL: none */
};

/* path NULL or "-": standard output. Fails at once if the file cannot be written later:
 * its directory does not exist, it is itself a directory, or permission is missing. */
enum pp_status pp_output_open(struct pp_output *output, const char *path,
                              struct pp_error *err);

/* Checks that the file can be written later, before a long computation. Changes
 * nothing. */
enum pp_status pp_output_try(const char *path, struct pp_error *err);

/* Writes the collected output, and closes it even on failure. */
enum pp_status pp_output_commit(struct pp_output *output, struct pp_error *err);

/* The same for several outputs, all different. No file is replaced before the new
 * contents of all are on the disk. */
enum pp_status pp_output_commit_all(struct pp_output *outputs, int count,
                                    struct pp_error *err);

/* Closes the output without changing any file. May follow a commit. */
void pp_output_clear(struct pp_output *output);

/* A writer for pp_canvas_write (charts/sheet/canvas.h): stream is a FILE *. */
enum pp_status pp_output_put(void *stream, const unsigned char *bytes, size_t length,
                             struct pp_error *err);

/* Commits the output if `status` is PP_OK, else discards it. Returns the combined
 * status. */
enum pp_status pp_output_close(struct pp_output *output, enum pp_status status,
                               struct pp_error *err);

#endif
