/* worksheet.h - a calculation as on paper: values are recorded by symbol, and formulae
 * are evaluated from the values already recorded.
 *
 * The program computes exactly what --explain prints: pp_worksheet_work takes its
 * values from the sheet, by the symbols in the formula's text. Arguments and results
 * are in the program's units (fractions, radians, metres); texts are in printed units.
 */
#ifndef PP_MODEL_RESULTS_WORKSHEET_H
#define PP_MODEL_RESULTS_WORKSHEET_H

#include <stdarg.h>
#include <stdbool.h>

#include "model/expression/expression_value.h"
#include "model/results/formula.h"
#include "model/results/steps.h"

enum { PP_WORKSHEET_MOST = 40, PP_WORKSHEET_PLACES = 64 };

/* Initialise with zeros and set the known members. */
struct pp_worksheet {
    struct pp_steps *steps;               /* list of recorded steps; NULL: not
                                           * recorded */
    const struct pp_formulary *formulary; /* not owned; NULL: published formulae only */
    /* First failure of a reader's variant of a formula: the reason, as the end of a
     * sentence ("divides by zero"), and the column in the variant's text. */
    struct pp_expression_fault fault;
    bool varied; /* true once a reader's variant was evaluated */
    int part;    /* number appended to the symbols of new steps; 0: none */
    int count;
    /* By hash of the symbol: 1 + index of the latest value; 0: none. */
    unsigned char latest[PP_WORKSHEET_PLACES];
    struct pp_worksheet_figure {
        const char *symbol; /* not owned */
        int part;
        double printed; /* in printed units */
    } list[PP_WORKSHEET_MOST];
};

/* Records an input value; it replaces an earlier value with that symbol. */
void pp_worksheet_put(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                      const char *symbol, const char *what, ...)
    __attribute__((format(printf, 5, 6)));
void pp_worksheet_put_v(struct pp_worksheet *sheet, enum pp_step_unit unit,
                        double value, const char *symbol, const char *what,
                        va_list args) __attribute__((format(printf, 5, 0)));

/* Records a value without a step: a quantity that only readers' variants may use. */
void pp_worksheet_know(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                       const char *symbol);

/* Appends a value without a symbol, as a step only. */
void pp_worksheet_note(struct pp_worksheet *sheet, enum pp_step_unit unit, double value,
                       const char *what, ...) __attribute__((format(printf, 4, 5)));

/* Evaluates a formula from the values on the sheet, records the result under the
 * formula's symbol, and returns it in the unit of its left side (program's units). All
 * quantities of the formula must be on the sheet. */
double pp_worksheet_work(struct pp_worksheet *sheet, const struct pp_formula *formula,
                         const char *what, ...) __attribute__((format(printf, 3, 4)));

/* Latest value of that symbol, in printed units; NAN: none. */
double pp_worksheet_printed(const struct pp_worksheet *sheet, const char *symbol);

#endif
