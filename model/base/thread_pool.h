/* thread_pool.h - runs a function for every index of a range in several threads. The
 * program starts threads only here.
 *
 * Idle workers take the next indices in order, one or several at a time. Each index
 * writes only to its own place, so that results do not depend on the assignment of
 * indices to workers. Sums over indices are formed afterwards, in order.
 *
 * The calling thread is worker 0. The other threads are started with the first work
 * that has more than one index, and sleep between calls. No call waits for a worker
 * that has not woken up; on a busy machine several threads therefore take no longer
 * than one.
 */
#ifndef PP_MODEL_BASE_THREAD_POOL_H
#define PP_MODEL_BASE_THREAD_POOL_H

#include <stdbool.h>

#include "model/base/error.h"

struct pp_thread_pool;

/* Creates a pool of `threads` workers; 0 or less: one per processor that this process
 * may use. If a thread cannot be started, fewer workers share the work. */
enum pp_status pp_thread_pool_create(struct pp_thread_pool **pool, int threads,
                                     struct pp_error *err);
void pp_thread_pool_destroy(struct pp_thread_pool *pool); /* NULL is allowed */

/* Number of workers, 1 or more. */
int pp_thread_pool_size(const struct pp_thread_pool *pool);

/* Work for one index. `worker`, from 0 to the pool's size - 1, differs between
 * simultaneous calls. Returning false stops the work: no further index is started,
 * except those that a worker has already taken. */
typedef bool pp_thread_pool_work(void *data, int worker, int index);

/* Runs the indices [first, end). Returns the index after the last one started, once all
 * before it are done: `end`, unless the work was stopped. Must not be called from
 * several threads at a time, or from within the pool's work. */
int pp_thread_pool_run(struct pp_thread_pool *pool, int first, int end,
                       pp_thread_pool_work *work, void *data);

/* Runs the indices as pp_thread_pool_run does, for work that takes microseconds: if
 * there are many indices a worker takes several at once, which avoids false sharing of
 * the counter and of adjacent results. The last index started depends on the number of
 * indices and on the pool's size. */
int pp_thread_pool_run_small(struct pp_thread_pool *pool, int first, int end,
                             pp_thread_pool_work *work, void *data);

/* Mutual exclusion of workers, for use within the pool's work. */
void pp_thread_pool_lock(struct pp_thread_pool *pool);
void pp_thread_pool_unlock(struct pp_thread_pool *pool);

#endif
