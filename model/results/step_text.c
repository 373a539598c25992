/* step_text.c - formats values with digits that depend on their size and unit, writes
 * Greek letters, and substitutes values for symbols. */
#include "model/results/step_text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/expression/expression.h"

enum { DIGITS = 4 /* significant digits at least */ };

/* Values smaller than this are printed as 0. */
static const double least = 1e-7;

static const struct printed_unit {
    int decimals;
    const char *plain, *utf8;
} units[] = {
    [PP_UNIT_DAYLIGHT_FACTOR] = {4, " %", " %"},
    [PP_UNIT_NUMBER] = {4, "", ""},
    [PP_UNIT_COUNT] = {4, "", ""},
    [PP_UNIT_ANGLE] = {2, " deg", "\xc2\xb0"},
    [PP_UNIT_METRE] = {3, " m", " m"},
    [PP_UNIT_SQUARE_METRE] = {3, " m2", " m\xc2\xb2"},
    [PP_UNIT_LUX] = {1, " lx", " lx"},
};

/* Number of decimals: enough for DIGITS significant digits, and at least the number set
 * for the unit. Values counted in tenths have at most one decimal. */
static int decimals_of(double value, const struct pp_calculation_step *step)
{
    int decimals = units[step->unit].decimals;
    if (step->unit == PP_UNIT_COUNT && fabs(10.0 * value - rint(10.0 * value)) < 1e-6)
        return fabs(value - rint(value)) > 1e-6;
    double size = fabs(value);
    if (size < least)
        return 0;
    int wanted = DIGITS - 1 - (int)floor(log10(size));
    return wanted > decimals ? wanted : decimals;
}

const char *pp_step_text_value(char *text, size_t room,
                               const struct pp_calculation_step *step, bool utf8)
{
    const struct printed_unit *unit = &units[step->unit];
    double value = step->value * pp_steps_printed_unit(step->unit);
    int decimals = decimals_of(value, step);
    if (fabs(value) < least)
        value = 0.0; /* no minus sign before zero */
    snprintf(text, room, "%.*f", decimals, value);
    return utf8 ? unit->utf8 : unit->plain;
}

static const struct {
    const char *name, *utf8;
} greek[] = {
    {"alpha", "\xce\xb1"}, {"beta", "\xce\xb2"}, {"gamma", "\xce\xb3"},
    {"theta", "\xce\xb8"}, {"eta", "\xce\xb7"},  {"omega", "\xcf\x89"},
    {"phi", "\xcf\x86"},   {"psi", "\xcf\x88"},  {"rho", "\xcf\x81"},
    {"tau", "\xcf\x84"},   {"pi", "\xcf\x80"},
};

void pp_step_text_add(char *text, size_t room, const char *words, int length, bool utf8)
{
    if (!utf8)
        pp_text_append(text, room, "%.*s", length, words);
    for (int i = 0; i < length && utf8;) {
        int letters = 0;
        while (i + letters < length && isalpha((unsigned char)words[i + letters]))
            letters++;
        const char *found = NULL;
        for (size_t k = 0; k < sizeof greek / sizeof greek[0] && letters; k++)
            if ((int)strlen(greek[k].name) == letters
                && strncmp(greek[k].name, words + i, (size_t)letters) == 0)
                found = greek[k].utf8;
        if (!found && !letters && words[i] == '-')
            found = "\xe2\x88\x92";
        int taken = letters ? letters : 1;
        pp_text_append(text, room, "%.*s", found ? (int)strlen(found) : taken,
                       found ? found : words + i);
        i += taken;
    }
}

void pp_step_text_formula(char *text, size_t room,
                          const struct pp_calculation_step *step, bool utf8)
{
    text[0] = '\0';
    pp_step_text_add(text, room, step->symbol, (int)strlen(step->symbol), utf8);
    pp_text_append(text, room, "%s= ", step->symbol[0] ? " " : "");
    pp_step_text_add(text, room, step->formula, (int)strlen(step->formula), utf8);
}

/* ---- substitution of values ---- */

/* True for the name of a function, and for pi. */
static bool is_known_word(const char *name, int length)
{
    const char *const *functions = pp_expression_functions();
    for (; *functions; functions++)
        if ((int)strlen(*functions) == length
            && strncmp(*functions, name, (size_t)length) == 0)
            return true;
    return length == 2 && strncmp(name, "pi", 2) == 0;
}

/* Last step before `index` with that symbol; NULL: none. */
static const struct pp_calculation_step *step_named(const struct pp_steps *steps,
                                                    int index, const char *name,
                                                    int length)
{
    for (int i = index - 1; i >= 0; i--)
        if ((int)strlen(steps->list[i].symbol) == length
            && strncmp(steps->list[i].symbol, name, (size_t)length) == 0)
            return &steps->list[i];
    return NULL;
}

/* Appends the value of a step in the form used within a formula: degrees have their
 * unit, negative values are in parentheses. */
static void append_step_value(char *text, size_t room,
                              const struct pp_calculation_step *step)
{
    char value[48];
    const char *unit = pp_step_text_value(value, sizeof value, step, true);
    bool negative = value[0] == '-';
    pp_text_append(text, room, "%s%s%s%s", negative ? "(\xe2\x88\x92" : "",
                   value + negative, step->unit == PP_UNIT_ANGLE ? unit : "",
                   negative ? ")" : "");
}

/* Number of bytes of the number at text; 0: no number. */
static int number_length(const char *text)
{
    int length = (int)strspn(text, "0123456789.");
    if (length && (text[length] == 'e' || text[length] == 'E')) {
        int sign = text[length + 1] == '-' || text[length + 1] == '+';
        int digits = (int)strspn(text + length + 1 + sign, "0123456789");
        length += digits ? 1 + sign + digits : 0;
    }
    return length;
}

void pp_step_text_put_in(char *text, size_t room, const struct pp_steps *steps,
                         int index)
{
    const char *formula = steps->list[index].formula;
    bool ends_operand = false; /* the text so far ends in an operand; an operand that
                                * follows is multiplied */
    int values = 0, pieces = 0;
    text[0] = '\0';
    for (const char *at = formula; *at;) {
        if (*at == ' ') {
            at++;
            continue;
        }
        int name = pp_expression_name_length(at), number = number_length(at);
        const struct pp_calculation_step *found =
            name ? step_named(steps, index, at, name) : NULL;
        int length = name ? name : number ? number : 1;
        bool operand = name || number || *at == '(';
        bool function = name && !found && is_known_word(at, name) && at[name] == '(';
        if (ends_operand && operand)
            pp_text_append(text, room, " \xc3\x97 ");
        if (found)
            append_step_value(text, room, found);
        else if (*at == '*')
            pp_text_append(text, room, " \xc3\x97 ");
        else if (strchr("+/", *at) || (*at == '-' && ends_operand))
            pp_text_append(text, room, " %s ",
                           *at == '-'   ? "\xe2\x88\x92"
                           : *at == '+' ? "+"
                                        : "/");
        else if (*at == ',')
            pp_text_append(text, room, ", ");
        else
            pp_step_text_add(text, room, at, length, true);
        ends_operand = (name && !function) || number || *at == ')';
        values += found != NULL;
        pieces++;
        at += length;
    }
    if (values == 0 || pieces == 1)
        text[0] = '\0';
}
