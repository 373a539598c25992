/* progress.h - how far a long computation is, on a terminal only. */
#ifndef PP_CLI_PROGRESS_H
#define PP_CLI_PROGRESS_H

#include <stdbool.h>
#include <stdio.h>

struct pp_progress {
    bool shown;        /* true if requested and standard error is a terminal */
    double started_s;  /* by pp_clock_s */
    double last_s;     /* when the line was last drawn */
    double before;     /* how far it was at the start, 0 to 1 */
    const char *label; /* the room's name; not owned */
};

void pp_progress_begin(struct pp_progress *progress, const char *label, bool quiet);

/* Resumes progress at `done`: the time left is estimated from there. */
void pp_progress_resume(struct pp_progress *progress, double done);

/* Draws the line anew, ten times a second at most. done: 0 to 1; error: the largest
 * standard error over daylight factor so far, NAN where there is none. */
void pp_progress_show(struct pp_progress *progress, double done, double error);

/* The line itself, "Deep office [======    ]  45 %, error 2.1 %, 12 s left", in less
 * than `columns` columns where they are 40 or more: a narrow terminal has a shorter bar
 * or none, and less of the label. left_s: the time left, s; NAN: not known. */
void pp_progress_print(FILE *out, const char *label, double done, double error,
                       double left_s, int columns);

/* Wipes the line. */
void pp_progress_end(struct pp_progress *progress);

#endif
