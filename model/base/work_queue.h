/* work_queue.h - numbered work for threads and other processes; the results, as bytes,
 * are collected in order.
 *
 * The bytes of an index depend on the index alone, so that results are the same for any
 * number of threads and ranks, whichever of them works an index out, and how often.
 * Hence no call waits for a silent rank: its indices are assigned again when no others
 * are left.
 *
 * Over ranks (ranks.h) rank 0 assigns chunks, works too, and alone collects results.
 * The others make the same call with the same `work`, which ends for them as
 * interrupted: the rest of the program is rank 0's. A process may run one queue over
 * ranks.
 */
#ifndef PP_MODEL_BASE_WORK_QUEUE_H
#define PP_MODEL_BASE_WORK_QUEUE_H

#include "model/base/ranks.h"

struct pp_work_queue {
    int first, end; /* indices [first, end) */
    int threads;    /* of this process, at one index each; 0: one for each processor;
                     * over ranks: one */

    /* Works out an index: *bytes, from malloc, and their number. Called by several
     * threads at a time, each with a `worker` of its own, from 0. */
    enum pp_status (*work)(void *data, int worker, int index, char **bytes,
                           size_t *length, struct pp_error *err);

    /* Receives the result of an index, in the order of indices, from one thread at a time. */
    enum pp_status (*collect)(void *data, int index, const char *bytes, size_t length,
                              struct pp_error *err);

    /* Returns false to stop the queue. `done`: share of the indices collected. Called between
     * two indices, by one thread at a time; NULL: never stops. */
    bool (*goes_on)(void *data, double done);

    void *data;
    const struct pp_ranks *ranks; /* not owned; NULL: this process alone */
};

/* Runs the queue. *next is the index after the last that was collected, also after a failure
 * or a stop: all before it have been collected. A failed index ends the queue once all
 * before it are collected; if several fail the error of the first is returned. */
enum pp_status pp_work_queue_run(const struct pp_work_queue *queue, int *next,
                                 struct pp_error *err);

#endif
