/* format.h - texts and numbers in reports: names of components, fields of CSV, and the
 * width of text in UTF-8. */
#ifndef PP_REPORTS_PARTS_FORMAT_H
#define PP_REPORTS_PARTS_FORMAT_H

#include <stdbool.h>
#include <stdio.h>
#include "pepperpot.h"

/* The names of components in JSON and CSV: "sc", "erc", "irc", "df". */
extern const char *const pp_component_names[PP_COMPONENT_COUNT];

/* Titles for readers: "sky component". */
extern const char *const pp_component_titles[PP_COMPONENT_COUNT];

/* Writes a number by a printf format, or a dash if it is not finite, right-aligned in
 * `width` columns. */
void pp_format_cell(double value, const char *format, int width, FILE *out);

/* Fields of CSV [RFC4180]. */

/* Writes a CSV field, in quotes if it contains a separator; NULL is written as an empty
 * field. An apostrophe is put before a text that a spreadsheet would run as a formula:
 * one that begins with = + - or @ and is not a number. Bytes that are not UTF-8 are
 * replaced by U+FFFD. */
void pp_format_csv_field(const char *text, FILE *out);

/* Writes a comma and a number of ten significant digits; nothing after the comma if it
 * is not finite. */
void pp_format_csv_number(double number, FILE *out);

/* Text from users (names, paths), made safe to print. */

/* Number of bytes of the first character; 1 for a byte that does not start a valid one;
 * 0 at the end. */
int pp_format_utf8_length(const char *text);

/* Width of text on a terminal, in columns, as printed by pp_format_utf8_put. */
int pp_format_utf8_width(const char *text);

/* Prints text with control characters and bytes that are not UTF-8 as \x1b, so that
 * nothing in it can move the cursor or start a new line. */
void pp_format_utf8_put(FILE *out, const char *text);

/* A copy with U+FFFD for each byte that is not UTF-8; NULL: out of memory. */
char *pp_format_utf8_repair(const char *text);

#endif
