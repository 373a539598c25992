/* terminal.h - capabilities of the terminal: its width, and its characters. */
#ifndef PP_CLI_TERMINAL_H
#define PP_CLI_TERMINAL_H

#include <stdbool.h>

/* Width of text for an output, in columns: that of the terminal, within limits, or 80
 * for a file or a pipe. output NULL: standard output. */
int pp_terminal_width(const char *output);

/* True if the terminal expects UTF-8 according to LC_CTYPE, which main sets. */
bool pp_terminal_utf8(void);

#endif
