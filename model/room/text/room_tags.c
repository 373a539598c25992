/* room_tags.c - see room_tags.h. */
#include "model/room/text/room_tags.h"

#include <string.h>

static const char blanks[] = " \t\r\n";

static bool starts(const char *at, const char *end, const char *word)
{
    size_t length = strlen(word);
    return (size_t)(end - at) >= length && memcmp(at, word, length) == 0;
}

/* Position after the next `word`; the end if there is none. */
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

struct pp_room_tag pp_room_tags_next(const char *at, const char *end)
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
            return (struct pp_room_tag){at, behind_tag(at, end)};
        if (at == end)
            break;
    }
    return (struct pp_room_tag){end, end};
}

bool pp_room_tags_is_named(struct pp_room_tag tag, const char *name)
{
    size_t length = strlen(name);
    return (size_t)(tag.to - tag.from) > length + 1
           && memcmp(tag.from + 1, name, length) == 0
           && strchr(" \t\r\n/>", tag.from[1 + length]);
}

struct pp_room_tag pp_room_tags_element(struct pp_room_tag tag, const char *end)
{
    if (tag.to[-2] == '/')
        return tag;
    const char *at = tag.to;
    while (!starts(at, end, "</"))
        at = starts(at, end, "<!--") ? behind(at + 4, end, "-->") : at + 1;
    return (struct pp_room_tag){tag.from, behind_tag(at, end)};
}

struct pp_room_tag pp_room_tags_attribute(struct pp_room_tag tag, const char *name)
{
    const char *at = tag.from + strcspn(tag.from, " \t\r\n/>");
    for (;;) {
        at += strspn(at, blanks);
        size_t length = strcspn(at, " \t\r\n=/>");
        if (length == 0)
            return (struct pp_room_tag){tag.to, tag.to};
        const char *quote = at + length;
        quote += strcspn(quote, "\"'");
        const char *value = quote + 1, *to = strchr(value, *quote);
        if (length == strlen(name) && memcmp(at, name, length) == 0)
            return (struct pp_room_tag){value, to};
        at = to + 1;
    }
}

void pp_room_tags_put_escaped(FILE *out, const char *text)
{
    for (; *text; text++)
        if (strchr("&<\"'", *text))
            fprintf(out, "&#%d;", *text);
        else
            fputc(*text, out);
}
