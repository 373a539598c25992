/* progress.h - progress bar for a long computation, shown on a terminal only. */
#ifndef PP_CLI_PROGRESS_H
#define PP_CLI_PROGRESS_H

#include <stdbool.h>
#include <stdio.h>

struct pp_progress {
    bool shown;        /* true if requested and standard error is a terminal */
    double started_s;  /* by pp_clock_s */
    double last_s;     /* time at which the line was last drawn */
    double before;     /* progress at the start, 0 to 1 */
    const char *label; /* the room's name; not owned */
};

void pp_progress_begin(struct pp_progress *progress, const char *label, bool quiet);

/* States that the computation continues from `done`: the time left is estimated from
 * the progress made since. */
void pp_progress_resume(struct pp_progress *progress, double done);

/* Draws the line again, at most ten times a second. done: 0 to 1; error: the largest
 * ratio of standard error to daylight factor so far; NAN: none. */
void pp_progress_show(struct pp_progress *progress, double done, double error);

/* Prints the line "Deep office [====== ] 45 %, error 2.1 %, 12 s left", with fewer
 * characters than `columns` if that is 40 or more: on a narrow terminal the bar and the
 * label are shortened. left_s: the time left, s; NAN: unknown. */
void pp_progress_print(FILE *out, const char *label, double done, double error,
                       double left_s, int columns);

/* Erases the line. */
void pp_progress_end(struct pp_progress *progress);

#endif
