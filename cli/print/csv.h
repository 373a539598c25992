/* csv.h - the fields that every CSV of the program is put together with [RFC4180]. */
#ifndef PP_CLI_CSV_H
#define PP_CLI_CSV_H

#include <stdio.h>

/* A field, in quotes where it holds what would end it; NULL is an empty one. */
void pp_csv_field(const char *text, FILE *out);

/* A comma and a number of ten significant digits; nothing behind the comma for what is
 * not finite. */
void pp_csv_number(double number, FILE *out);

#endif
