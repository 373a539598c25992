/* number.c - see number.h. */
#include "model/base/number.h"

#include <locale.h>
#include <math.h>
#include <stdint.h>
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

/* Where digits, without the point, are a whole number below 2^53 and the power of ten is
 * at most 22, both are doubles exactly, so that one multiplication or division rounds as
 * it should: the same double as strtod's. False where that does not hold. */
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

bool pp_number_parse(const char *text, double *value)
{
    const char *start = text + strspn(text, WHITE);
    const char *end = decimal_end(start);
    if (!end || end[strspn(end, WHITE)] != '\0')
        return false;
    if (small_decimal(start, end, value))
        return true;

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
