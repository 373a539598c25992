/* mesh_lines.h - a file read line by line, and errors on its lines. Inside model/mesh/
 * only. */
#ifndef PP_MODEL_MESH_MESH_LINES_H
#define PP_MODEL_MESH_MESH_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

/* Lines end with LF, CR LF or CR; `text` is not owned, and is cut by zeros as it is
 * read. */
struct pp_mesh_lines {
    char *text; /* the remaining text, followed by a 0 */
    size_t left;
    int line;         /* the last that was read, from 1 */
    const char *file; /* as messages call it; not owned */
};

/* The next line; NULL: there is none, or it holds a byte 0 (lines->left > 0 then). */
char *pp_mesh_lines_next(struct pp_mesh_lines *lines);

/* Fails with PP_BAD_INPUT, "FILE:LINE: ...". */
enum pp_status pp_mesh_lines_fail(const struct pp_mesh_lines *lines, int line,
                                  struct pp_error *err, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Fails with the message of mesh_triangles.h on a corner or a face; PP_OK if `why` is
 * NULL. */
enum pp_status pp_mesh_lines_say(const struct pp_mesh_lines *lines, int line,
                                 const char *why, struct pp_error *err);

#endif
