/* thread_pool.h - one function for every index of a range, by several threads. The one
 * place where the program starts threads.
 *
 * Workers without work take the next indices in their order, one or several at a time.
 * Each index writes only to its own place, so that results do not depend on which worker
 * did what; sums over indices are formed afterwards, in their order.
 *
 * The calling thread is worker 0. The other threads are started with the first work that
 * has more than one index and sleep in between. No call waits for a worker that has not
 * woken up yet: on a busy machine several threads do not take longer than one.
 */
#ifndef PP_MODEL_BASE_THREAD_POOL_H
#define PP_MODEL_BASE_THREAD_POOL_H

#include <stdbool.h>

#include "model/base/error.h"

struct pp_thread_pool;

/* A pool of `threads` workers; 0 or less: one for each processor that this process may
 * use. If a thread cannot be started the pool is smaller. */
enum pp_status pp_thread_pool_create(struct pp_thread_pool **pool, int threads,
                                     struct pp_error *err);
void pp_thread_pool_destroy(struct pp_thread_pool *pool); /* NULL is allowed */

/* Number of workers, 1 or more. */
int pp_thread_pool_size(const struct pp_thread_pool *pool);

/* The work of one index. `worker`, from 0 to the pool's size - 1, differs between two
 * calls at the same time. False: no further index is started. */
typedef bool pp_thread_pool_work(void *data, int worker, int index);

/* Does the indices [first, end). Returns the index after the last that was started, once
 * all before it are done: `end`, unless the work has stopped it. Call it from one thread at
 * a time, and not from within the pool's work. */
int pp_thread_pool_run(struct pp_thread_pool *pool, int first, int end,
                       pp_thread_pool_work *work, void *data);

/* The same for work of microseconds: of many indices a worker takes several at once, which
 * avoids false sharing of the counter and of adjacent results. The last index started
 * depends on the number of indices and on the pool's size. */
int pp_thread_pool_run_small(struct pp_thread_pool *pool, int first, int end,
                             pp_thread_pool_work *work, void *data);

/* Mutual exclusion of workers, for use within the pool's work. */
void pp_thread_pool_lock(struct pp_thread_pool *pool);
void pp_thread_pool_unlock(struct pp_thread_pool *pool);

#endif
