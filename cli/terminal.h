/* terminal.h - width and character encoding of the terminal. */
#ifndef PP_CLI_TERMINAL_H
#define PP_CLI_TERMINAL_H

#include <stdbool.h>

/* Width of text for an output, in columns. For a terminal this is its width, within
 * limits; for a file or pipe, 80. output NULL: standard output. */
int pp_terminal_width(const char *output);

/* True if the terminal expects UTF-8, according to LC_CTYPE, which main sets from the
 * environment. */
bool pp_terminal_utf8(void);

#endif
