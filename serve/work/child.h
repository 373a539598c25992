/* child.h - runs pepperpot as a child process, for functions that pepperpot.h lacks.
 * Inside serve/ only.
 *
 * The child's standard input is a given text; its output and error output are returned.
 * Its time, memory and output are limited, its priority is low, and its working
 * directory is empty. It is ended when the task is cancelled.
 */
#ifndef PP_SERVE_WORK_CHILD_H
#define PP_SERVE_WORK_CHILD_H

#include "serve/work/task.h"

enum { PP_CHILD_WORDS_MOST = 64, PP_CHILD_SECONDS_MOST = 120 };

enum pp_child_end {
    PP_CHILD_DONE,      /* exited; see `status` */
    PP_CHILD_CANCELLED, /* the client is no longer connected */
    PP_CHILD_LIMIT,     /* exceeded the limit on time or output */
    PP_CHILD_FAILED     /* could not be started, or was ended by a signal */
};

struct pp_child_result {
    enum pp_child_end end;
    int status;
    char *output, *errors; /* malloc, NUL-terminated; NULL: out of memory */
    size_t length, error_length;
};

/* Runs the server's program with these arguments (NULL-terminated) and this standard
 * input. The caller frees output and errors. */
struct pp_child_result pp_child_run(struct pp_task *task, const char *const *words,
                                    const char *input, size_t input_length);

/* Reason of a failure: the child's first message, or how it ended. Cuts `errors` off
 * after that message. */
const char *pp_child_sentence(struct pp_child_result *result);

#endif
