/* rad_numbers.h - numbers in Radiance scene files: a decimal point in any locale, and
 * enough digits to read the same double back. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_NUMBERS_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_NUMBERS_H

#include <stdio.h>

/* Writes the number with the fewest digits, 15 to 17, that read back as the same
 * double; `text` has space for 32 characters. */
void pp_rad_numbers_text(double number, char *text);

/* Rounds to 15 significant digits. */
double pp_rad_numbers_round(double number);

/* Writes the count and all numbers on one line. */
void pp_rad_numbers_write(FILE *out, const double *numbers, int count);

#endif
