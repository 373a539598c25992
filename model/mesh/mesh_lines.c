/* mesh_lines.c - see mesh_lines.h. */
#include "model/mesh/mesh_lines.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/mesh/mesh_triangles.h"

char *pp_mesh_lines_next(struct pp_mesh_lines *lines)
{
    char *line = lines->text;
    size_t length = 0;
    if (lines->left == 0)
        return NULL;
    lines->line++;
    while (length < lines->left && line[length] != '\n' && line[length] != '\r')
        if (line[length++] == '\0')
            return NULL;
    size_t end = length;
    if (end + 1 < lines->left && line[end] == '\r' && line[end + 1] == '\n')
        end++;
    end += end < lines->left;
    line[length] = '\0';
    lines->text += end;
    lines->left -= end;
    return line;
}

enum pp_status pp_mesh_lines_fail(const struct pp_mesh_lines *lines, int line,
                                  struct pp_error *err, const char *format, ...)
{
    char what[320] = "";
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(what, sizeof what, format, arguments);
    va_end(arguments);
    return pp_fail(err, PP_BAD_INPUT, "%.160s:%d: %s", lines->file, line, what);
}

enum pp_status pp_mesh_lines_say(const struct pp_mesh_lines *lines, int line,
                                 const char *why, struct pp_error *err)
{
    if (!why)
        return PP_OK;
    return why == pp_mesh_triangles_no_memory
               ? pp_fail_memory(err)
               : pp_mesh_lines_fail(lines, line, err, "%s", why);
}
