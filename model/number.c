/* number.c - see number.h. */
#include "model/number.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char WHITE[] = " \t\r\n";

static const char *skip_digits(const char *p, int *count)
{
    for (; *p >= '0' && *p <= '9'; p++)
        ++*count;
    return p;
}

/* The end of the decimal number at p, or NULL if none stands there. */
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

bool pp_number_parse(const char *text, double *value)
{
    const char *start = text + strspn(text, WHITE);
    const char *end = decimal_end(start);
    if (!end || end[strspn(end, WHITE)] != '\0')
        return false;

    /* strtod alone would take the locale's decimal comma. */
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
