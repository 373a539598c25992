/* worksheet.h - a calculation on paper: figures are put down by name, and formulae are
 * evaluated from those above them.
 *
 * The program computes what --explain prints: pp_worksheet_work takes its values from
 * the sheet by the names in the formula's text. Figures go in and come out in the
 * program's units (fractions, radians, metres); the text's are those of print.
 */
#ifndef PP_MODEL_RESULTS_WORKSHEET_H
#define PP_MODEL_RESULTS_WORKSHEET_H

#include <stdarg.h>
#include <stdbool.h>

#include "model/results/expression_value.h"
#include "model/results/formula.h"
#include "model/results/steps.h"

enum { PP_WORKSHEET_MOST = 40, PP_WORKSHEET_PLACES = 64 };

/* Worksheet; initialise it with zeros and set the known members. */
struct pp_worksheet {
    struct pp_steps *steps;               /* where steps are set down; NULL: nowhere */
    const struct pp_formulary *formulary; /* not owned; NULL: all as published */
    /* First sum of a reader's variant without a result: the reason, as the end of a
     * sentence ("divides by nothing"), and the column in its text. */
    struct pp_expression_fault fault;
    bool varied; /* a reader's variant has been calculated */
    int part;    /* number behind the symbols that are put down now; 0: none */
    int count;
    /* Latest figure of each place that symbols have by their letters, counted from 1; 0:
     * no symbol of that place. */
    unsigned char latest[PP_WORKSHEET_PLACES];
    struct pp_worksheet_figure {
        const char *symbol; /* not owned */
        int part;
        double printed; /* in the units of print */
    } list[PP_WORKSHEET_MOST];
};

/* Puts down a figure that was read or put in; of one name, the latest counts. */
void pp_worksheet_put(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                      const char *symbol, const char *what, ...)
    __attribute__((format(printf, 5, 6)));
void pp_worksheet_put_v(struct pp_worksheet *sheet, enum pp_step_unit unit,
                        double value, const char *symbol, const char *what,
                        va_list args) __attribute__((format(printf, 5, 0)));

/* Puts down a figure without a step: a quantity for readers' variants that the
 * published formula does not use. */
void pp_worksheet_know(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                       const char *symbol);

/* Sets down a figure without a name, as a step. */
void pp_worksheet_note(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                       const char *what, ...) __attribute__((format(printf, 4, 5)));

/* Works a formula out of the figures on the sheet, puts down the result under the
 * formula's symbol, and returns it, in the unit of its left side. Every quantity of the
 * formula must be on the sheet. */
double pp_worksheet_work(struct pp_worksheet *sheet, const struct pp_formula *formula,
                         const char *what, ...) __attribute__((format(printf, 3, 4)));

/* The latest figure of that name, in the units of print; NAN: there is none. */
double pp_worksheet_printed(const struct pp_worksheet *sheet, const char *symbol);

#endif
