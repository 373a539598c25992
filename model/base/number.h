/* number.h - numbers as people write them, whatever the locale. */
#ifndef PP_MODEL_NUMBER_H
#define PP_MODEL_NUMBER_H

#include <stdbool.h>

/* Reads the whole of text as one decimal number with a point ("2.6", "-.5", "1e-3"),
 * white space around it allowed. False, and *value untouched, for anything else: an
 * empty text, a comma, a unit behind, hexadecimal, inf, nan, or too large for a double.
 */
bool pp_number_parse(const char *text, double *value);

#endif
