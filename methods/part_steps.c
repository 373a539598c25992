/* part_steps.c - numbers the symbols of the parts, and records the sums over the
 * parts. */
#include "methods/part_steps.h"
#include "model/base/text.h"

#include <stdio.h>

struct pp_part_steps pp_part_steps_begin(struct pp_steps *steps, int parts)
{
    return (struct pp_part_steps){
        .steps = steps, .first = steps ? steps->count : 0, .parts = parts};
}

struct pp_part_steps pp_part_steps_on(struct pp_worksheet *sheet, int parts)
{
    struct pp_part_steps terms = pp_part_steps_begin(sheet->steps, parts);
    terms.sheet = sheet;
    return terms;
}

void pp_part_steps_next(struct pp_part_steps *terms)
{
    terms->number++;
    if (terms->sheet)
        terms->sheet->part = terms->parts == 1 ? 0 : terms->number;
}

struct symbol {
    char text[16];
};

/* Symbol of a quantity: "n", or "n_2" if the opening has several parts. */
static struct symbol numbered(const struct pp_part_steps *terms, const char *name)
{
    struct symbol symbol;
    if (terms->parts == 1)
        snprintf(symbol.text, sizeof symbol.text, "%s", name);
    else
        snprintf(symbol.text, sizeof symbol.text, "%s_%d", name, terms->number);
    return symbol;
}

/* Copies the formula with the part's number (or nothing) in place of each #. */
static void number(char *text, size_t room, const struct pp_part_steps *terms,
                   const char *formula)
{
    for (text[0] = '\0'; *formula; formula++)
        if (*formula != '#')
            pp_text_append(text, room, "%c", *formula);
        else if (terms->parts > 1)
            pp_text_append(text, room, "_%d", terms->number);
}

void pp_part_steps_read(const struct pp_part_steps *terms, enum pp_step_unit unit,
                        double value, const char *name, const char *what)
{
    if (terms->sheet)
        pp_worksheet_put(terms->sheet, unit, value, name, "%s", what);
    else
        pp_steps_add_named(terms->steps, unit, value, numbered(terms, name).text, "%s",
                           what);
}

void pp_part_steps_figure(struct pp_part_steps *terms, enum pp_step_unit unit,
                          double value, const char *name, const char *formula,
                          const char *what)
{
    char text[160];
    number(text, sizeof text, terms, formula);
    pp_steps_add_worked(terms->steps, unit, value, numbered(terms, name).text, text,
                        "%s", what);
}

/* Includes a component in the sums. */
static void count(struct pp_part_steps *terms, bool hidden, double share)
{
    *(hidden ? &terms->hidden_count : &terms->sky_count) += 1;
    if (!hidden)
        terms->sky += share;
}

double pp_part_steps_work(struct pp_part_steps *terms, bool hidden,
                          const struct pp_formula *formula, const char *what)
{
    double share = pp_worksheet_work(terms->sheet, formula, "%s", what);
    count(terms, hidden, share);
    return share;
}

void pp_part_steps_component(struct pp_part_steps *terms, bool hidden, double share,
                             const char *formula, const char *what)
{
    count(terms, hidden, share);
    pp_part_steps_figure(terms, PP_UNIT_DAYLIGHT_FACTOR, share, hidden ? "erc" : "sc",
                         formula, what);
}

void pp_part_steps_end(struct pp_part_steps *terms)
{
    if (terms->sheet)
        terms->sheet->part = 0;
    if (!terms->steps)
        return;
    bool single = terms->parts == 1;
    if (!single || terms->sky_count == 0)
        pp_steps_add_sum(terms->steps, terms->first, terms->number, "sc",
                         "sky component");
    if (terms->sky < 0.0)
        pp_steps_add_worked(terms->steps, PP_UNIT_DAYLIGHT_FACTOR, 0.0, "sc",
                            "max(sc, 0)",
                            "sky component, with negative values set to 0");
    if (terms->hidden_count > 0 && !single)
        pp_steps_add_sum(terms->steps, terms->first, terms->number, "erc",
                         "externally reflected component");
}
