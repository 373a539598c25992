/* formula_markup.h - a formula as marked-up text for print: names in italics, text
 * after an underscore as a subscript, numeric exponents raised, names of functions
 * upright. */
#ifndef PP_CHARTS_NOTE_FORMULA_MARKUP_H
#define PP_CHARTS_NOTE_FORMULA_MARKUP_H

#include <stddef.h>

/* Adds the formula, in the UTF-8 form of step_text.h, to `markup` (a buffer of `room`
 * bytes). size_mm: type size. */
void pp_formula_markup(char *markup, size_t room, const char *formula, double size_mm);

/* Adds plain text. */
void pp_formula_markup_words(char *markup, size_t room, const char *words);

#endif
