/* format.h - text and numbers in reports: names of components, CSV fields, and the
 * width of UTF-8 text. */
#ifndef PP_REPORTS_PARTS_FORMAT_H
#define PP_REPORTS_PARTS_FORMAT_H

#include <stdbool.h>
#include <stdio.h>
#include "pepperpot.h"

/* Names of components in JSON and CSV: "sc", "erc", "irc", "df". */
extern const char *const pp_component_names[PP_COMPONENT_COUNT];

/* Names of components for readers, such as "sky component". */
extern const char *const pp_component_titles[PP_COMPONENT_COUNT];

/* Writes a number by a printf format, right-aligned in `width` columns; a dash if the
 * number is not finite. */
void pp_format_cell(double value, const char *format, int width, FILE *out);

/* CSV fields [RFC4180]. */

/* Writes a CSV field, in quotes if it contains a separator. NULL is an empty field. An
 * apostrophe is placed before text that a spreadsheet would treat as a formula: text
 * that begins with = + - @, a tab or a carriage return and is not a number. Bytes that
 * are not UTF-8 are replaced by U+FFFD. */
void pp_format_csv_field(const char *text, FILE *out);

/* Writes a comma and a number with ten significant digits. If the number is not finite,
 * writes only the comma. */
void pp_format_csv_number(double number, FILE *out);

/* Text given by users (names, paths), made safe for printing. */

/* Number of bytes of the first character; 1 if the byte does not begin a valid
 * character; 0 at the end of the text. */
int pp_format_utf8_length(const char *text);

/* Width of text printed by pp_format_utf8_put, in columns of a terminal. */
int pp_format_utf8_width(const char *text);

/* Prints text. Control characters and bytes that are not UTF-8 are printed as codes
 * such as \x1b, so that text cannot move the cursor or begin a new line. */
void pp_format_utf8_put(FILE *out, const char *text);

/* Copies text with U+FFFD in place of each byte that is not UTF-8. NULL: out of
 * memory. */
char *pp_format_utf8_repair(const char *text);

#endif
