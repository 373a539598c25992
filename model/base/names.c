/* names.c - see names.h. */
#include "model/base/names.h"
#include "model/base/text.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

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

/* Optimal string alignment: Levenshtein's distance with swaps of neighbours. */
int pp_edit_distance(const char *a, const char *b)
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

const char *pp_nearest(const char *typed, const char *const *names, int count)
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
        int distance = pp_edit_distance(typed, names[i]);
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

const char *pp_name_list(char *text, size_t size, const char *const *names, int count)
{
    if (size == 0)
        return text;
    text[0] = '\0';
    pp_append_list(text, size, names, count, " or ");
    return text;
}

/* Bytes of the UTF-8 letter at p, never past its terminating NUL. */
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

bool pp_is_plain(const char *text)
{
    for (; *text; text++)
        if (is_control(text))
            return false;
    return true;
}

const char *pp_excerpt(char *text, size_t size, const char *written)
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
