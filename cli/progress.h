/* progress.h - progress bar of a long computation, on a terminal only. */
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

/* Continues from `done`: the time left is estimated from there. */
void pp_progress_resume(struct pp_progress *progress, double done);

/* Draws the line again, at most ten times a second. done: 0 to 1; error: the largest
 * standard error over daylight factor so far, NAN if there is none. */
void pp_progress_show(struct pp_progress *progress, double done, double error);

/* Prints the line "Deep office [======    ]  45 %, error 2.1 %, 12 s left", shorter
 * than `columns` if they are 40 or more: on a narrow terminal bar and label are
 * shortened. left_s: the time left, s; NAN: unknown. */
void pp_progress_print(FILE *out, const char *label, double done, double error,
                       double left_s, int columns);

/* Erases the line. */
void pp_progress_end(struct pp_progress *progress);

#endif
