/* thread_pool.c - workers sleep on a condition variable until there is work, and take
 * indices from a common counter. */
#include "model/base/thread_pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

/* run_small: largest number of indices in a batch, and smallest number of batches for
 * each worker, so that all workers stay busy. */
enum { BATCH_MOST = 16, BATCHES_LEAST = 16 };

struct pool_worker {
    struct pp_thread_pool *pool; /* not owned */
    int number;                  /* from 1; 0 is the calling thread */
    pthread_t thread;
};

struct pp_thread_pool {
    int size;
    struct pool_worker *workers; /* without the calling thread */
    int started;                 /* number of workers started */

    pthread_mutex_t mutex; /* protects open, dismissed, number and at_work */
    pthread_cond_t come;   /* signalled for new work, or when the pool is dismissed */
    pthread_cond_t left;   /* signalled when no worker is active */
    bool open;             /* workers may join the work */
    bool dismissed;
    long number; /* number of the task, so that no worker joins it twice */
    int at_work; /* active workers, without the calling thread */

    /* The current work; written only while no worker is active. */
    pp_thread_pool_work *work;
    void *data;
    int end;
    int batch; /* indices that a worker takes at once */
    atomic_int next;
    atomic_bool stopped;

    pthread_mutex_t own; /* for pp_thread_pool_lock */
};

/* Number of processors that this process may use; may be less than the machine has. */
static int processors(void)
{
    cpu_set_t set;
    int count = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
    return count > 1 ? count : 1;
}

enum pp_status pp_thread_pool_create(struct pp_thread_pool **result, int threads,
                                     struct pp_error *err)
{
    *result = NULL;
    struct pp_thread_pool *pool = calloc(1, sizeof *pool);
    if (!pool)
        return pp_fail_memory(err);
    pool->size = threads > 0 ? threads : processors();
    pool->workers = calloc((size_t)pool->size, sizeof *pool->workers);
    if (!pool->workers) {
        free(pool);
        return pp_fail_memory(err);
    }
    pthread_mutex_init(&pool->mutex, NULL);
    pthread_mutex_init(&pool->own, NULL);
    pthread_cond_init(&pool->come, NULL);
    pthread_cond_init(&pool->left, NULL);
    *result = pool;
    return PP_OK;
}

void pp_thread_pool_destroy(struct pp_thread_pool *pool)
{
    if (!pool)
        return;
    pthread_mutex_lock(&pool->mutex);
    pool->dismissed = true;
    pthread_cond_broadcast(&pool->come);
    pthread_mutex_unlock(&pool->mutex);
    for (int i = 0; i < pool->started; i++)
        pthread_join(pool->workers[i].thread, NULL);
    pthread_cond_destroy(&pool->left);
    pthread_cond_destroy(&pool->come);
    pthread_mutex_destroy(&pool->own);
    pthread_mutex_destroy(&pool->mutex);
    free(pool->workers);
    free(pool);
}

int pp_thread_pool_size(const struct pp_thread_pool *pool)
{
    return pool->size;
}

/* Runs indices until none are left. After an index has stopped the work no further
 * batch starts, but batches already started are finished. */
static void run_indices(struct pp_thread_pool *pool, int worker)
{
    while (!atomic_load(&pool->stopped)) {
        int first = atomic_fetch_add(&pool->next, pool->batch);
        if (first >= pool->end)
            break;
        int left = pool->end - first;
        int count = left < pool->batch ? left : pool->batch;
        for (int i = first; i < first + count; i++)
            if (!pool->work(pool->data, worker, i))
                atomic_store(&pool->stopped, true);
    }
}

static void *worker_main(void *data)
{
    const struct pool_worker *worker = data;
    struct pp_thread_pool *pool = worker->pool;
    long seen = 0;
    pthread_mutex_lock(&pool->mutex);
    while (!pool->dismissed) {
        if (!pool->open || pool->number == seen) {
            pthread_cond_wait(&pool->come, &pool->mutex);
            continue;
        }
        seen = pool->number;
        pool->at_work++;
        pthread_mutex_unlock(&pool->mutex);
        run_indices(pool, worker->number);
        pthread_mutex_lock(&pool->mutex);
        if (--pool->at_work == 0)
            pthread_cond_signal(&pool->left);
    }
    pthread_mutex_unlock(&pool->mutex);
    return NULL;
}

/* Starts workers until there are `wanted`. Workers block signals; the main thread
 * handles them. */
static void start_workers(struct pp_thread_pool *pool, int wanted)
{
    sigset_t all, before;
    if (pool->started >= wanted)
        return;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    while (pool->started < wanted) {
        struct pool_worker *worker = &pool->workers[pool->started];
        *worker = (struct pool_worker){.pool = pool, .number = pool->started + 1};
        if (pthread_create(&worker->thread, NULL, worker_main, worker) != 0)
            break;
        pool->started++;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

static void wake_workers(struct pp_thread_pool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    pool->open = true;
    pool->number++;
    pthread_cond_broadcast(&pool->come);
    pthread_mutex_unlock(&pool->mutex);
}

/* Stops workers from joining, and waits for the active ones to finish. */
static void close_and_wait(struct pp_thread_pool *pool)
{
    pthread_mutex_lock(&pool->mutex);
    pool->open = false;
    while (pool->at_work > 0)
        pthread_cond_wait(&pool->left, &pool->mutex);
    pthread_mutex_unlock(&pool->mutex);
}

static int run_range(struct pp_thread_pool *pool, int first, int end, int batch,
                     pp_thread_pool_work *work, void *data)
{
    int count = end - first;
    if (count <= 0)
        return first;
    pool->work = work;
    pool->data = data;
    pool->end = end;
    pool->batch = batch;
    atomic_store(&pool->next, first);
    atomic_store(&pool->stopped, false);
    int others = (count < pool->size ? count : pool->size) - 1;
    if (others > 0) {
        start_workers(pool, others);
        wake_workers(pool);
    }
    run_indices(pool, 0);
    if (others > 0)
        close_and_wait(pool);
    int next = atomic_load(&pool->next);
    return next < end ? next : end;
}

int pp_thread_pool_run(struct pp_thread_pool *pool, int first, int end,
                       pp_thread_pool_work *work, void *data)
{
    return run_range(pool, first, end, 1, work, data);
}

int pp_thread_pool_run_small(struct pp_thread_pool *pool, int first, int end,
                             pp_thread_pool_work *work, void *data)
{
    int fair = (end - first) / (BATCHES_LEAST * pool->size);
    int batch = fair < 1 ? 1 : fair > BATCH_MOST ? BATCH_MOST : fair;
    return run_range(pool, first, end, batch, work, data);
}

void pp_thread_pool_lock(struct pp_thread_pool *pool)
{
    pthread_mutex_lock(&pool->own);
}

void pp_thread_pool_unlock(struct pp_thread_pool *pool)
{
    pthread_mutex_unlock(&pool->own);
}
