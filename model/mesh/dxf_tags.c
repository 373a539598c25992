/* dxf_tags.c - see dxf_tags.h. */
#include "model/mesh/dxf_tags.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

/* Removes blanks at both ends. */
static char *trim(char *text)
{
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
        text[--length] = '\0';
    return text;
}

static bool parse_code(int *code, const char *text)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end != '\0' || value < -5 || value > 1071)
        return false;
    *code = (int)value;
    return true;
}

enum pp_status pp_dxf_tags_read(struct pp_dxf_tags *tags, struct pp_mesh_lines *lines,
                                struct pp_error *err)
{
    for (char *first; (first = pp_mesh_lines_next(lines));) {
        struct pp_dxf_tag tag;
        char shown[160];
        first = trim(first);
        if (*first == '\0' && lines->left == 0)
            break;
        if (!parse_code(&tag.code, first))
            return pp_mesh_lines_fail(lines, lines->line, err,
                                      "\"%s\" is not a group code; expected a text DXF "
                                      "file with a whole number on every other line",
                                      pp_text_excerpt(shown, sizeof shown, first));
        char *value = pp_mesh_lines_next(lines);
        if (!value)
            break;
        tag.value = trim(value);
        tag.line = lines->line;
        if (pp_array_reserve(&tags->list, &tags->space, tags->count + 1,
                             sizeof *tags->list, err)
            != PP_OK)
            return PP_SYSTEM;
        tags->list[tags->count++] = tag;
        if (tag.code == 0 && strcmp(tag.value, "EOF") == 0)
            return PP_OK;
    }
    if (lines->left > 0)
        return pp_mesh_lines_fail(lines, lines->line, err,
                                  "there is a NUL byte; expected a text (ASCII) DXF "
                                  "file");
    return pp_mesh_lines_fail(lines, lines->line, err,
                              "the file is incomplete; expected EOF at its end");
}

void pp_dxf_tags_clear(struct pp_dxf_tags *tags)
{
    free(tags->list);
    *tags = (struct pp_dxf_tags){0};
}

int pp_dxf_tags_next(const struct pp_dxf_tags *tags, int at)
{
    for (at++; at < tags->count && tags->list[at].code != 0;)
        at++;
    return at;
}

const struct pp_dxf_tag *pp_dxf_tags_find(const struct pp_dxf_tags *tags, int from,
                                          int to, int code)
{
    for (int i = from; i < to; i++)
        if (tags->list[i].code == code)
            return &tags->list[i];
    return NULL;
}

enum pp_status pp_dxf_tags_number(double *number, const struct pp_dxf_tags *tags,
                                  int from, int to, int code, double fallback,
                                  const struct pp_mesh_lines *lines,
                                  struct pp_error *err)
{
    const struct pp_dxf_tag *tag = pp_dxf_tags_find(tags, from, to, code);
    char shown[160];
    *number = fallback;
    if (!tag || pp_text_parse_number(tag->value, number))
        return PP_OK;
    return pp_mesh_lines_fail(lines, tag->line, err,
                              "\"%s\" is not a number; expected the value of group %d",
                              pp_text_excerpt(shown, sizeof shown, tag->value), code);
}
