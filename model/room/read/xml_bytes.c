/* xml_bytes.c - see xml_bytes.h. */
#include "model/room/read/xml_bytes.h"

#include <stdint.h>
#include <string.h>
#include <strings.h>

#include "model/base/text.h"
#include "model/room/read/xml.h"

static int line_of(const char *bytes, const char *at)
{
    int line = 1;
    for (const char *p = bytes; p < at; p++)
        line += *p == '\n';
    return line;
}

/* The bytes of the well-formed UTF-8 letter at p, or 0: surrogates, overlong forms and
 * numbers above U+10FFFF are none. */
static size_t utf8_letter(const unsigned char *p, const unsigned char *end)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (*p < 0x80)
        return 1;
    size_t bytes = *p >= 0xF0 ? 4 : *p >= 0xE0 ? 3 : 2;
    if (*p < 0xC2 || *p > 0xF4 || (size_t)(end - p) < bytes)
        return 0;
    uint32_t letter = *p & (0xFFu >> (bytes + 1));
    for (size_t i = 1; i < bytes; i++) {
        if ((p[i] & 0xC0) != 0x80)
            return 0;
        letter = letter << 6 | (p[i] & 0x3Fu);
    }
    bool good = letter >= least[bytes] && letter <= 0x10FFFF
                && !(letter >= 0xD800 && letter <= 0xDFFF);
    return good ? bytes : 0;
}

static bool letters_are_sound(const char *bytes, const char *end,
                              struct pp_mistakes *mistakes)
{
    for (const char *p = bytes; p < end;) {
        size_t letter =
            utf8_letter((const unsigned char *)p, (const unsigned char *)end);
        if (letter == 0) {
            pp_mistakes_add(mistakes, line_of(bytes, p),
                            "byte 0x%02X is not UTF-8; the file must be saved as UTF-8",
                            (unsigned)(unsigned char)*p);
            return false;
        }
        if (*p == '\0') {
            pp_mistakes_add(mistakes, line_of(bytes, p),
                            "a NUL byte; a room file is plain text");
            return false;
        }
        p += letter;
    }
    return true;
}

static const char *find(const char *p, const char *end, const char *what)
{
    return memmem(p, (size_t)(end - p), what, strlen(what));
}

/* The declaration may name an encoding; it must be ours. */
static bool declares_utf8(const char *bytes, const char *end,
                          struct pp_mistakes *mistakes)
{
    if (end - bytes < 5 || memcmp(bytes, "<?xml", 5) != 0)
        return true;
    const char *close = find(bytes, end, "?>");
    const char *p = close ? find(bytes, close, "encoding") : NULL;
    if (!p)
        return true;
    p += strlen("encoding");
    while (p < close && strchr(" \t\r\n=", *p))
        p++;
    char quote = *p;
    if (quote != '"' && quote != '\'')
        return true; /* the parser will say so */
    const char *name = ++p;
    while (p < close && *p != quote)
        p++;
    size_t length = (size_t)(p - name);
    char copy[32] = "", text[64];
    if (length == 5 && strncasecmp(name, "UTF-8", 5) == 0)
        return true;
    memcpy(copy, name, length < sizeof copy ? length : sizeof copy - 1);
    pp_mistakes_add(mistakes, line_of(bytes, name),
                    "the file says that its encoding is \"%s\"; expected UTF-8",
                    pp_text_excerpt(text, sizeof text, copy));
    return false;
}

static bool starts(const char *p, const char *end, const char *with)
{
    size_t length = strlen(with);
    return (size_t)(end - p) >= length && memcmp(p, with, length) == 0;
}

/* Behind the tag that starts at p. */
static const char *tag_end(const char *p, const char *end)
{
    char quote = '\0';
    for (; p < end; p++) {
        if (quote)
            quote = *p == quote ? '\0' : quote;
        else if (*p == '"' || *p == '\'')
            quote = *p;
        else if (*p == '>')
            return p + 1;
    }
    return end;
}

const char *pp_xml_bytes_markup_end(const char *p, const char *end, bool *is_tag)
{
    static const char *const passed_over[][2] = {
        {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
    *is_tag = false;
    for (int i = 0; i < 3; i++)
        if (starts(p, end, passed_over[i][0])) {
            const char *close =
                find(p + strlen(passed_over[i][0]), end, passed_over[i][1]);
            return close ? close + strlen(passed_over[i][1]) : end;
        }
    *is_tag = true;
    return tag_end(p, end);
}

static bool tags_are_short(const char *bytes, const char *end,
                           struct pp_mistakes *mistakes)
{
    const char *p = bytes, *next;
    for (; p < end && (p = memchr(p, '<', (size_t)(end - p))); p = next) {
        bool is_tag;
        next = pp_xml_bytes_markup_end(p, end, &is_tag);
        if (!is_tag || next - p <= PP_XML_TAG_BYTES_MOST)
            continue;
        pp_mistakes_add(mistakes, line_of(bytes, p),
                        "a tag of more than %d bytes starts here; is a quotation mark "
                        "or a > missing?",
                        PP_XML_TAG_BYTES_MOST);
        return false;
    }
    return true;
}

bool pp_xml_bytes_sound(const char *bytes, size_t length, struct pp_mistakes *mistakes)
{
    const char *end = bytes + length;
    if (length > PP_XML_BYTES_MOST) {
        pp_mistakes_add(mistakes, 0,
                        "the file is larger than %d MiB, the most that is read",
                        PP_XML_BYTES_MOST >> 20);
        return false;
    }
    if (starts(bytes, end, "\xFF\xFE") || starts(bytes, end, "\xFE\xFF")) {
        pp_mistakes_add(mistakes, 1, "the file is UTF-16; it must be saved as UTF-8");
        return false;
    }
    /* pp_xml_parse passes over one; the parser would pass over another. */
    if (starts(bytes, end, "\xEF\xBB\xBF")) {
        pp_mistakes_add(mistakes, 1,
                        "a second byte order mark; expected one or none, and then a "
                        "<room> or a <building>");
        return false;
    }
    const char *p = bytes;
    while (p < end && pp_text_is_white(*p))
        p++;
    if (p == end) {
        pp_mistakes_add(mistakes, 1,
                        "the file is empty; expected a <room> or a <building>");
        return false;
    }
    return letters_are_sound(bytes, end, mistakes)
           && declares_utf8(bytes, end, mistakes)
           && tags_are_short(bytes, end, mistakes);
}
