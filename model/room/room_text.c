/* room_text.c - see room_text.h.
 *
 * The text is well-formed XML without DOCTYPE, so that between "<" and ">" there is
 * a tag, a comment, a processing instruction or CDATA, and a ">" in a tag stands in
 * quotes or ends it.
 */
#include "model/room/room_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"

struct span {
    const char *from, *to; /* to: behind the last byte */
};

static const char blanks[] = " \t\r\n";

static bool starts(const char *at, const char *end, const char *word)
{
    size_t length = strlen(word);
    return (size_t)(end - at) >= length && memcmp(at, word, length) == 0;
}

/* Position after the next `word`, or the end. */
static const char *behind(const char *at, const char *end, const char *word)
{
    const char *found = memmem(at, (size_t)(end - at), word, strlen(word));
    return found ? found + strlen(word) : end;
}

/* Position after the ">" of the tag that begins at `at`. */
static const char *behind_tag(const char *at, const char *end)
{
    char quote = 0;
    for (; at < end; at++) {
        if (quote)
            quote = *at == quote ? 0 : quote;
        else if (*at == '"' || *at == '\'')
            quote = *at;
        else if (*at == '>')
            return at + 1;
    }
    return end;
}

/* The next start tag at or behind `at`; empty at the end of the text. */
static struct span next_tag(const char *at, const char *end)
{
    while ((at = memchr(at, '<', (size_t)(end - at))) != NULL) {
        if (starts(at, end, "<!--"))
            at = behind(at + 4, end, "-->");
        else if (starts(at, end, "<![CDATA["))
            at = behind(at, end, "]]>");
        else if (starts(at, end, "<?"))
            at = behind(at, end, "?>");
        else if (starts(at, end, "</"))
            at = behind_tag(at, end);
        else
            return (struct span){at, behind_tag(at, end)};
        if (at == end)
            break;
    }
    return (struct span){end, end};
}

static bool is_named(struct span tag, const char *name)
{
    size_t length = strlen(name);
    return (size_t)(tag.to - tag.from) > length + 1
           && memcmp(tag.from + 1, name, length) == 0
           && strchr(" \t\r\n/>", tag.from[1 + length]);
}

/* The start tag of the index-th opening. */
static struct span opening_tag(const char *text, size_t length, int index)
{
    const char *end = text + length;
    struct span tag = next_tag(text, end);
    for (; tag.from < end; tag = next_tag(tag.to, end))
        if ((is_named(tag, "window") || is_named(tag, "rooflight")
             || is_named(tag, "opening"))
            && index-- == 0)
            return tag;
    return (struct span){end, end};
}

/* The whole element of an opening without children. */
static struct span element_of(struct span tag, const char *end)
{
    if (tag.to[-2] == '/')
        return tag;
    const char *at = tag.to;
    while (!starts(at, end, "</"))
        at = starts(at, end, "<!--") ? behind(at + 4, end, "-->") : at + 1;
    return (struct span){tag.from, behind_tag(at, end)};
}

/* The value of an attribute, between its quotes; empty where it is not there. */
static struct span attribute_of(struct span tag, const char *name)
{
    const char *at = tag.from + strcspn(tag.from, " \t\r\n/>");
    for (;;) {
        at += strspn(at, blanks);
        size_t length = strcspn(at, " \t\r\n=/>");
        if (length == 0)
            return (struct span){tag.to, tag.to};
        const char *quote = at + length;
        quote += strcspn(quote, "\"'");
        const char *value = quote + 1, *to = strchr(value, *quote);
        if (length == strlen(name) && memcmp(at, name, length) == 0)
            return (struct span){value, to};
        at = to + 1;
    }
}

/* True if the text gives that number of metres already. */
static bool is_number(struct span text, double number, double per_metre)
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

/* Units of the file per metre, from its root. */
static double per_metre_of(const char *text, size_t length)
{
    const char *end = text + length;
    struct span tag = next_tag(text, end);
    while (tag.from < end && !is_named(tag, "room") && !is_named(tag, "building"))
        tag = next_tag(tag.to, end);
    if (tag.from == end)
        return 1.0;
    struct span units = attribute_of(tag, "units");
    return units.to - units.from == 2 && memcmp(units.from, "mm", 2) == 0 ? 1000.0
                                                                          : 1.0;
}

/* Writes the tag with the values of a place in it. */
static void put_tag(FILE *out, struct span tag, struct pp_opening_place place,
                    double per_metre)
{
    bool window = is_named(tag, "window");
    const struct {
        const char *name;
        double value;
    } lengths[4] = {{window ? "left" : "x", place.left_m},
                    {window ? "sill" : "y", place.sill_m},
                    {"width", place.width_m},
                    {window ? "height" : "depth", place.height_m}};
    struct span values[4];
    for (int i = 0; i < 4; i++)
        values[i] = attribute_of(tag, lengths[i].name);
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

/* The blanks before an element on its line; NULL where something else stands there. */
static const char *indent_of(const char *text, struct span tag)
{
    const char *at = tag.from;
    while (at > text && (at[-1] == ' ' || at[-1] == '\t'))
        at--;
    return at == text || at[-1] == '\n' ? at : NULL;
}

static void put_edited(FILE *out, const char *text, struct span element,
                       struct span tag, const struct pp_text_edit *edit,
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
        struct span tag = opening_tag(text, length, opening);
        struct span element = element_of(tag, end);
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

/* Writes text as an attribute's value, valid in either kind of quotes. */
static void put_escaped(FILE *out, const char *text)
{
    for (; *text; text++)
        if (strchr("&<\"'", *text))
            fprintf(out, "&#%d;", *text);
        else
            fputc(*text, out);
}

enum pp_status pp_room_text_move(char **moved, size_t *moved_length, const char *text,
                                 size_t length, const char *way, struct pp_error *err)
{
    *moved = NULL;
    FILE *out = open_memstream(moved, moved_length);
    if (!out)
        return pp_fail_memory(err);
    const char *at = text, *end = text + length;
    for (struct span tag = next_tag(text, end); tag.from < end;
         tag = next_tag(tag.to, end)) {
        struct span file = attribute_of(tag, "file");
        if (!is_named(tag, "mesh") || file.from == file.to || *file.from == '/')
            continue;
        fwrite(at, 1, (size_t)(file.from - at), out);
        put_escaped(out, way);
        at = file.from;
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
