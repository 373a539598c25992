/* mesh_lines.h - reads a text file line by line, and reports errors with their lines.
 * Inside model/mesh/ only. */
#ifndef PP_MODEL_MESH_MESH_LINES_H
#define PP_MODEL_MESH_MESH_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

/* A text that is read by lines, which end with LF, CR LF or CR. `text` is not owned;
 * NULs replace the line ends as they are read. */
struct pp_mesh_lines {
    char *text; /* remaining text, NUL-terminated */
    size_t left;
    int line;         /* number of the line read last, from 1 */
    const char *file; /* name in messages; not owned */
};

/* Returns the next line; NULL at the end, or if the line contains a NUL (then
 * lines->left > 0). */
char *pp_mesh_lines_next(struct pp_mesh_lines *lines);

/* Fails with PP_BAD_INPUT, "FILE:LINE: ...". */
enum pp_status pp_mesh_lines_fail(const struct pp_mesh_lines *lines, int line,
                                  struct pp_error *err, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Fails with a message of mesh_triangles.h about a corner or a face; PP_OK if `why` is
 * NULL. */
enum pp_status pp_mesh_lines_say(const struct pp_mesh_lines *lines, int line,
                                 const char *why, struct pp_error *err);

#endif
