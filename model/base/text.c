/* text.c - see text.h. */
#include "model/base/text.h"

#include <limits.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void pp_text_append_v(char *text, size_t room, const char *format, va_list arguments)
{
    size_t length = strlen(text);
    vsnprintf(text + length, room - length, format, arguments);
}

void pp_text_append(char *text, size_t room, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(text, room, format, arguments);
    va_end(arguments);
}

void pp_text_append_list(char *text, size_t room, const char *const *names, int count,
                         const char *last)
{
    if (count < 0)
        for (count = 0; names[count];)
            count++;
    for (int i = 0; i < count; i++)
        pp_text_append(text, room, "%s%s",
                       i == 0           ? ""
                       : i + 1 == count ? last
                                        : ", ",
                       names[i]);
}

enum { LONGEST = 64, EXCERPT_LETTERS = 40 };

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static int smallest(int a, int b, int c)
{
    int ab = a < b ? a : b;
    return ab < c ? ab : c;
}

/* Optimal string alignment: Levenshtein distance that also counts a swap of two
 * adjacent characters as one edit. */
int pp_text_edit_distance(const char *a, const char *b)
{
    size_t m = strlen(a), n = strlen(b);
    if (m > LONGEST || n > LONGEST)
        return INT_MAX;
    int rows[3][LONGEST + 1];
    int *before = rows[0], *last = rows[1], *row = rows[2];
    for (size_t j = 0; j <= n; j++)
        last[j] = before[j] = (int)j;
    for (size_t i = 1; i <= m; i++) {
        row[0] = (int)i;
        for (size_t j = 1; j <= n; j++) {
            char ca = lower(a[i - 1]), cb = lower(b[j - 1]);
            row[j] = smallest(last[j] + 1, row[j - 1] + 1, last[j - 1] + (ca != cb));
            if (i > 1 && j > 1 && ca == lower(b[j - 2]) && lower(a[i - 2]) == cb
                && before[j - 2] + 1 < row[j])
                row[j] = before[j - 2] + 1;
        }
        int *free_row = before;
        before = last;
        last = row;
        row = free_row;
    }
    return last[n];
}

const char *pp_text_nearest(const char *typed, const char *const *names, int count)
{
    const char *nearest = NULL;
    int least = INT_MAX;
    size_t letters = strlen(typed);
    for (int i = 0; count < 0 ? names[i] != NULL : i < count; i++) {
        size_t length = strlen(names[i]);
        size_t longer = letters > length ? letters : length;
        size_t allowed = longer / 3 > 1 ? longer / 3 : 1;
        if (letters > length + allowed || letters + allowed < length)
            continue;
        int distance = pp_text_edit_distance(typed, names[i]);
        if (distance < least && distance <= (int)allowed) {
            nearest = names[i];
            least = distance;
        }
    }
    for (int i = 0;
         !nearest && letters >= 3 && (count < 0 ? names[i] != NULL : i < count); i++)
        if (strstr(names[i], typed))
            nearest = names[i];
    return nearest;
}

const char *pp_text_list_names(char *text, size_t size, const char *const *names,
                               int count)
{
    if (size == 0)
        return text;
    text[0] = '\0';
    pp_text_append_list(text, size, names, count, " or ");
    return text;
}

const char *pp_text_did_you_mean(char *text, size_t room, const char *before,
                                 const char *name, const char *after)
{
    text[0] = '\0';
    if (name)
        snprintf(text, room, "did you mean %s%s%s?", before, name, after);
    return text;
}

void pp_text_append_nearest(char *text, size_t room, const char *typed,
                            const char *const *names, int count)
{
    char question[512];
    pp_text_did_you_mean(question, sizeof question, "\"",
                         pp_text_nearest(typed, names, count), "\"");
    if (question[0])
        pp_text_append(text, room, "; %s", question);
}

enum pp_status pp_text_unknown(struct pp_error *err, const char *typed,
                               const char *const *names, int count,
                               const char *otherwise, const char *format, ...)
{
    char message[sizeof err->message] = "", expected[960], question[512];
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(message, sizeof message, format, arguments);
    va_end(arguments);
    pp_text_did_you_mean(question, sizeof question, "",
                         pp_text_nearest(typed, names, count), "");
    if (question[0])
        return pp_fail(err, PP_BAD_INPUT, "%s; %s", message, question);
    if (otherwise)
        return pp_fail(err, PP_BAD_INPUT, "%s%s", message, otherwise);
    return pp_fail(err, PP_BAD_INPUT, "%s; expected %s", message,
                   pp_text_list_names(expected, sizeof expected, names, count));
}

/* Number of bytes of the UTF-8 character at p, not beyond the terminating NUL. */
static size_t letter_bytes(const char *p)
{
    size_t bytes = 1;
    while (((unsigned char)p[bytes] & 0xC0) == 0x80)
        bytes++;
    return bytes;
}

static bool is_control(const char *p)
{
    unsigned char first = (unsigned char)p[0], second = (unsigned char)p[1];
    return first < 0x20 || first == 0x7F || (first == 0xC2 && second < 0xA0);
}

int pp_text_letter(const char *text, size_t left, int32_t *letter)
{
    static const int32_t least[] = {0, 0x80, 0x800, 0x10000};
    const unsigned char *byte = (const unsigned char *)text;
    int32_t number = byte[0];
    int more = number < 0x80 ? 0 : number >= 0xF0 ? 3 : number >= 0xE0 ? 2 : 1;
    if (more > 0) {
        if (number < 0xC2 || number > 0xF4 || left <= (size_t)more)
            return 0;
        number &= 0x3F >> more;
        for (int i = 1; i <= more; i++) {
            if ((byte[i] & 0xC0) != 0x80)
                return 0;
            number = number << 6 | (byte[i] & 0x3F);
        }
        if (number < least[more] || number > 0x10FFFF
            || (number >= 0xD800 && number <= 0xDFFF))
            return 0;
    }
    if (letter)
        *letter = number;
    return more + 1;
}

bool pp_text_is_plain(const char *text)
{
    for (; *text; text++)
        if (is_control(text))
            return false;
    return true;
}

const char *pp_text_excerpt(char *text, size_t size, const char *written)
{
    static const char cut[] = "...";
    size_t used = 0;
    for (int letters = 0; *written; letters++) {
        size_t bytes = letter_bytes(written);
        if (letters == EXCERPT_LETTERS || used + bytes + sizeof cut > size) {
            if (used + sizeof cut <= size)
                memcpy(text + used, cut, sizeof cut);
            return text;
        }
        if (is_control(written)) {
            text[used++] = '?';
        } else {
            memcpy(text + used, written, bytes);
            used += bytes;
        }
        written += bytes;
    }
    text[used] = '\0';
    return text;
}

static const char WHITE[] = " \t\r\n";

static const char *skip_digits(const char *p, int *count)
{
    for (; *p >= '0' && *p <= '9'; p++)
        ++*count;
    return p;
}

/* End of the decimal number at p; NULL if there is no number. */
static const char *decimal_end(const char *p)
{
    int digits = 0, exponent_digits = 0;
    if (*p == '+' || *p == '-')
        p++;
    p = skip_digits(p, &digits);
    if (*p == '.')
        p = skip_digits(p + 1, &digits);
    if (digits == 0)
        return NULL;
    if (*p != 'e' && *p != 'E')
        return p;
    p++;
    if (*p == '+' || *p == '-')
        p++;
    p = skip_digits(p, &exponent_digits);
    return exponent_digits > 0 ? p : NULL;
}

/* Converts if the digits, without the point, are an integer of at most 2^53, and the
 * power of ten is between -22 and 22. The integer and the power of ten are then exact
 * doubles, so one multiplication or division rounds correctly, with the same result as
 * strtod. Otherwise returns false. */
static bool small_decimal(const char *p, const char *end, double *value)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    bool negative = *p == '-', behind_point = false;
    uint64_t digits = 0;
    int power = 0;
    for (p += *p == '+' || *p == '-'; p < end && *p != 'e' && *p != 'E'; p++) {
        if (*p == '.') {
            behind_point = true;
            continue;
        }
        digits = 10 * digits + (uint64_t)(*p - '0');
        power -= behind_point;
        if (digits > UINT64_C(1) << 53)
            return false;
    }
    if (p < end) {
        bool down = *++p == '-';
        int exponent = 0;
        for (p += *p == '+' || *p == '-'; p < end && exponent < 1000; p++)
            exponent = 10 * exponent + (*p - '0');
        power += down ? -exponent : exponent;
    }
    if (power < -22 || power > 22)
        return false;
    double number = (double)digits;
    number = power < 0 ? number / powers[-power] : number * powers[power];
    *value = negative ? -number : number;
    return true;
}

bool pp_text_parse_number(const char *text, double *value)
{
    const char *start = text + strspn(text, WHITE);
    const char *end = decimal_end(start);
    if (!end || end[strspn(end, WHITE)] != '\0')
        return false;
    if (small_decimal(start, end, value))
        return true;

    /* strtod alone would expect the decimal comma of the locale. */
    locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (plain == (locale_t)0)
        return false;
    double number = strtod_l(start, NULL, plain);
    freelocale(plain);
    if (!isfinite(number))
        return false;
    *value = number;
    return true;
}
