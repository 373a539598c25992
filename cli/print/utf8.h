/* utf8.h - text that others wrote (names, paths), made fit to print. */
#ifndef PP_CLI_UTF8_H
#define PP_CLI_UTF8_H

#include <stdbool.h>
#include <stdio.h>

/* Bytes of the first character; 1 for a byte that starts no valid one; 0 at the end. */
int pp_utf8_length(const char *text);

/* Columns that text takes on a terminal, as pp_utf8_put prints it. */
int pp_utf8_width(const char *text);

/* Prints text with control characters and bytes that are not UTF-8 as \x1b, so that
 * nothing in it can move the cursor or start a new line. */
void pp_utf8_put(FILE *out, const char *text);

/* A copy with U+FFFD for each byte that is not UTF-8; NULL when memory is out. */
char *pp_utf8_repair(const char *text);

/* Does the terminal expect UTF-8? By LC_CTYPE, which main has set. */
bool pp_utf8_terminal(void);

#endif
