/* df_steps.c - prints calculations in the layout of a hand calculation. Each formula is
 * on a separate line with its value below. A value that is given or read from a table
 * takes one line, with the value on the right. */
#include "reports/df_steps.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/format.h"
#include "reports/parts/print.h"
#include "methods/method.h"
#include "model/results/step_text.h"

enum {
    HEAD = 4,   /* indent of a heading, columns */
    SYMBOL = 6, /* indent of a symbol or formula */
    MORE = 10,  /* indent of further lines of a long formula */
    WHAT = 15,  /* indent of words */
    VALUE_WIDTH = 11,
    UNIT_WIDTH = 4,
    LINE_MOST = 100
};

/* ---- formulae ---- */

/* Prints a formula, such as " IRC = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)", broken at
 * blanks. */
static void print_formula(const struct pp_calculation_step *step, int width, bool utf8,
                          FILE *out)
{
    char words[4 * (sizeof step->symbol + sizeof step->formula)];
    pp_step_text_formula(words, sizeof words, step, utf8);
    fprintf(out, "%*s", SYMBOL, "");
    pp_print_wrapped(words, SYMBOL, MORE, width, out);
}

/* ---- steps ---- */

/* Number of bytes of the text that fit on a line, broken at a blank. */
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

static void print_step(const struct pp_calculation_step *step, int width, bool utf8,
                       FILE *out)
{
    char value[48], symbol[64] = "";
    const char *unit = pp_step_text_value(value, sizeof value, step, utf8);
    if (step->formula[0])
        print_formula(step, width, utf8, out);
    else
        pp_step_text_add(symbol, sizeof symbol, step->symbol, (int)strlen(step->symbol),
                         utf8);
    fprintf(out, "%*s%s", SYMBOL, "", symbol);
    int column = SYMBOL + pp_format_utf8_width(symbol);
    int gap = column + 2 > WHAT ? 2 : WHAT - column;
    int room = width - column - gap - VALUE_WIDTH - UNIT_WIDTH;

    const char *words = step->what;
    int length = fitting(words, room);
    fprintf(out, "%*s%-*.*s%*s%s\n", gap, "", room, length, words, VALUE_WIDTH, value,
            unit);
    for (words += length; *words; words += length) {
        words += strspn(words, " ");
        length = fitting(words, width - WHAT - 2);
        fprintf(out, "%*s%.*s\n", WHAT + 2, "", length, words);
    }
}

void pp_df_steps_list(const struct pp_steps *steps, const struct pp_world *world,
                      int width, bool utf8, FILE *out)
{
    if (width > LINE_MOST)
        width = LINE_MOST;
    int line = 0;
    for (int i = 0; i < steps->count; i++) {
        const struct pp_calculation_step *step = &steps->list[i];
        if (step->line != line && step->line)
            fprintf(out, "%*s%s %s\n", HEAD, "", pp_world_kind(world, step->line),
                    pp_world_label(world, step->line));
        else if (step->line != line)
            fprintf(out, "%*sall windows\n", HEAD, "");
        line = step->line;
        print_step(step, width, utf8, out);
    }
}

/* Prints the corrections that a method's figures include. Prints nothing for a pair of
 * methods. */
static void print_contents(const char *name, int width, FILE *out)
{
    const struct pp_method *method = pp_method_find(name);
    if (!method)
        return;
    char text[256];
    pp_allowance_sentence(text, sizeof text, method->source, method->allowances);
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
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_reading *reading = column->points && report->receiver_count > 0
                                               ? column->points
                                               : &column->average;
        if (!reading->steps)
            continue;
        fprintf(out, "\n  %s by %s\n", names[column->component], column->name);
        print_contents(column->name, width < LINE_MOST ? width : LINE_MOST, out);
        pp_df_steps_list(reading->steps, report->world, width, utf8, out);
    }
}
