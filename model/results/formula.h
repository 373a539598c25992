/* formula.h - a published formula as data: the program evaluates its text, --explain
 * prints it and the manual shows it.
 *
 *     const struct pp_formula bre = {
 *         .symbol = "irc", .sum = "0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)", ...};
 *
 * The sum is an expression (expression.h) in the units of print (steps.h): daylight
 * factors in per cent, angles in degrees, lengths in metres. The values of its
 * quantities and its result are in the program's units: fractions, radians, metres. A
 * formula whose result is a fraction must therefore be multiplied by 100 in its text,
 * or its result is 100 times too low. A reader's variant of a formula is another sum of
 * the same quantities.
 */
#ifndef PP_MODEL_RESULTS_FORMULA_H
#define PP_MODEL_RESULTS_FORMULA_H

#include "model/base/error.h"
#include "model/results/expression_value.h"
#include "model/results/steps.h"

/* A quantity that a formula, or a reader's variant of it, may name. */
struct pp_formula_quantity {
    const char *symbol;     /* NULL ends a list */
    enum pp_step_unit unit; /* in the text: of a daylight factor per cent */
    const char *what;
};

struct pp_formula {
    const char *symbol, *sum; /* left and right side */
    enum pp_step_unit unit;   /* of the left side; in the text as above */
    const char *source; /* key of docs/SOURCES.md and place in the work: "GEEBELEN,
                             * eq. 15"; NULL: the program's own convention */
    const char *what;   /* the left side in words */
    const struct pp_formula_quantity *quantities;
    bool fixed; /* it enters a table, or is one of several by the case: no variant */
};

/* True if a variant of that symbol can replace this formula, if its quantities
 * allow. */
bool pp_formula_is_open(const struct pp_formula *formula, const char *symbol);

/* True if the expression's dimension fits the formula's left side, apart from hidden
 * units of its numbers: in the average daylight factor degrees become per cent. */
bool pp_formula_comes_out(const struct pp_formula *formula,
                          const struct pp_expression *expression);

/* Parses the formula's own sum or a variant of it, as pp_expression_parse does. */
bool pp_formula_parse(struct pp_expression *expression,
                      const struct pp_formula *formula, const char *sum, int shift,
                      struct pp_expression_mistake *mistake);

/* Evaluates the published sum; values in the order of the quantities, in the program's
 * units (fractions, radians, metres), as the result is. */
double pp_formula_value(const struct pp_formula *formula, const double *values);

/* A reader's sum for a symbol. */
struct pp_formula_variant {
    char symbol[32], sum[PP_EXPRESSION_MOST + 1];
    int shift; /* column of the sum in the reader's text, from 0 */
};

/* The formulae of a method, parsed once for many points. The list ends with NULL; NULL
 * for the list: none. A variant (not owned; NULL: none) replaces all formulae of its
 * symbol that are not fixed and have the quantities that it uses. */
struct pp_formulary;
enum pp_status pp_formulary_create(struct pp_formulary **formulary,
                                   const struct pp_formula *const *formulae,
                                   const struct pp_formula_variant *variant,
                                   struct pp_error *err);
void pp_formulary_destroy(struct pp_formulary *formulary);

/* Parsed formula: that of the formulary (which may be NULL) or, if it has none, the
 * published one, parsed into `spare`. *sum is its text; *own: true for a reader's. */
const struct pp_expression *pp_formulary_find(const struct pp_formulary *formulary,
                                              const struct pp_formula *formula,
                                              struct pp_expression *spare,
                                              const char **sum, bool *own);

#endif
