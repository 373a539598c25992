/* work_queue.c - runs a queue in the threads of one process. */
#include "model/base/work_queue.h"

#include "model/base/clock.h"
#include "model/base/thread_pool.h"
#include "model/base/work_ranks.h"
#include "model/base/work_results.h"

struct running {
    const struct pp_work_queue *queue;
    struct pp_work_results *results; /* access needs the pool's lock */
    struct pp_thread_pool *pool;
};

/* Work of the pool for one index. Indices after a failed one are not needed. */
static bool do_index(void *data, int worker, int index)
{
    const struct running *running = data;
    struct pp_work_result result;
    pp_work_results_work(running->queue, worker, index, &result);
    pp_thread_pool_lock(running->pool);
    pp_work_results_enter(running->results, index, &result);
    bool more = result.status == PP_OK && !pp_work_results_is_over(running->results);
    pp_thread_pool_unlock(running->pool);
    return more;
}

static enum pp_status run_alone(const struct pp_work_queue *queue, int *next,
                                struct pp_error *err)
{
    struct running running = {.queue = queue};
    enum pp_status status = pp_work_results_create(&running.results, queue, err);
    if (status != PP_OK)
        return status;
    status = pp_thread_pool_create(&running.pool, queue->threads, err);
    if (status == PP_OK) {
        pp_thread_pool_run(running.pool, queue->first, queue->end, do_index, &running);
        status = pp_work_results_end(running.results, next, err);
    }
    pp_thread_pool_destroy(running.pool);
    pp_work_results_destroy(running.results);
    return status;
}

enum pp_status pp_work_queue_run(const struct pp_work_queue *queue, int *next,
                                 struct pp_error *err)
{
    *next = queue->first;
    if (!queue->ranks)
        return run_alone(queue, next, err);
    return queue->ranks->rank == 0 ? pp_work_ranks_lead(queue, next, err)
                                   : pp_work_ranks_follow(queue, err);
}
