/* step_text.h - the pieces of a calculation's steps as they are printed: value, unit,
 * formula, and the formula with its values put in. The report in text and the typeset note
 * share them, so that they have the same figures to the digit.
 *
 * Values have enough digits that a formula recomputed from the printed figures gives the
 * printed value, to within their rounding.
 */
#ifndef PP_MODEL_RESULTS_STEP_TEXT_H
#define PP_MODEL_RESULTS_STEP_TEXT_H

#include <stddef.h>

#include "model/results/steps.h"

/* The step's value as people write it in its unit: "0.4426". Returns the unit, " %" or
 * "". */
const char *pp_step_text_value(char *text, size_t room,
                               const struct pp_calculation_step *step, bool utf8);

/* Adds the first `length` bytes of a formula or symbol; in UTF-8 names that begin with a
 * Greek letter's have the letter, and a minus is one: "α_1 − β". */
void pp_step_text_add(char *text, size_t room, const char *words, int length,
                      bool utf8);

/* The whole formula of a step that has one: "irc = 0.85 W / (A (1 − R))". */
void pp_step_text_formula(char *text, size_t room,
                          const struct pp_calculation_step *step, bool utf8);

/* The right side with the printed values of the steps before in place of their symbols,
 * in UTF-8: "0.85 × 1.560 / (100.512 × (1 − 0.5221))"; empty where the formula is one
 * symbol, or has none. */
void pp_step_text_put_in(char *text, size_t room, const struct pp_steps *steps,
                         int index);

#endif
