/* progress.h - progress bar for a long computation, shown only on a terminal. */
#ifndef PP_CLI_PROGRESS_H
#define PP_CLI_PROGRESS_H

#include <stdbool.h>
#include <stdio.h>

struct pp_progress {
    bool shown;        /* true if requested and standard error is a terminal */
    double started_s;  /* time of the start, by pp_clock_s */
    double last_s;     /* time when the line was last drawn */
    double before;     /* progress at the start or resumption, 0 to 1 */
    const char *label; /* name of the room, or "room"; not owned */
};

/* label: name of the room; NULL: it has none. */
void pp_progress_begin(struct pp_progress *progress, const char *label, bool quiet);

/* Sets the progress at which the computation resumes. The remaining time is estimated
 * from later progress only. */
void pp_progress_resume(struct pp_progress *progress, double done);

/* Draws the line again, at most ten times a second. done: 0 to 1; error: largest ratio
 * of standard error to daylight factor so far; NAN: unknown. */
void pp_progress_show(struct pp_progress *progress, double done, double error);

/* Prints the line "Deep office [====== ] 45 %, error 2.1 %, 12 s left". On a narrow
 * terminal, bar and label are shortened, so that the line has fewer than `columns`
 * characters if `columns` is at least 40. left_s: remaining time, s; NAN: unknown. */
void pp_progress_print(FILE *out, const char *label, double done, double error,
                       double left_s, int columns);

/* Erases the line. */
void pp_progress_end(struct pp_progress *progress);

#endif
