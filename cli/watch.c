/* watch.c - connects the progress bar and the interrupt flag to the watch of a
 * study. */
#include "cli/watch.h"

#include "cli/interrupt.h"

static bool begin_watch(void *data, const char *name)
{
    struct pp_terminal_watch *terminal = data;
    pp_progress_begin(&terminal->progress, name, terminal->quiet);
    return terminal->progress.shown;
}

static bool watch_goes_on(void *data, double done, double error)
{
    struct pp_terminal_watch *terminal = data;
    if (pp_interrupt_came())
        return false;
    if (done > 0.0)
        pp_progress_show(&terminal->progress, done, error);
    return true;
}

static void end(void *data)
{
    struct pp_terminal_watch *terminal = data;
    pp_progress_end(&terminal->progress);
}

struct pp_watch pp_watch_of_terminal(struct pp_terminal_watch *terminal, bool quiet)
{
    *terminal = (struct pp_terminal_watch){.quiet = quiet};
    return (struct pp_watch){begin_watch, watch_goes_on, end, terminal};
}
