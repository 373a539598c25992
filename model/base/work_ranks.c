/* work_ranks.c - the messages between rank 0 and the other ranks.
 *
 *     rank n    ASK     requests work; number of threads
 *     rank 0    GIVE    assigns indices: the first, and their number
 *               WAIT    everything is assigned, but not done: ask again later
 *               OVER    nothing more will be assigned
 *     rank n    DONE    an index with its result, or its error
 *
 * On rank 0 one thread sends and receives messages and assigns work to the other ranks;
 * the other threads take indices and compute.
 */
#include "model/base/work_ranks.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "model/base/clock.h"
#include "model/base/thread_pool.h"
#include "model/base/work_results.h"

/* Seconds between checks for a message, and between requests after the answer WAIT. */
static const double look_s = 0.0005, ask_again_s = 0.1;

/* Time without an answer after which a rank assumes that rank 0 is dead. */
static const double given_up_s = 60.0;

/* Number of chunks per thread of all ranks, and largest chunk per thread. */
enum { CHUNKS = 8, CHUNK_MOST = 16 };

enum kind { ASK, GIVE, WAIT, OVER, DONE };

/* Head of all messages; the bytes of an index, or an error message, follow. */
struct head {
    int kind;
    int index;  /* GIVE, DONE */
    int count;  /* ASK: threads; GIVE: indices */
    int status; /* DONE: enum pp_status */
};

static void wait_s(double seconds)
{
    const struct timespec time = {(time_t)seconds,
                                  (long)(1e9 * (seconds - (double)(time_t)seconds))};
    nanosleep(&time, NULL);
}

static enum pp_status send_to(const struct pp_ranks *ranks, int to,
                              const struct head *head, const void *bytes, size_t length,
                              struct pp_error *err)
{
    char *message = malloc(sizeof *head + length);
    if (!message)
        return pp_fail_memory(err);
    memcpy(message, head, sizeof *head);
    if (length > 0)
        memcpy(message + sizeof *head, bytes, length);
    enum pp_status status =
        ranks->send(ranks->data, to, message, sizeof *head + length, err);
    free(message);
    return status;
}

/* ---- rank 0 ---- */

struct leading {
    const struct pp_work_queue *queue;
    struct pp_work_results *results; /* access needs the pool's lock */
    struct pp_thread_pool *pool;
    int threads;           /* of all ranks, if each has as many as rank 0 */
    enum pp_status status; /* status of messages */
    struct pp_error err;
};

static int chunk(const struct leading *leading, int threads)
{
    int size =
        pp_work_results_unassigned(leading->results) / (CHUNKS * leading->threads);
    size = size < CHUNK_MOST ? size : CHUNK_MOST;
    return size > 1 ? size * threads : threads;
}

/* Answers a rank that requests work. */
static enum pp_status answer(struct leading *leading, int rank, int threads,
                             struct pp_error *err)
{
    struct head head = {.kind = OVER};
    const double now_s = pp_clock_s();
    if (threads < 1)
        threads = 1;
    if (!pp_work_results_is_over(leading->results)) {
        head.kind = GIVE;
        head.count = pp_work_results_assign(
            leading->results, rank, chunk(leading, threads), now_s, &head.index);
        if (head.count == 0)
            head.count =
                pp_work_results_reassign(leading->results, rank, now_s, &head.index);
        if (head.count == 0)
            head.kind = WAIT;
    }
    return send_to(leading->queue->ranks, rank, &head, NULL, 0, err);
}

/* Stores the result of an index from a rank; `bytes` follow the head. */
static enum pp_status enter(struct leading *leading, const struct head *head,
                            const char *bytes, size_t length, struct pp_error *err)
{
    struct pp_work_result result = {.length = length,
                                    .status = (enum pp_status)head->status};
    if (result.status != PP_OK) {
        result.length = 0;
        pp_fail(&result.err, result.status, "%.*s", (int)length, bytes);
    } else {
        result.bytes = malloc(length + 1);
        if (!result.bytes)
            return pp_fail_memory(err);
        memcpy(result.bytes, bytes, length);
    }
    pp_work_results_enter(leading->results, head->index, &result);
    return PP_OK;
}

static enum pp_status hear(struct leading *leading, int from, const char *message,
                           size_t length, struct pp_error *err)
{
    const struct pp_work_queue *queue = leading->queue;
    struct head head;
    if (length < sizeof head || from < 1 || from >= queue->ranks->count)
        return PP_OK;
    memcpy(&head, message, sizeof head);
    pp_work_results_heard_from(leading->results, from, pp_clock_s());
    if (head.kind == ASK)
        return answer(leading, from, head.count, err);
    if (head.kind == DONE && head.index >= queue->first && head.index < queue->end)
        return enter(leading, &head, message + sizeof head, length - sizeof head, err);
    return PP_OK;
}

/* Loop of rank 0: assigns work until all is done or messages fail. */
static void lead(struct leading *leading)
{
    const struct pp_ranks *ranks = leading->queue->ranks;
    bool over = false;
    while (!over) {
        char *message;
        size_t length;
        int from;
        enum pp_status status =
            ranks->receive(ranks->data, &from, &message, &length, &leading->err);
        pp_thread_pool_lock(leading->pool);
        if (status == PP_OK && message)
            status = hear(leading, from, message, length, &leading->err);
        leading->status = status;
        over = status != PP_OK || pp_work_results_is_over(leading->results);
        pp_thread_pool_unlock(leading->pool);
        if (!message && !over)
            wait_s(look_s);
        free(message);
    }
}

/* Loop of a thread of rank 0: computes the next unassigned index until the queue is
 * over. */
static void work_for_rank_0(struct leading *leading, int worker)
{
    const struct pp_work_queue *queue = leading->queue;
    for (;;) {
        int index;
        const double now_s = pp_clock_s();
        pp_thread_pool_lock(leading->pool);
        bool over =
            leading->status != PP_OK || pp_work_results_is_over(leading->results);
        bool given =
            !over
            && (pp_work_results_assign(leading->results, 0, 1, now_s, &index) == 1
                || pp_work_results_reassign(leading->results, 0, now_s, &index));
        pp_thread_pool_unlock(leading->pool);
        if (over)
            return;
        if (!given) {
            wait_s(look_s);
            continue;
        }
        struct pp_work_result result;
        pp_work_results_work(queue, worker - 1, index, &result);
        pp_thread_pool_lock(leading->pool);
        pp_work_results_heard_from(leading->results, 0, pp_clock_s());
        pp_work_results_enter(leading->results, index, &result);
        pp_thread_pool_unlock(leading->pool);
    }
}

/* Task of the pool: the calling thread assigns indices to other ranks, the others
 * compute, until all are done. */
static bool lead_or_work(void *data, int worker, int index)
{
    struct leading *leading = data;
    (void)index;
    if (worker == 0)
        lead(leading);
    else
        work_for_rank_0(leading, worker);
    return true;
}

/* Sends OVER to all ranks; busy ranks read it when they have finished. */
void pp_work_ranks_dismiss(const struct pp_ranks *ranks)
{
    const struct head over = {.kind = OVER};
    for (int rank = 1; rank < ranks->count; rank++)
        send_to(ranks, rank, &over, NULL, 0, NULL);
}

enum pp_status pp_work_ranks_lead(const struct pp_work_queue *queue, int *next,
                                  struct pp_error *err)
{
    const int own = queue->threads > 0 ? queue->threads : 1;
    struct leading leading = {.queue = queue, .threads = own * queue->ranks->count};
    enum pp_status status = pp_work_results_create(&leading.results, queue, err);
    if (status == PP_OK)
        status = pp_thread_pool_create(&leading.pool, own + 1, err);
    if (status == PP_OK) {
        pp_thread_pool_run(leading.pool, 0, own + 1, lead_or_work, &leading);
        status = pp_work_results_end(leading.results, next, err);
        if (status == PP_OK && leading.status != PP_OK) {
            status = leading.status;
            if (err)
                *err = leading.err;
        }
    }
    pp_work_ranks_dismiss(queue->ranks);
    pp_thread_pool_destroy(leading.pool);
    pp_work_results_destroy(leading.results);
    return status;
}

/* ---- the other ranks ---- */

struct following {
    const struct pp_work_queue *queue;
    struct pp_work_result *results; /* results from index `first` on */
    int first;
};

/* Work of the pool: computes one index. */
static bool do_index(void *data, int worker, int index)
{
    const struct following *following = data;
    pp_work_results_work(following->queue, worker, index,
                         &following->results[index - following->first]);
    return true;
}

/* Sends the result of an index to rank 0, and frees it. */
static enum pp_status tell(const struct pp_ranks *ranks, int index,
                           struct pp_work_result *result, struct pp_error *err)
{
    const struct head done = {.kind = DONE, .index = index, .status = result->status};
    bool good = result->status == PP_OK;
    enum pp_status status =
        send_to(ranks, 0, &done, good ? result->bytes : result->err.message,
                good ? result->length : strlen(result->err.message), err);
    free(result->bytes);
    return status;
}

/* Computes a chunk, as many indices at a time as there are threads, and sends the
 * results. */
static enum pp_status do_chunk(struct following *following, struct pp_thread_pool *pool,
                               int first, int count, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    const int size = pp_thread_pool_size(pool), end = first + count;
    for (int from = first; from < end && status == PP_OK; from += size) {
        int to = end - from < size ? end : from + size;
        following->first = from;
        pp_thread_pool_run(pool, from, to, do_index, following);
        for (int i = from; i < to; i++) {
            enum pp_status told =
                tell(following->queue->ranks, i, &following->results[i - from], err);
            status = status == PP_OK ? told : status;
        }
    }
    return status;
}

/* Requests work from rank 0 and waits for the answer; *said is OVER if there is none
 * for given_up_s. */
static enum pp_status ask(const struct pp_ranks *ranks, int threads, struct head *said,
                          struct pp_error *err)
{
    const struct head question = {.kind = ASK, .count = threads};
    const double asked_s = pp_clock_s();
    *said = (struct head){.kind = OVER};
    enum pp_status status = send_to(ranks, 0, &question, NULL, 0, err);
    while (status == PP_OK && pp_clock_s() - asked_s < given_up_s) {
        char *message;
        size_t length;
        int from;
        status = ranks->receive(ranks->data, &from, &message, &length, err);
        bool heard = status == PP_OK && message && length >= sizeof *said;
        if (heard)
            memcpy(said, message, sizeof *said);
        free(message);
        if (heard)
            break;
        wait_s(look_s);
    }
    return status;
}

enum pp_status pp_work_ranks_follow(const struct pp_work_queue *queue,
                                    struct pp_error *err)
{
    struct following following = {.queue = queue};
    struct pp_thread_pool *pool;
    struct head said = {.kind = WAIT};
    enum pp_status status =
        pp_thread_pool_create(&pool, queue->threads > 0 ? queue->threads : 1, err);
    if (status != PP_OK)
        return status;
    following.results =
        calloc((size_t)pp_thread_pool_size(pool), sizeof *following.results);
    if (!following.results)
        status = pp_fail_memory(err);
    while (status == PP_OK && said.kind != OVER) {
        status = ask(queue->ranks, pp_thread_pool_size(pool), &said, err);
        if (status == PP_OK && said.kind == GIVE)
            status = do_chunk(&following, pool, said.index, said.count, err);
        if (status == PP_OK && said.kind == WAIT)
            wait_s(ask_again_s);
    }
    free(following.results);
    pp_thread_pool_destroy(pool);
    return status == PP_OK ? pp_fail(err, PP_INTERRUPTED, "rank 0 has no more work")
                           : status;
}
