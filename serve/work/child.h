/* child.h - the program run as a child process, for what pepperpot.h lacks. Inside serve/
 * only.
 *
 * It reads a text, and its standard output and error are kept. It has limits of time,
 * memory and output, a lower priority, an empty folder to work in, and ends when the task is
 * cancelled.
 */
#ifndef PP_SERVE_WORK_CHILD_H
#define PP_SERVE_WORK_CHILD_H

#include "serve/work/task.h"

enum { PP_CHILD_WORDS_MOST = 64, PP_CHILD_SECONDS_MOST = 120 };

enum pp_child_end {
    PP_CHILD_DONE,      /* it has ended by itself, with `status` */
    PP_CHILD_CANCELLED, /* the client no longer waits for it */
    PP_CHILD_LIMIT,     /* it took too long, or wrote too much */
    PP_CHILD_FAILED     /* it could not be started, or died */
};

struct pp_child_result {
    enum pp_child_end end;
    int status;
    char *output, *errors; /* malloc, with a 0 behind; NULL: memory is out */
    size_t length, error_length;
};

/* Runs the server's program with these words, NULL behind the last; input is written to
 * it. The caller frees output and errors. */
struct pp_child_result pp_child_run(struct pp_task *task, const char *const *words,
                                    const char *input, size_t input_length);

/* The fault, by the child's own first message or by how it ended; it cuts the errors off
 * there. */
const char *pp_child_sentence(struct pp_child_result *result);

#endif
