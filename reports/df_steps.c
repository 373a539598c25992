/* df_steps.c - calculations set out as on paper: a formula on a line of its own, its value
 * below; figures that were read or put in on one line each, the value on the right.
 *
 * Values have enough digits that a formula recomputed from the printed figures gives the
 * printed value, to within their rounding. */
#include "reports/df_steps.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/format.h"
#include "reports/parts/print.h"
#include "methods/method.h"
#include "model/base/text.h"

enum {
    HEAD = 4,   /* columns before a heading, */
    SYMBOL = 6, /* a symbol or formula, */
    MORE = 10,  /* the rest of a long formula, */
    WHAT = 15,  /* words */
    VALUE_WIDTH = 11,
    UNIT_WIDTH = 4,
    LINE_MOST = 100,
    DIGITS = 4 /* significant digits at least, */
};
/* what is less than this is printed as a bare 0 */
static const double least = 1e-7;

static const struct printed_unit {
    int decimals;
    const char *plain, *utf8;
} units[] = {
    [PP_UNIT_SHARE] = {4, " %", " %"},
    [PP_UNIT_NUMBER] = {4, "", ""},
    [PP_UNIT_COUNT] = {4, "", ""},
    [PP_UNIT_ANGLE] = {2, " deg", "\xc2\xb0"},
    [PP_UNIT_METRE] = {3, " m", " m"},
    [PP_UNIT_SQUARE_METRE] = {3, " m2", " m\xc2\xb2"},
    [PP_UNIT_LUX] = {1, " lx", " lx"},
};

/* Decimals that show DIGITS significant digits, and what a unit has at least; of what
 * was counted in tenths those. */
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

/* The value as people write it in its unit; the unit. */
static const char *write_value(char *text, size_t room,
                               const struct pp_calculation_step *step, bool utf8)
{
    const struct printed_unit *unit = &units[step->unit];
    double value = step->value * pp_steps_printed_unit(step->unit);
    int decimals = decimals_of(value, step);
    if (fabs(value) < least)
        value = 0.0; /* no minus before a zero */
    snprintf(text, room, "%.*f", decimals, value);
    return utf8 ? unit->utf8 : unit->plain;
}

/* ---- formulae ---- */

static const struct {
    const char *name, *utf8;
} greek[] = {
    {"alpha", "\xce\xb1"}, {"beta", "\xce\xb2"}, {"gamma", "\xce\xb3"},
    {"theta", "\xce\xb8"}, {"eta", "\xce\xb7"},  {"omega", "\xcf\x89"},
    {"phi", "\xcf\x86"},   {"psi", "\xcf\x88"},  {"rho", "\xcf\x81"},
    {"tau", "\xcf\x84"},   {"pi", "\xcf\x80"},
};

/* A word of a formula, a name at its beginning in Greek letters, a minus as one. */
static void write_word(char *text, size_t room, const char *word, int length, bool utf8)
{
    snprintf(text, room, "%.*s", utf8 ? 0 : length, word);
    for (int i = 0; i < length && utf8;) {
        int letters = 0;
        while (i + letters < length && isalpha((unsigned char)word[i + letters]))
            letters++;
        const char *found = NULL;
        for (size_t k = 0; k < sizeof greek / sizeof greek[0] && letters; k++)
            if ((int)strlen(greek[k].name) == letters
                && strncmp(greek[k].name, word + i, (size_t)letters) == 0)
                found = greek[k].utf8;
        if (!found && !letters && word[i] == '-')
            found = "\xe2\x88\x92";
        int taken = letters ? letters : 1;
        pp_text_append(text, room, "%.*s", found ? (int)strlen(found) : taken,
                       found ? found : word + i);
        i += taken;
    }
}

/* "      IRC = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)", broken at blanks. */
static void print_formula(const struct pp_calculation_step *step, int width, bool utf8,
                          FILE *out)
{
    char whole[sizeof step->symbol + sizeof step->formula + 4], words[4 * sizeof whole];
    snprintf(whole, sizeof whole, "%s%s= %s", step->symbol, step->symbol[0] ? " " : "",
             step->formula);
    words[0] = '\0';
    for (const char *at = whole; *at;) {
        int letters = (int)strcspn(at, " ");
        char word[sizeof words];
        write_word(word, sizeof word, at, letters, utf8);
        pp_text_append(words, sizeof words, "%s ", word);
        at += letters + (at[letters] == ' ');
    }
    fprintf(out, "%*s", SYMBOL, "");
    pp_print_wrapped(words, SYMBOL, MORE, width, out);
}

/* ---- steps ---- */

/* How much of the words, broken at a blank, goes on a line. */
static int fitting(const char *words, int room)
{
    int length = (int)strlen(words);
    if (length <= room)
        return length;
    for (int i = room; i > 0; i--)
        if (words[i] == ' ')
            return i;
    return room;
}

/* What it is; the opening stands in the heading already. */
static const char *without_opening(const struct pp_calculation_step *step)
{
    char said[40];
    int length = snprintf(said, sizeof said, "opening on line %d: ", step->line);
    return strncmp(step->what, said, (size_t)length) == 0 ? step->what + length
                                                          : step->what;
}

static void print_step(const struct pp_calculation_step *step, int width, bool utf8,
                       FILE *out)
{
    char value[48], symbol[64] = "";
    const char *unit = write_value(value, sizeof value, step, utf8);
    if (step->formula[0])
        print_formula(step, width, utf8, out);
    else
        write_word(symbol, sizeof symbol, step->symbol, (int)strlen(step->symbol),
                   utf8);
    fprintf(out, "%*s%s", SYMBOL, "", symbol);
    int column = SYMBOL + pp_format_utf8_width(symbol);
    int gap = column + 2 > WHAT ? 2 : WHAT - column;
    int room = width - column - gap - VALUE_WIDTH - UNIT_WIDTH;

    const char *words = without_opening(step);
    int length = fitting(words, room);
    fprintf(out, "%*s%-*.*s%*s%s\n", gap, "", room, length, words, VALUE_WIDTH, value,
            unit);
    for (words += length; *words; words += length) {
        words += strspn(words, " ");
        length = fitting(words, width - WHAT - 2);
        fprintf(out, "%*s%.*s\n", WHAT + 2, "", length, words);
    }
}

static void print_list(const struct pp_steps *steps, int width, bool utf8, FILE *out)
{
    int line = 0;
    for (int i = 0; i < steps->count; i++) {
        const struct pp_calculation_step *step = &steps->list[i];
        if (step->line != line && step->line)
            fprintf(out, "%*sopening on line %d\n", HEAD, "", step->line);
        else if (step->line != line)
            fprintf(out, "%*sall openings\n", HEAD, "");
        line = step->line;
        print_step(step, width, utf8, out);
    }
}

/* What a method's figures have in them already; pairs are of two methods, each with
 * words of its own. */
static void print_contents(const char *name, int width, FILE *out)
{
    const struct pp_method *method = pp_method_find(name);
    if (!method)
        return;
    char contents[160], text[256];
    pp_allowance_words(contents, sizeof contents, method->allowances);
    snprintf(text, sizeof text, "As published [%s], its figures contain %s.",
             method->source, contents);
    fprintf(out, "%*s", HEAD, "");
    pp_print_wrapped(text, HEAD, HEAD, width, out);
}

void pp_df_steps(const struct pp_report *report, int width, bool utf8, FILE *out)
{
    static const char *const names[PP_COMPONENT_COUNT] = {
        [PP_SC] = "direct component",
        [PP_ERC] = "externally reflected component",
        [PP_IRC] = "internally reflected component",
        [PP_DF] = "daylight factor",
    };
    if (width > LINE_MOST)
        width = LINE_MOST;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_reading *reading = column->points && report->receiver_count > 0
                                               ? column->points
                                               : &column->average;
        if (!reading->steps)
            continue;
        fprintf(out, "\n  %s by %s\n", names[column->component], column->name);
        print_contents(column->name, width, out);
        print_list(reading->steps, width, utf8, out);
    }
}
