/* bytes.c - implements a growing block of bytes, and changes ids and titles in SVG
 * files of cairo. */
#include "charts/sheet/bytes.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

bool pp_bytes_add(struct pp_bytes *bytes, const void *more, size_t count)
{
    if (count > bytes->room - bytes->count) {
        size_t room = bytes->room ? bytes->room : 65536;
        while (count > room - bytes->count) {
            if (room > SIZE_MAX / 2)
                return false;
            room *= 2;
        }
        unsigned char *list = realloc(bytes->list, room);
        if (!list)
            return false;
        bytes->list = list;
        bytes->room = room;
    }
    if (count)
        memcpy(bytes->list + bytes->count, more, count);
    bytes->count += count;
    return true;
}

void pp_bytes_clear(struct pp_bytes *bytes)
{
    free(bytes->list);
    *bytes = (struct pp_bytes){0};
}

static bool add_string(struct pp_bytes *bytes, const char *string)
{
    return pp_bytes_add(bytes, string, strlen(string));
}

/* Appends a string with XML escapes, without characters that XML 1.0 does not allow. */
static bool add_escaped(struct pp_bytes *bytes, const char *string)
{
    bool good = true;
    for (const char *c = string; *c && good; c++) {
        switch (*c) {
        case '&':
            good = add_string(bytes, "&amp;");
            break;
        case '<':
            good = add_string(bytes, "&lt;");
            break;
        case '>':
            good = add_string(bytes, "&gt;");
            break;
        default:
            if ((unsigned char)*c >= 0x20 || *c == '\n' || *c == '\t')
                good = pp_bytes_add(bytes, c, 1);
        }
    }
    return good;
}

/* ---- SVG ---- */

/* A piece of the file, not null-terminated. */
struct svg_span {
    const char *start;
    size_t length;
};

/* Ids in order of first appearance. The number of an id is its index in the list. */
struct ids {
    char prefix[16];
    struct svg_span *list;
    int count, room;
};

/* Number of an id, which is added to the list if necessary; -1: out of memory. */
static int id_number(struct ids *ids, struct svg_span id)
{
    for (int i = 0; i < ids->count; i++)
        if (ids->list[i].length == id.length
            && memcmp(ids->list[i].start, id.start, id.length) == 0)
            return i;
    if (pp_array_reserve(&ids->list, &ids->room, ids->count + 1, sizeof *ids->list,
                         NULL)
        != PP_OK)
        return -1;
    ids->list[ids->count] = id;
    return ids->count++;
}

/* FNV-1a hash of title and drawing. The ids that cairo chooses depend on earlier
 * drawings in the same process, so they (the text between # or id=" and the closing
 * quote or bracket) are not hashed. */
static uint32_t hash_drawing(struct svg_span drawing, const char *title)
{
    uint32_t hash = 2166136261u;
    for (const char *c = title; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 16777619u;
    bool name = false;
    for (size_t i = 0; i < drawing.length; i++) {
        char c = drawing.start[i];
        if (name && (c == '"' || c == ')'))
            name = false;
        if (!name)
            hash = (hash ^ (unsigned char)c) * 16777619u;
        if (c == '#' || (i >= 3 && memcmp(drawing.start + i - 3, "id=\"", 4) == 0))
            name = true;
    }
    return hash;
}

/* Start of the next id at or after `from`; NULL: none. */
static const char *next_id(const char *from, const char *end)
{
    static const char *const openings[] = {" id=\"", "href=\"#", "url(#"};
    for (const char *c = from; c < end; c++)
        for (int i = 0; i < 3; i++) {
            size_t length = strlen(openings[i]);
            if ((size_t)(end - c) > length && *c == openings[i][0]
                && memcmp(c, openings[i], length) == 0)
                return c + length;
        }
    return 0;
}

static bool add_renamed(struct pp_bytes *svg, struct svg_span body, struct ids *ids)
{
    const char *at = body.start, *end = body.start + body.length;
    const char *id;
    while ((id = next_id(at, end))) {
        const char *stop = id;
        while (stop < end && *stop != '"' && *stop != ')')
            stop++;
        int number = id_number(ids, (struct svg_span){id, (size_t)(stop - id)});
        char name[48];
        snprintf(name, sizeof name, "%s-%d", ids->prefix, number);
        if (number < 0 || !pp_bytes_add(svg, at, (size_t)(id - at))
            || !add_string(svg, name))
            return false;
        at = stop;
    }
    return pp_bytes_add(svg, at, (size_t)(end - at));
}

/* Adds the head of an SVG file, with its size. cairo_svg_surface_set_document_unit is
 * not used, because coordinates would then be in millimetres, which cairo rounds to
 * 1/256 (outlines of letters to 1/64). Labels would differ in size and position from
 * those in PDF and PNG. */
static bool add_head(struct pp_bytes *svg, const char *prefix, double width_mm,
                     double height_mm, const char *title, const char *description)
{
    char head[1024];
    snprintf(head, sizeof head,
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" "
             "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
             "width=\"%.0fmm\" height=\"%.0fmm\" viewBox=\"0 0 %.6f %.6f\" "
             "version=\"1.1\" role=\"img\" "
             "aria-labelledby=\"%s-title %s-desc\">\n<title id=\"%s-title\">",
             width_mm, height_mm, width_mm * 72.0 / 25.4, height_mm * 72.0 / 25.4,
             prefix, prefix, prefix);
    char middle[64];
    snprintf(middle, sizeof middle, "</title>\n<desc id=\"%s-desc\">", prefix);
    return add_string(svg, head) && add_escaped(svg, title) && add_string(svg, middle)
           && add_escaped(svg, description) && add_string(svg, "</desc>\n");
}

bool pp_bytes_name_svg(struct pp_bytes *svg, const struct pp_bytes *cairo,
                       double width_mm, double height_mm, const char *title,
                       const char *description)
{
    /* The drawing is the content of cairo's <svg ...> element. */
    const char *start = (const char *)cairo->list, *end = start + cairo->count;
    const char *root = memmem(start, cairo->count, "<svg", 4);
    root = root ? memchr(root, '>', (size_t)(end - root)) : 0;
    if (!root)
        return false;
    struct svg_span body = {root + 1, (size_t)(end - root - 1)};

    struct ids ids = {0};
    snprintf(ids.prefix, sizeof ids.prefix, "pp%08x",
             (unsigned)hash_drawing(body, title));
    bool good = add_head(svg, ids.prefix, width_mm, height_mm, title, description)
                && add_renamed(svg, body, &ids);
    free(ids.list);
    return good;
}
