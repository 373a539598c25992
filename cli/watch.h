/* watch.h - shows the progress of a simulation on the terminal, and stops the
 * simulation when the user interrupts. */
#ifndef PP_CLI_WATCH_H
#define PP_CLI_WATCH_H

#include "cli/progress.h"
#include "studies/study_options.h"

struct pp_terminal_watch {
    bool quiet;
    struct pp_progress progress;
};

/* Makes a watch that shows a progress bar on the terminal, unless `quiet` is set. If
 * pp_interrupt_watch was called before, the watch also stops the simulation at an
 * interrupt. The watch is valid as long as *terminal. */
struct pp_watch pp_watch_of_terminal(struct pp_terminal_watch *terminal, bool quiet);

#endif
