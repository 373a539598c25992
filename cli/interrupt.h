/* interrupt.h - handles Ctrl-C as a request to stop and to print the results so far. */
#ifndef PP_CLI_INTERRUPT_H
#define PP_CLI_INTERRUPT_H

#include <stdbool.h>

/* Starts to handle SIGINT and SIGTERM. The first one is stored; a second one ends the
 * program as usual. A signal that was ignored stays ignored. */
void pp_interrupt_watch(void);

/* From now on, a signal ends the program at once, as before pp_interrupt_watch; for a
 * write that may wait forever for its reader. */
void pp_interrupt_end_at_once(void);

bool pp_interrupt_came(void);

#endif
