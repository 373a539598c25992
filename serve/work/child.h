/* child.h - runs pepperpot as a child process, for functions that pepperpot.h does not
 * have. For use inside serve/ only.
 *
 * The standard input of the child is a given text. Its standard output and standard
 * error are returned. Time, memory and output of the child are limited, its priority is
 * low, and its working directory contains no files of the user. The child is ended when
 * the task is cancelled.
 */
#ifndef PP_SERVE_WORK_CHILD_H
#define PP_SERVE_WORK_CHILD_H

#include "serve/work/task.h"

enum { PP_CHILD_WORDS_MOST = 64, PP_CHILD_SECONDS_MOST = 120 };

enum pp_child_end {
    PP_CHILD_DONE,      /* exited; see `status` */
    PP_CHILD_CANCELLED, /* the task was cancelled */
    PP_CHILD_LIMIT,     /* exceeded the limit of time or output */
    PP_CHILD_FAILED     /* could not be started, or a signal ended it */
};

struct pp_child_result {
    enum pp_child_end end;
    int status;
    char *output, *errors; /* null-terminated, allocated by malloc; NULL: nothing was
                            * read, or out of memory */
    size_t length, error_length;
};

/* Runs the server's program with these arguments (NULL-terminated) and this standard
 * input. The caller frees `output` and `errors` of the result. */
struct pp_child_result pp_child_run(struct pp_task *task, const char *const *words,
                                    const char *input, size_t input_length);

/* Reason for a failure: the first message of the child, or how the child ended.
 * Truncates `errors` after that message. */
const char *pp_child_sentence(struct pp_child_result *result);

#endif
