/* interrupt.h - handles Ctrl-C: the program is to stop, and to print the results so
 * far. */
#ifndef PP_CLI_INTERRUPT_H
#define PP_CLI_INTERRUPT_H

#include <stdbool.h>

/* Begins to handle SIGINT and SIGTERM. The first signal is stored; a second one of the
 * same kind ends the program as usual. A signal that was ignored remains ignored. */
void pp_interrupt_watch(void);

/* Ends the handling: a signal then ends the program at once, as before
 * pp_interrupt_watch. For a write that may wait forever for its reader. */
void pp_interrupt_end_at_once(void);

bool pp_interrupt_came(void);

#endif
