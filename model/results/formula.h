/* formula.h - a published formula as data: the program evaluates its text, --explain
 * prints it and the manual shows it.
 *
 *     const struct pp_formula bre = {
 *         .symbol = "irc", .sum = "0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)", ...};
 *
 * The sum is an expression (expression.h) in printed units (steps.h): daylight factors
 * in per cent, angles in degrees, lengths in metres. The values of its quantities and
 * its result are in the program's units: fractions, radians, metres. So the text of a
 * formula for a daylight factor must give per cent; otherwise its result is 100 times
 * too low. A reader's variant of a formula is another sum of the same quantities.
 */
#ifndef PP_MODEL_RESULTS_FORMULA_H
#define PP_MODEL_RESULTS_FORMULA_H

#include "model/base/error.h"
#include "model/expression/expression_value.h"
#include "model/results/steps.h"

/* A quantity that a formula, or a reader's variant of it, may use. */
struct pp_formula_quantity {
    const char *symbol;     /* a NULL symbol ends the list */
    enum pp_step_unit unit; /* unit in the text: printed units (steps.h) */
    const char *what;
};

struct pp_formula {
    const char *symbol, *sum; /* left and right side */
    enum pp_step_unit unit;   /* unit of the left side */
    const char *source; /* key of docs/SOURCES.md and place in the work: "GEEBELEN,
                         * eq. 15"; NULL: the program's own convention */
    const char *what;   /* description of the left side */
    const struct pp_formula_quantity *quantities;
    bool fixed; /* no variants: part of a table, or one of several cases */
};

/* True if a variant for that symbol may replace this formula. The quantities of the
 * variant are not checked. */
bool pp_formula_is_open(const struct pp_formula *formula, const char *symbol);

/* True if the expression has the same power of metres as the formula's left side. Other
 * units are not compared, since plain numbers can replace them: in the formula of the
 * average daylight factor, degrees become per cent. */
bool pp_formula_comes_out(const struct pp_formula *formula,
                          const struct pp_expression *expression);

/* Parses the formula's own sum or a variant of it, like pp_expression_parse. */
bool pp_formula_parse(struct pp_expression *expression,
                      const struct pp_formula *formula, const char *sum, int shift,
                      struct pp_expression_mistake *mistake);

/* Evaluates the published sum. Values are in the order of the quantities. Values and
 * result are in the program's units (fractions, radians, metres). */
double pp_formula_value(const struct pp_formula *formula, const double *values);

/* A reader's formula for a symbol. */
struct pp_formula_variant {
    char symbol[32], sum[PP_EXPRESSION_MOST + 1];
    int shift; /* column of the sum in the reader's text, from 0 */
};

/* Parsed formulae of a method, for use at many points. formulae: NULL-terminated, or
 * NULL for none. variant (not owned; NULL: none) replaces every formula for its symbol
 * that is not fixed, has all quantities that the variant uses, and has the variant's
 * power of metres. */
struct pp_formulary;
enum pp_status pp_formulary_create(struct pp_formulary **formulary,
                                   const struct pp_formula *const *formulae,
                                   const struct pp_formula_variant *variant,
                                   struct pp_error *err);
void pp_formulary_destroy(struct pp_formulary *formulary);

/* Parsed formula from the formulary. If the formulary is NULL or does not contain the
 * formula, the published formula is parsed into `spare`. *sum: text of the formula;
 * *own: true for a reader's variant. */
const struct pp_expression *pp_formulary_find(const struct pp_formulary *formulary,
                                              const struct pp_formula *formula,
                                              struct pp_expression *spare,
                                              const char **sum, bool *own);

#endif
