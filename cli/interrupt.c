/* interrupt.c - stores SIGINT and SIGTERM in a flag. A second signal of the same kind
 * ends the process. */
#include "cli/interrupt.h"

#include <signal.h>
#include <stddef.h>

/* The only variable with file scope in the program: a signal handler cannot pass data
 * in any other way. */
static volatile sig_atomic_t interrupted;

static const int watched[] = {SIGINT, SIGTERM};

static void note(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

void pp_interrupt_watch(void)
{
    for (size_t i = 0; i < sizeof watched / sizeof watched[0]; i++) {
        struct sigaction before;
        if (sigaction(watched[i], NULL, &before) != 0 || before.sa_handler == SIG_IGN)
            continue;
        struct sigaction action = {.sa_handler = note,
                                   .sa_flags = SA_RESTART | SA_RESETHAND};
        sigemptyset(&action.sa_mask);
        sigaction(watched[i], &action, NULL);
    }
}

void pp_interrupt_end_at_once(void)
{
    struct sigaction before;
    for (size_t i = 0; i < sizeof watched / sizeof watched[0]; i++)
        if (sigaction(watched[i], NULL, &before) == 0 && before.sa_handler == note)
            signal(watched[i], SIG_DFL);
}

bool pp_interrupt_came(void)
{
    return interrupted;
}
