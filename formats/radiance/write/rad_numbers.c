/* rad_numbers.c - see rad_numbers.h. */
#include "formats/radiance/write/rad_numbers.h"

#include <locale.h>
#include <math.h>
#include <string.h>

#include "model/base/text.h"

/* Prints the number with `digits` significant digits and, in any locale, a decimal
 * point. */
static void print_digits(char *text, int digits, double number)
{
    const char *point = localeconv()->decimal_point;
    snprintf(text, 32, "%.*g", digits, number);
    char *at = strstr(text, point);
    if (!at)
        return;
    size_t length = strlen(point);
    *at = '.';
    memmove(at + 1, at + length, strlen(at + length) + 1);
}

void pp_rad_numbers_text(double number, char *text)
{
    double back = NAN;
    for (int digits = 15; digits <= 17 && back != number; digits++) {
        print_digits(text, digits, number);
        pp_text_parse_number(text, &back);
    }
}

double pp_rad_numbers_round(double number)
{
    char text[32];
    print_digits(text, 15, number);
    return pp_text_parse_number(text, &number) ? number : 0.0;
}

void pp_rad_numbers_write(FILE *out, const double *numbers, int count)
{
    fprintf(out, "%d", count);
    for (int i = 0; i < count; i++) {
        char text[32];
        pp_rad_numbers_text(numbers[i], text);
        fprintf(out, " %s", text);
    }
    fputc('\n', out);
}
