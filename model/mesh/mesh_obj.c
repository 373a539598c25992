/* mesh_obj.c - see mesh_obj.h. */
#include "model/mesh/mesh_obj.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

static const char blanks[] = " \t\v\f";

/* Returns the next statement as one line: a \ at the end of a line and the line break
 * become blanks. NULL as for pp_mesh_lines_next. *line: first line of the statement. */
static char *next_statement(struct pp_mesh_lines *lines, int *line)
{
    char *statement = pp_mesh_lines_next(lines), *end = statement;
    *line = lines->line;
    while (end) {
        end += strlen(end);
        if (end == statement || end[-1] != '\\')
            return statement;
        end[-1] = ' ';
        char *more = pp_mesh_lines_next(lines);
        if (!more)
            return lines->left > 0 ? NULL : statement;
        memset(end, ' ', (size_t)(more - end));
        end = more;
    }
    return NULL;
}

/* Returns the next word, NUL-terminated in place, and advances *text past it; NULL if
 * there is none. */
static char *next_word(char **text)
{
    char *word = *text + strspn(*text, blanks);
    if (*word == '\0')
        return NULL;
    *text = word + strcspn(word, blanks);
    if (**text != '\0')
        *(*text)++ = '\0';
    return word;
}

static enum pp_status read_corner(struct pp_mesh_triangles *mesh,
                                  struct pp_mesh_lines *lines, int line, char *text,
                                  struct pp_error *err)
{
    double xyz[3];
    for (int i = 0; i < 3; i++) {
        char shown[160];
        const char *word = next_word(&text);
        if (!word)
            return pp_mesh_lines_fail(lines, line, err,
                                      "v: has %d number%s; expected x, y and z", i,
                                      i == 1 ? "" : "s");
        if (!pp_text_parse_number(word, &xyz[i]))
            return pp_mesh_lines_fail(lines, line, err,
                                      "v: \"%s\" is not a number; expected x, y and z",
                                      pp_text_excerpt(shown, sizeof shown, word));
    }
    return pp_mesh_lines_say(
        lines, line, pp_mesh_triangles_add_corner(mesh, pp_vec(xyz[0], xyz[1], xyz[2])),
        err);
}

/* Index of the corner that a word of a face names ("7", "7/3/2", "-1"); -1: no such
 * corner. */
static int corner_of(const struct pp_mesh_triangles *mesh, const char *word)
{
    char *end;
    long index = strtol(word, &end, 10);
    if (end == word || (*end != '\0' && *end != '/'))
        return -1;
    if (index < 0 && index >= -(long)mesh->corner_count)
        return mesh->corner_count + (int)index;
    return index > 0 && index <= mesh->corner_count ? (int)index - 1 : -1;
}

/* Corners of a face; the memory is reused for the next face. */
struct corners {
    int *list, count, space;
};

static enum pp_status read_face(struct pp_mesh_triangles *mesh, struct corners *corners,
                                struct pp_mesh_lines *lines, int line, char *text,
                                struct pp_error *err)
{
    corners->count = 0;
    for (const char *word; (word = next_word(&text));) {
        char shown[160];
        int corner = corner_of(mesh, word);
        if (corner < 0)
            return pp_mesh_lines_fail(
                lines, line, err,
                "f: \"%s\" is not a corner; expected one of the %d corners above it, "
                "counted from 1, or backwards from -1",
                pp_text_excerpt(shown, sizeof shown, word), mesh->corner_count);
        if (pp_array_reserve(&corners->list, &corners->space, corners->count + 1,
                             sizeof *corners->list, err)
            != PP_OK)
            return PP_SYSTEM;
        corners->list[corners->count++] = corner;
    }
    if (corners->count < 3)
        return pp_mesh_lines_fail(lines, line, err,
                                  "f: has %d corner%s; expected 3 or more",
                                  corners->count, corners->count == 1 ? "" : "s");
    return pp_mesh_lines_say(
        lines, line, pp_mesh_triangles_add_face(mesh, corners->list, corners->count),
        err);
}

static enum pp_status read_statement(struct pp_mesh_triangles *mesh,
                                     struct corners *corners,
                                     struct pp_mesh_lines *lines, int line,
                                     char *statement, struct pp_error *err)
{
    static const char *const refused[] = {"curv", "curv2", "surf", "bzp", "bsp",
                                          "cdc",  "cdp",   "res",  "call"};
    const char *word = next_word(&statement);
    if (!word || *word == '#')
        return PP_OK;
    if (strcmp(word, "v") == 0)
        return read_corner(mesh, lines, line, statement, err);
    if (strcmp(word, "f") == 0 || strcmp(word, "fo") == 0)
        return read_face(mesh, corners, lines, line, statement, err);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        if (strcmp(word, refused[i]) == 0)
            return pp_mesh_lines_fail(
                lines, line, err,
                "%s: this keyword is not supported; expected faces (v and f) only",
                word);
    return PP_OK;
}

enum pp_status pp_mesh_obj_read(struct pp_mesh_triangles *mesh,
                                struct pp_mesh_lines *lines, struct pp_error *err)
{
    struct corners corners = {0};
    enum pp_status status = PP_OK;
    int line;
    for (char *statement;
         status == PP_OK && (statement = next_statement(lines, &line));)
        status = read_statement(mesh, &corners, lines, line, statement, err);
    free(corners.list);
    if (status == PP_OK && lines->left > 0)
        status = pp_mesh_lines_fail(lines, lines->line, err,
                                    "there is a NUL byte; expected a text OBJ file");
    if (status == PP_OK && mesh->triangle_count == 0)
        status = pp_mesh_lines_fail(lines, lines->line, err,
                                    "the file has no faces; expected v and f lines");
    return status;
}
