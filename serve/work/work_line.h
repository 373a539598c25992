/* work_line.h - a queue of tasks for worker threads, fair to all clients. For use
 * inside serve/ only.
 *
 * The queue uses start-time fair queueing. A new task gets a number, its turn: 1 more
 * than the highest turn of the same client in the queue, or than the turn of the task
 * that began last. The task with the lowest turn runs next. A client with many tasks
 * therefore does not delay a client with few tasks. An unfinished task returns to the
 * queue after each slice.
 */
#ifndef PP_SERVE_WORK_WORK_LINE_H
#define PP_SERVE_WORK_WORK_LINE_H

#include "serve/work/task.h"

struct pp_work_line;

enum { PP_WORK_LINE_MOST = 512, PP_WORK_LINE_CLIENT_MOST = 256 };

/* Starts the workers. NULL if memory is exhausted or no thread can be started. */
struct pp_work_line *pp_work_line_create(int workers);

enum pp_work_line_verdict {
    PP_WORK_LINE_TAKEN,
    PP_WORK_LINE_FULL,
    PP_WORK_LINE_CLIENT_FULL
};

/* Adds the task to the queue, which becomes one of its owners, or rejects the task and
 * leaves it unchanged. */
enum pp_work_line_verdict pp_work_line_submit(struct pp_work_line *line,
                                              struct pp_task *task);

/* Number of tasks in the queue or running. */
int pp_work_line_count(struct pp_work_line *line);

/* Waits until the queue is empty, and ends the workers. A cancelled task gets no
 * further slice. line NULL: does nothing. Returns false if this takes longer than
 * `seconds`; the queue is then not freed. */
bool pp_work_line_destroy(struct pp_work_line *line, double seconds);

#endif
