/* mistake_place.c - see mistake_place.h. */
#include "serve/answers/mistake_place.h"

#include <stdbool.h>
#include <string.h>

struct text_span {
    const char *from, *to;
};

static const char blanks[] = " \t\r\n";

static bool is_blank(char c)
{
    return c != '\0' && strchr(blanks, c);
}

static int line_at(const char *text, const char *at)
{
    int line = 1;
    for (; text < at; text++)
        line += *text == '\n';
    return line;
}

/* Column of a position: 1 + the number of characters before it on its line. */
static int column_at(const char *text, const char *at)
{
    int column = 1;
    const char *from = at;
    while (from > text && from[-1] != '\n')
        from--;
    for (; from < at; from++)
        column += (*from & 0xC0) != 0x80;
    return column;
}

static struct text_span line_span(const char *text, const char *end, int line)
{
    for (int i = 1; i < line && text < end; i++) {
        const char *next = memchr(text, '\n', (size_t)(end - text));
        text = next ? next + 1 : end;
    }
    struct text_span span = {text, text};
    while (span.to < end && *span.to != '\n')
        span.to++;
    while (span.from < span.to && is_blank(*span.from))
        span.from++;
    while (span.to > span.from && is_blank(span.to[-1]))
        span.to--;
    return span;
}

/* Next tag at or after `at`, including "<" and ">". Comments are skipped. The span is
 * empty at the end of the text. */
static struct text_span tag_behind(const char *at, const char *end)
{
    while (at < end) {
        if (*at != '<') {
            at++;
            continue;
        }
        bool is_comment = end - at > 3 && strncmp(at, "<!--", 4) == 0;
        if (is_comment) {
            const char *close = memmem(at, (size_t)(end - at), "-->", 3);
            at = close ? close + 3 : end;
            continue;
        }
        struct text_span tag = {at, at};
        char quote = '\0';
        for (; tag.to < end && (quote || *tag.to != '>'); tag.to++)
            if (quote ? *tag.to == quote : *tag.to == '"' || *tag.to == '\'')
                quote = quote ? '\0' : *tag.to;
        if (tag.to < end)
            tag.to++;
        return tag;
    }
    return (struct text_span){end, end};
}

static bool tag_is_named(struct text_span tag, const char *name, size_t length)
{
    return (size_t)(tag.to - tag.from) > length + 1
           && strncmp(tag.from + 1, name, length) == 0
           && (is_blank(tag.from[length + 1]) || strchr("/>", tag.from[length + 1]));
}

/* Attribute of a tag, with name and value. The span is empty if the tag does not have
 * it. */
static struct text_span attribute_in(struct text_span tag, const char *name,
                                     size_t length)
{
    for (const char *at = tag.from; at + length + 2 < tag.to; at++) {
        if (!is_blank(*at) || strncmp(at + 1, name, length) != 0)
            continue;
        const char *behind = at + 1 + length;
        while (behind < tag.to && is_blank(*behind))
            behind++;
        if (behind >= tag.to || *behind++ != '=')
            continue;
        while (behind < tag.to && is_blank(*behind))
            behind++;
        if (behind >= tag.to || (*behind != '"' && *behind != '\''))
            continue;
        const char *close = memchr(behind + 1, *behind, (size_t)(tag.to - behind - 1));
        return (struct text_span){at + 1, close ? close + 1 : tag.to};
    }
    return (struct text_span){tag.to, tag.to};
}

/* Text in the sentence between `before` and the next quotation mark. The span is empty
 * if there is none. */
static struct text_span quoted_behind(const char *sentence, const char *before)
{
    const char *found = strstr(sentence, before);
    const char *from = found ? found + strlen(before) : sentence;
    const char *to = found ? strchr(from, '"') : NULL;
    return to ? (struct text_span){from, to} : (struct text_span){from, from};
}

struct pp_mistake_place pp_mistake_place_find(const char *text, size_t length, int line,
                                              const char *sentence)
{
    const char *end = text + length;
    struct text_span found = line_span(text, end, line > 0 ? line : 1);
    struct text_span element = quoted_behind(sentence, "element \"");
    struct text_span attribute = quoted_behind(sentence, "attribute \"");
    const char *colon = strstr(sentence, ": ");
    if (element.from == element.to && colon)
        element = (struct text_span){sentence, colon};
    if (attribute.from == attribute.to && colon)
        attribute = (struct text_span){colon + 2, colon + 2 + strcspn(colon + 2, " ")};
    bool has_tag = false;
    for (struct text_span tag = tag_behind(text, end); tag.from < end && line > 0;
         tag = tag_behind(tag.to, end)) {
        if (!tag_is_named(tag, element.from, (size_t)(element.to - element.from))
            || line_at(text, tag.from) > line || line_at(text, tag.to) < line)
            continue;
        struct text_span value =
            attribute_in(tag, attribute.from, (size_t)(attribute.to - attribute.from));
        if (value.from < value.to && line_at(text, value.from) == line) {
            found = value;
            break;
        }
        if (!has_tag)
            found = tag;
        has_tag = true;
    }
    return (struct pp_mistake_place){
        line_at(text, found.from), column_at(text, found.from), line_at(text, found.to),
        column_at(text, found.to)};
}
