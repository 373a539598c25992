/* room_text.c - see room_text.h. */
#include "model/room/text/room_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/text/room_tags.h"

/* Start tag of the opening with that index. */
static struct pp_room_tag opening_tag(const char *text, size_t length, int index)
{
    const char *end = text + length;
    struct pp_room_tag tag = pp_room_tags_next(text, end);
    for (; tag.from < end; tag = pp_room_tags_next(tag.to, end))
        if ((pp_room_tags_is_named(tag, "window")
             || pp_room_tags_is_named(tag, "rooflight")
             || pp_room_tags_is_named(tag, "opening"))
            && index-- == 0)
            return tag;
    return (struct pp_room_tag){end, end};
}

/* True if the text already gives that number of metres. */
static bool is_number(struct pp_room_tag text, double number, double per_metre)
{
    char copy[64];
    double said;
    size_t length = (size_t)(text.to - text.from);
    if (length >= sizeof copy)
        return false;
    memcpy(copy, text.from, length);
    copy[length] = '\0';
    return pp_text_parse_number(copy, &said) && said / per_metre == number;
}

/* Units of the file per metre, from its root element. */
static double per_metre_of(const char *text, size_t length)
{
    const char *end = text + length;
    struct pp_room_tag tag = pp_room_tags_next(text, end);
    while (tag.from < end && !pp_room_tags_is_named(tag, "room")
           && !pp_room_tags_is_named(tag, "building"))
        tag = pp_room_tags_next(tag.to, end);
    if (tag.from == end)
        return 1.0;
    struct pp_room_tag units = pp_room_tags_attribute(tag, "units");
    return units.to - units.from == 2 && memcmp(units.from, "mm", 2) == 0 ? 1000.0
                                                                          : 1.0;
}

/* Writes the tag with the position and size of `place`. */
static void put_tag(FILE *out, struct pp_room_tag tag, struct pp_opening_place place,
                    double per_metre)
{
    bool window = pp_room_tags_is_named(tag, "window");
    const struct {
        const char *name;
        double value;
    } lengths[4] = {{window ? "left" : "x", place.left_m},
                    {window ? "sill" : "y", place.sill_m},
                    {"width", place.width_m},
                    {window ? "height" : "depth", place.height_m}};
    struct pp_room_tag values[4];
    for (int i = 0; i < 4; i++)
        values[i] = pp_room_tags_attribute(tag, lengths[i].name);
    for (const char *at = tag.from; at < tag.to;) {
        int here = 0;
        while (here < 4 && at != values[here].from)
            here++;
        if (here == 4) {
            fputc(*at++, out);
            continue;
        }
        if (is_number(values[here], lengths[here].value, per_metre))
            fwrite(at, 1, (size_t)(values[here].to - at), out);
        else
            fprintf(out, "%.10g", lengths[here].value * per_metre + 0.0);
        at = values[here].to;
    }
}

/* Blanks before an element on its line; NULL if other text precedes it. */
static const char *indent_of(const char *text, struct pp_room_tag tag)
{
    const char *at = tag.from;
    while (at > text && (at[-1] == ' ' || at[-1] == '\t'))
        at--;
    return at == text || at[-1] == '\n' ? at : NULL;
}

static void put_edited(FILE *out, const char *text, struct pp_room_tag element,
                       struct pp_room_tag tag, const struct pp_text_edit *edit,
                       double per_metre)
{
    const char *indent = indent_of(text, tag);
    if (edit->kind == PP_TEXT_ADD) {
        fputc('\n', out);
        fwrite(indent ? indent : "", 1, indent ? (size_t)(tag.from - indent) : 0, out);
    }
    if (edit->kind != PP_TEXT_REMOVE) {
        put_tag(out, tag, edit->place, per_metre);
        fwrite(tag.to, 1, (size_t)(element.to - tag.to), out);
    }
}

enum pp_status pp_room_text_edit(char **changed, size_t *changed_length,
                                 const char *text, size_t length,
                                 const struct pp_text_edit *edits, int edit_count,
                                 struct pp_error *err)
{
    *changed = NULL;
    FILE *out = open_memstream(changed, changed_length);
    if (!out)
        return pp_fail_memory(err);
    const char *at = text, *end = text + length;
    double per_metre = per_metre_of(text, length);
    for (int i = 0; i < edit_count;) {
        int opening = edits[i].opening;
        struct pp_room_tag tag = opening_tag(text, length, opening);
        struct pp_room_tag element = pp_room_tags_element(tag, end);
        bool removed = edits[i].kind == PP_TEXT_REMOVE;
        const char *from = removed ? indent_of(text, tag) : NULL;
        bool own_line = from && element.to < end && *element.to == '\n';
        fwrite(at, 1, (size_t)((own_line ? from : tag.from) - at), out);
        if (edits[i].kind == PP_TEXT_ADD)
            fwrite(element.from, 1, (size_t)(element.to - element.from), out);
        for (; i < edit_count && edits[i].opening == opening; i++)
            put_edited(out, text, element, tag, &edits[i], per_metre);
        at = element.to + own_line;
    }
    fwrite(at, 1, (size_t)(end - at), out);
    bool failed = ferror(out);
    if (fclose(out) == 0 && !failed)
        return PP_OK;
    free(*changed);
    *changed = NULL;
    return pp_fail_memory(err);
}

/* The first relative path behind `after` to a file that an element refers to; empty if
 * there is none. */
static struct pp_room_tag next_path(struct pp_room_tag tag, const char *after)
{
    static const char *const elements[][2] = {{"mesh", "file"},
                                              {"outline", "file"},
                                              {"sky", "file"},
                                              {"sky", "second"},
                                              {"room", "within"},
                                              {"window", "glazing-file"},
                                              {"rooflight", "glazing-file"},
                                              {"opening", "glazing-file"}};
    struct pp_room_tag first = {tag.to, tag.to};
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++) {
        if (!pp_room_tags_is_named(tag, elements[i][0]))
            continue;
        struct pp_room_tag path = pp_room_tags_attribute(tag, elements[i][1]);
        if (path.from < path.to && path.from >= after && path.from < first.from
            && *path.from != '/')
            first = path;
    }
    return first;
}

enum pp_status pp_room_text_move(char **moved, size_t *moved_length, const char *text,
                                 size_t length, const char *way, struct pp_error *err)
{
    *moved = NULL;
    FILE *out = open_memstream(moved, moved_length);
    if (!out)
        return pp_fail_memory(err);
    const char *at = text, *end = text + length;
    for (struct pp_room_tag tag = pp_room_tags_next(text, end); tag.from < end;
         tag = pp_room_tags_next(tag.to, end)) {
        struct pp_room_tag path = next_path(tag, tag.from);
        for (; path.from < path.to; path = next_path(tag, path.to)) {
            fwrite(at, 1, (size_t)(path.from - at), out);
            pp_room_tags_put_escaped(out, way);
            at = path.from;
        }
    }
    fwrite(at, 1, (size_t)(end - at), out);
    bool failed = ferror(out);
    if (fclose(out) == 0 && !failed)
        return PP_OK;
    free(*moved);
    *moved = NULL;
    return pp_fail_memory(err);
}

enum pp_status pp_room_text_element(char **element, const char *text, size_t length,
                                    const struct pp_text_edit *edit,
                                    struct pp_error *err)
{
    size_t size;
    *element = NULL;
    FILE *out = open_memstream(element, &size);
    if (!out)
        return pp_fail_memory(err);
    put_tag(out, opening_tag(text, length, edit->opening), edit->place,
            per_metre_of(text, length));
    if (fclose(out) == 0)
        return PP_OK;
    free(*element);
    *element = NULL;
    return pp_fail_memory(err);
}
