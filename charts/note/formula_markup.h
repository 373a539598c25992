/* formula_markup.h - a formula in print as marked-up text: names in italics, text after
 * an underscore as a subscript, whole powers raised, names of functions upright. */
#ifndef PP_CHARTS_NOTE_FORMULA_MARKUP_H
#define PP_CHARTS_NOTE_FORMULA_MARKUP_H

#include <stddef.h>

/* Adds the formula, as step_text.h writes it in UTF-8, to `markup` of `room` bytes, for
 * type of that size. */
void pp_formula_markup(char *markup, size_t room, const char *formula, double size_mm);

/* Adds words as they are. */
void pp_formula_markup_words(char *markup, size_t room, const char *words);

#endif
