/* rad_numbers.h - numbers in Radiance scene files: with a point whatever the locale,
 * and as many digits as bring the double back. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_NUMBERS_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_NUMBERS_H

#include <stdio.h>

/* The shortest of 15 to 17 digits that reads back as the same double; `text` has room
 * for 32. */
void pp_rad_numbers_text(double number, char *text);

/* The number of 15 digits nearest to it. */
double pp_rad_numbers_round(double number);

/* Writes the count, then all numbers, on a line. */
void pp_rad_numbers_write(FILE *out, const double *numbers, int count);

#endif
