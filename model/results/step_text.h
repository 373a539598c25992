/* step_text.h - the steps of a calculation as text: value, unit, formula, and the
 * formula with values substituted. The text report and the typeset note use the same
 * functions, so that their figures agree in every digit.
 *
 * Values have enough digits that a formula recomputed from printed figures gives the
 * printed value, within rounding.
 */
#ifndef PP_MODEL_RESULTS_STEP_TEXT_H
#define PP_MODEL_RESULTS_STEP_TEXT_H

#include <stddef.h>

#include "model/results/steps.h"

/* Writes the value in printed units: "0.4426". Returns the unit, " %" or "". */
const char *pp_step_text_value(char *text, size_t room,
                               const struct pp_calculation_step *step, bool utf8);

/* Appends the first `length` bytes of a formula or symbol. In UTF-8, a run of letters
 * that spells a Greek letter becomes that letter, and a hyphen becomes a minus: "α_1 −
 * β". */
void pp_step_text_add(char *text, size_t room, const char *words, int length,
                      bool utf8);

/* Writes the whole formula of a step that has one: "irc = 0.85 W / (A (1 − R))". */
void pp_step_text_formula(char *text, size_t room,
                          const struct pp_calculation_step *step, bool utf8);

/* Writes the right side with the values of earlier steps substituted for their symbols,
 * in UTF-8: "0.85 × 1.560 / (100.512 × (1 − 0.5221))". Empty if no value is
 * substituted, or the formula is a single symbol. */
void pp_step_text_put_in(char *text, size_t room, const struct pp_steps *steps,
                         int index);

#endif
