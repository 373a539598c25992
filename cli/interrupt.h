/* interrupt.h - Ctrl-C, as a request to stop and to print the results so far. */
#ifndef PP_CLI_INTERRUPT_H
#define PP_CLI_INTERRUPT_H

#include <stdbool.h>

/* From here on the first SIGINT or SIGTERM is noted; a second one ends the program as
 * it would have without this. A signal that was ignored stays so. */
void pp_interrupt_watch(void);

bool pp_interrupt_came(void);

#endif
