/* terminal.h - what the terminal can show: its width, and its letters. */
#ifndef PP_CLI_TERMINAL_H
#define PP_CLI_TERMINAL_H

#include <stdbool.h>

/* Columns of text for an output: as many as the terminal has, within reason, or 80
 * where it goes to a file or a pipe. output NULL: standard output. */
int pp_terminal_width(const char *output);

/* Does the terminal expect UTF-8? By LC_CTYPE, which main has set. */
bool pp_terminal_utf8(void);

#endif
