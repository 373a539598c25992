/* format.c - quotes CSV fields, and checks bytes for valid UTF-8. */
#include "reports/parts/format.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

#include "model/base/text.h"

const char *const pp_component_names[PP_COMPONENT_COUNT] = {"sc", "erc", "irc", "df"};

const char *const pp_component_titles[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sky component",
    [PP_ERC] = "externally reflected component",
    [PP_IRC] = "internally reflected component",
    [PP_DF] = "daylight factor",
};

void pp_format_cell(double value, const char *format, int width, FILE *out)
{
    char text[32];
    snprintf(text, sizeof text, format, value + 0.0);
    fprintf(out, "%*s", width, isfinite(value) ? text : "-");
}

void pp_format_csv_field(const char *text, FILE *out)
{
    double number;
    char *whole = text ? pp_format_utf8_repair(text) : NULL;
    if (!whole)
        return;
    const bool formula =
        *whole && strchr("=+-@\t\r", *whole) && !pp_text_parse_number(whole, &number);
    const bool quoted = strpbrk(whole, "\",\r\n") != NULL;
    fprintf(out, "%s%s", quoted ? "\"" : "", formula ? "'" : "");
    for (const char *at = whole; *at; at++) {
        if (*at == '"')
            fputc('"', out);
        fputc(*at, out);
    }
    if (quoted)
        fputc('"', out);
    free(whole);
}

void pp_format_csv_number(double number, FILE *out)
{
    fputc(',', out);
    if (isfinite(number))
        fprintf(out, "%.10g", number + 0.0);
}

/* Code point of the first character, or -1 if the byte does not begin a character.
 * *length is set to the number of bytes. */
static int32_t decode(const char *text, int *length)
{
    int32_t code = -1;
    *length = pp_text_letter(text, 4, &code);
    *length += *length == 0;
    return code;
}

/* True for a control character (C0, DEL or C1), for a line or paragraph separator, and
 * for -1, a byte that does not begin a character. */
static bool is_unfit(int32_t code)
{
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028
           || code == 0x2029;
}

int pp_format_utf8_length(const char *text)
{
    int length;
    if (!*text)
        return 0;
    decode(text, &length);
    return length;
}

int pp_format_utf8_width(const char *text)
{
    int width = 0, length;
    for (; *text; text += length) {
        if (*text >= ' ' && *text <= '~') {
            length = 1; /* ASCII needs no decoding */
            width++;
            continue;
        }
        int32_t code = decode(text, &length);
        int columns = is_unfit(code) ? 4 * length : wcwidth((wchar_t)code);
        width += columns < 0 ? 1 : columns;
    }
    return width;
}

void pp_format_utf8_put(FILE *out, const char *text)
{
    int length;
    for (; *text; text += length) {
        if (!is_unfit(decode(text, &length)))
            fwrite(text, 1, (size_t)length, out);
        else
            for (int i = 0; i < length; i++)
                fprintf(out, "\\x%02x", (unsigned char)text[i]);
    }
}

char *pp_format_utf8_repair(const char *text)
{
    static const char replacement[] = "\xef\xbf\xbd";
    char *copy = malloc(3 * strlen(text) + 1), *end = copy;
    if (!copy)
        return NULL;
    int length;
    for (; *text; text += length)
        if (decode(text, &length) >= 0)
            end = mempcpy(end, text, (size_t)length);
        else
            end = mempcpy(end, replacement, 3);
    *end = '\0';
    return copy;
}
