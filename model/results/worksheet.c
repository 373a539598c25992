/* worksheet.c - stores values by symbol; evaluates formulae from these values and
 * records them as steps, with the part numbers of symbols. */
#include "model/results/worksheet.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"

/* Hash of a symbol, from its first two letters. */
static int symbol_place(const char *symbol)
{
    return (symbol[0] + 9 * symbol[1]) & (PP_WORKSHEET_PLACES - 1);
}

/* Value with that symbol; place: hash of the symbol. NULL: none. Equal symbols are
 * usually the same string literal, so pointers are compared first. */
static const struct pp_worksheet_figure *find_at(const struct pp_worksheet *sheet,
                                                 int place, const char *symbol)
{
    int latest = sheet->latest[place];
    if (latest == 0)
        return NULL;
    if (sheet->list[latest - 1].symbol == symbol)
        return &sheet->list[latest - 1];
    for (int i = sheet->count - 1; i >= 0; i--)
        if (sheet->list[i].symbol == symbol)
            return &sheet->list[i];
    for (int i = 0; i < sheet->count; i++)
        if (pp_text_is_same(sheet->list[i].symbol, symbol))
            return &sheet->list[i];
    return NULL;
}

static const struct pp_worksheet_figure *find_symbol(const struct pp_worksheet *sheet,
                                                     const char *symbol)
{
    return find_at(sheet, symbol_place(symbol), symbol);
}

static void enter(struct pp_worksheet *sheet, const char *symbol, double printed)
{
    if (!symbol[0])
        return;
    /* A repeated symbol replaces its previous value. */
    int place = symbol_place(symbol);
    const struct pp_worksheet_figure *last = find_at(sheet, place, symbol);
    int at = last ? (int)(last - sheet->list) : sheet->count;
    assert(at < PP_WORKSHEET_MOST);
    sheet->list[at] = (struct pp_worksheet_figure){symbol, sheet->part, printed};
    sheet->latest[place] = (unsigned char)(at + 1);
    sheet->count += at == sheet->count;
}

/* Writes "T_hl", or "T_hl_2" for part 2. */
static void write_symbol(char text[32], const char *symbol, int part)
{
    if (part > 0)
        snprintf(text, 32, "%s_%d", symbol, part);
    else
        snprintf(text, 32, "%s", symbol);
}

void pp_worksheet_know(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                       const char *symbol)
{
    enter(sheet, symbol, value * pp_steps_printed_unit(unit));
}

void pp_worksheet_put(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                      const char *symbol, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    pp_worksheet_put_v(sheet, unit, value, symbol, what, args);
    va_end(args);
}

void pp_worksheet_put_v(struct pp_worksheet *sheet, enum pp_step_unit unit,
                        double value, const char *symbol, const char *what,
                        va_list args)
{
    pp_worksheet_know(sheet, unit, value, symbol);
    if (!sheet->steps)
        return;
    char numbered[32];
    write_symbol(numbered, symbol, sheet->part);
    pp_steps_add_v(sheet->steps, unit, value, numbered, "", what, args);
}

void pp_worksheet_note(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                       const char *what, ...)
{
    if (!sheet->steps)
        return;
    va_list args;
    va_start(args, what);
    pp_steps_add_v(sheet->steps, unit, value, "", "", what, args);
    va_end(args);
}

static const struct pp_worksheet_figure *find_figure(const struct pp_worksheet *sheet,
                                                     const char *symbol, int length)
{
    for (int i = 0; i < sheet->count; i++)
        if (pp_text_is_word(sheet->list[i].symbol, symbol, (size_t)length))
            return &sheet->list[i];
    return NULL;
}

double pp_worksheet_printed(const struct pp_worksheet *sheet, const char *symbol)
{
    const struct pp_worksheet_figure *figure = find_symbol(sheet, symbol);
    return figure ? figure->printed : NAN;
}

/* Writes the formula's text, with the part number appended to each symbol that has
 * one. */
static void write_sum(char *text, size_t room, const struct pp_worksheet *sheet,
                      const char *sum)
{
    text[0] = '\0';
    while (*sum) {
        int length = pp_expression_name_length(sum);
        const struct pp_worksheet_figure *figure =
            length > 0 ? find_figure(sheet, sum, length) : NULL;
        pp_text_append(text, room, "%.*s", length > 0 ? length : 1, sum);
        if (figure && figure->part > 0)
            pp_text_append(text, room, "_%d", figure->part);
        sum += length > 0 ? length : 1;
    }
}

double pp_worksheet_work(struct pp_worksheet *sheet, const struct pp_formula *formula,
                         const char *what, ...)
{
    struct pp_expression spare;
    const char *sum;
    bool own;
    const struct pp_expression *expression =
        pp_formulary_find(sheet->formulary, formula, &spare, &sum, &own);
    double values[PP_WORKSHEET_MOST];
    for (int i = 0; i < expression->name_count; i++) {
        const char *symbol = formula->quantities[expression->names[i]].symbol;
        const struct pp_worksheet_figure *figure = find_symbol(sheet, symbol);
        assert(figure);
        values[expression->names[i]] = figure ? figure->printed : NAN;
    }
    struct pp_expression_fault fault;
    double printed = pp_expression_value(expression, values, own ? &fault : NULL);
    sheet->varied |= own;
    if (own && fault.what && !sheet->fault.what)
        sheet->fault = fault;
    double value = printed / pp_steps_printed_unit(formula->unit);
    if (sheet->steps) {
        char numbered[32], text[sizeof sheet->steps->list->formula];
        write_symbol(numbered, formula->symbol, sheet->part);
        write_sum(text, sizeof text, sheet, sum);
        va_list args;
        va_start(args, what);
        pp_steps_add_v(sheet->steps, formula->unit, value, numbered, text, what, args);
        va_end(args);
    }
    enter(sheet, formula->symbol, printed);
    return value;
}
