/* work_line.h - the line of tasks that wait for a worker, fair between clients. Inside
 * serve/ only.
 *
 * Start-time fair queueing: a task's turn is one behind the last turn of its client's that
 * waits, or of the line where none does; the lowest turn is next. So a client with many tasks
 * does not delay one with few. A task with more to do goes back to the line after each slice.
 */
#ifndef PP_SERVE_WORK_WORK_LINE_H
#define PP_SERVE_WORK_WORK_LINE_H

#include "serve/work/task.h"

struct pp_work_line;

enum { PP_WORK_LINE_MOST = 512, PP_WORK_LINE_CLIENT_MOST = 256 };

/* Starts the workers; NULL: memory or threads are out. */
struct pp_work_line *pp_work_line_create(int workers);

enum pp_work_line_verdict {
    PP_WORK_LINE_TAKEN,
    PP_WORK_LINE_FULL,
    PP_WORK_LINE_CLIENT_FULL
};

/* Takes the task into the line, which then owns it, too; or leaves it as it is. */
enum pp_work_line_verdict pp_work_line_submit(struct pp_work_line *line,
                                              struct pp_task *task);

/* Number of tasks that wait or are worked on. */
int pp_work_line_count(struct pp_work_line *line);

/* Ends the workers behind their present slice and finishes all tasks; NULL is allowed. False: a
 * slice takes longer than so many whole seconds; the line is then left as it is. */
bool pp_work_line_destroy(struct pp_work_line *line, double seconds);

#endif
