/* work_queue.h - numbered work for threads and other processes; results, as bytes, are
 * collected in order.
 *
 * The bytes of an index must depend only on the index. Results are then the same for
 * any number of threads and ranks, whichever of them computes an index, and even if an
 * index is computed twice. So no call waits for a silent rank: its indices are assigned
 * again when no others are left.
 *
 * Over ranks (ranks.h), rank 0 assigns chunks, works too, and alone collects results.
 * The other ranks make the same call with the same `work`; for them it returns
 * PP_INTERRUPTED, since only rank 0 continues the program. A process may run only one
 * queue over ranks.
 */
#ifndef PP_MODEL_BASE_WORK_QUEUE_H
#define PP_MODEL_BASE_WORK_QUEUE_H

#include "model/base/ranks.h"

struct pp_work_queue {
    int first, end; /* indices [first, end) */
    int threads;    /* threads of this process, one index each; 0: one per processor,
                     * or one over ranks */

    /* Computes an index: *bytes (malloc) and *length. Called by several threads at a
     * time, each with its own `worker`, from 0. */
    enum pp_status (*work)(void *data, int worker, int index, char **bytes,
                           size_t *length, struct pp_error *err);

    /* Receives the result of an index, in order, from one thread at a time. */
    enum pp_status (*collect)(void *data, int index, const char *bytes, size_t length,
                              struct pp_error *err);

    /* Returns false to stop the queue. `done`: fraction of the indices collected so
     * far. Called between indices, by one thread at a time. NULL: never stops. */
    bool (*goes_on)(void *data, double done);

    void *data;
    const struct pp_ranks *ranks; /* not owned; NULL: only this process */
};

/* Runs the queue. *next: the index after the last one collected, even after a failure
 * or a stop; all before it are collected. If an index fails, the indices before it are
 * still collected; then the error of the first failed index is returned. */
enum pp_status pp_work_queue_run(const struct pp_work_queue *queue, int *next,
                                 struct pp_error *err);

#endif
