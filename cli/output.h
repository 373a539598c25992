/* output.h - a result that appears whole or not at all.
 *
 * Output is collected in memory. pp_output_commit writes it to standard output, or to a
 * new file beside the named one, which then replaces that file in one step. Until that
 * step an existing file stays as it was, and so does a file behind a symbolic link; its
 * permissions are kept. Other than ordinary files (a terminal, a pipe, /dev/null) are
 * written directly.
 */
#ifndef PP_CLI_OUTPUT_H
#define PP_CLI_OUTPUT_H

#include <stddef.h>
#include <stdio.h>

#include "model/base/error.h"

struct pp_output {
    FILE *stream; /* print here */
    char *path;   /* the file itself, links followed; NULL: standard output */
    char *bytes;
    size_t size;
};

/* path NULL or "-": standard output. Fails early where the file could not be written
 * later on: no such directory, a directory, no permission. */
enum pp_status pp_output_open(struct pp_output *output, const char *path,
                              struct pp_error *err);

/* Would that file be written later on? Better asked before an hour's work. Leaves
 * everything as it was. */
enum pp_status pp_output_try(const char *path, struct pp_error *err);

/* Writes the collected output, and closes it in any case. */
enum pp_status pp_output_commit(struct pp_output *output, struct pp_error *err);

/* Closes the output and leaves everything as it was. May follow a commit. */
void pp_output_clear(struct pp_output *output);

/* A writer for pp_canvas_write (charts/sheet/canvas.h): stream is a FILE *. */
enum pp_status pp_output_put(void *stream, const unsigned char *bytes, size_t length,
                             struct pp_error *err);

/* Finishes an output: commits it if `status` is PP_OK, else abandons it. Returns the
 * combined status. */
enum pp_status pp_output_close(struct pp_output *output, enum pp_status status,
                               struct pp_error *err);

#endif
