/* epw_lines.c - see epw_lines.h. */
#include "formats/epw/epw_lines.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"

static bool starts(const char *bytes, size_t length, const char *with)
{
    size_t count = strlen(with);
    return length >= count && memcmp(bytes, with, count) == 0;
}

bool pp_epw_lines_check_bytes(const char *bytes, size_t length,
                              struct pp_mistakes *mistakes)
{
    if (length > PP_EPW_BYTES_MOST) {
        pp_mistakes_add(mistakes, 0, "the file is larger than the limit of %d MiB",
                        PP_EPW_BYTES_MOST >> 20);
        return false;
    }
    if (starts(bytes, length, "\xFF\xFE") || starts(bytes, length, "\xFE\xFF")) {
        pp_mistakes_add(mistakes, 1,
                        "the file is UTF-16; expected plain text, in UTF-8");
        return false;
    }
    int line = 1;
    size_t start = 0;
    bool blank = true;
    for (size_t i = 0; i < length; i++) {
        char c = bytes[i];
        bool ends = c == '\n' || c == '\r';
        if (c == '\0') {
            pp_mistakes_add(
                mistakes, line,
                "there is a NUL byte; expected plain text in a weather file");
            return false;
        }
        if (i - start > PP_EPW_LINE_BYTES_MOST) {
            pp_mistakes_add(
                mistakes, line,
                "there is a line of more than %d bytes; expected one record per line",
                PP_EPW_LINE_BYTES_MOST);
            return false;
        }
        blank = blank && (ends || c == ' ' || c == '\t');
        if (!ends)
            continue;
        start = i + 1;
        line += !(c == '\r' && i + 1 < length && bytes[i + 1] == '\n');
    }
    if (blank)
        pp_mistakes_add(mistakes, 1,
                        "the file is empty; expected a weather file (EPW)");
    return !blank;
}

/* White space, including Ctrl-Z, which DOS wrote after the last line. */
static bool is_white(char c)
{
    return c == ' ' || c == '\t' || c == '\x1A';
}

char *pp_epw_lines_next(struct pp_epw_lines *lines)
{
    while (lines->at < lines->end) {
        char *start = lines->at, *stop = start + strcspn(start, "\r\n");
        bool pair = stop[0] == '\r' && stop[1] == '\n';
        lines->at = stop < lines->end ? stop + (pair ? 2 : 1) : stop;
        lines->line = lines->next_line++;
        while (stop > start && is_white(stop[-1]))
            stop--;
        *stop = '\0';
        while (is_white(*start))
            start++;
        if (*start)
            return start;
    }
    return NULL;
}

/* Returns the end of the field at p: its comma or NUL. In a field that begins with a
 * quote, commas up to the closing quote are part of the field. */
static char *field_end(char *p)
{
    char *start = p + strspn(p, " \t");
    char *quote = *start == '"' ? strchr(start + 1, '"') : NULL;
    return quote ? quote + strcspn(quote, ",") : p + strcspn(p, ",");
}

static char *trimmed(char *start, char *stop)
{
    while (is_white(*start))
        start++;
    while (stop > start && is_white(stop[-1]))
        stop--;
    if (stop - start >= 2 && *start == '"' && stop[-1] == '"') {
        start++;
        stop--;
    }
    *stop = '\0';
    return start;
}

int pp_epw_lines_split(char *line, char *fields[], int most)
{
    int count = 0;
    for (char *p = line;; p++) {
        char *stop = field_end(p);
        bool last = *stop == '\0';
        if (count < most)
            fields[count] = trimmed(p, stop);
        count++;
        p = stop;
        if (last)
            return count;
    }
}

static bool is_utf8(const char *text)
{
    while (*text) {
        int bytes = pp_text_letter(text, 4, NULL);
        if (bytes == 0)
            return false;
        text += bytes;
    }
    return true;
}

bool pp_epw_lines_append_text(char **whole, const char *before, const char *text)
{
    size_t length = *whole ? strlen(*whole) : 0;
    char *grown = realloc(*whole, length + strlen(before) + 2 * strlen(text) + 1);
    if (!grown)
        return false;
    *whole = grown;
    char *out = grown + length;
    out = stpcpy(out, length && *text ? before : "");
    bool latin = !is_utf8(text);
    for (const unsigned char *p = (const unsigned char *)text; *p; p++) {
        if (latin && *p >= 0x80) {
            *out++ = (char)(0xC0 | *p >> 6);
            *out++ = (char)(0x80 | (*p & 0x3F));
        } else {
            *out++ = (char)*p;
        }
    }
    *out = '\0';
    return true;
}
