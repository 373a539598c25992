/* test_work_queue.c - numbered work: results are collected in order and identical,
 * whether threads or ranks do the work. The ranks exchange messages within this
 * process. */
#include "tests/lib/near.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "model/base/thread_pool.h"
#include "model/base/work_queue.h"

enum { FIRST = 3, END = 240, RANKS_MOST = 4, MAIL_MOST = 4 * END };

/* ---- the work ---- */

/* Results of a queue: the bytes collected, in order. */
struct taken {
    char bytes[20 * END];
    size_t length;
    int next;    /* next index to be collected */
    int fails_a; /* indices whose work fails; -1: none */
    int fails_b;
    int refused; /* index whose result is rejected; -1: none */
    int stop;    /* the run is stopped from this index on; -1: never */
    bool slow;   /* takes a millisecond for each index */
};

/* Some arithmetic that takes longer for some indices, so that later ones may finish
 * first. */
static enum pp_status work(void *data, int worker, int index, char **bytes,
                           size_t *length, struct pp_error *err)
{
    const struct taken *taken = data;
    (void)worker;
    if (index == taken->fails_a || index == taken->fails_b)
        return pp_fail(err, PP_BAD_INPUT, "index %d is wrong", index);
    if (taken->slow)
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    unsigned x = (unsigned)index;
    for (int i = 0; i < index % 7 * 3000; i++)
        x = x * 1664525u + 1013904223u;
    *bytes = malloc(20);
    assert_non_null(*bytes);
    *length = (size_t)snprintf(*bytes, 20, "%d %x\n", index, x & 0xffff);
    return PP_OK;
}

static enum pp_status take(void *data, int index, const char *bytes, size_t length,
                           struct pp_error *err)
{
    struct taken *taken = data;
    if (index == taken->refused)
        return pp_fail(err, PP_SYSTEM, "index %d cannot be kept", index);
    assert_int_equal(index, taken->next);
    memcpy(taken->bytes + taken->length, bytes, length);
    taken->length += length;
    taken->next++;
    return PP_OK;
}

static bool look(void *data, double done)
{
    const struct taken *taken = data;
    assert_true(done >= 0.0 && done <= 1.0);
    return taken->stop < 0 || taken->next < taken->stop;
}

static const struct taken nothing = {
    .next = FIRST, .fails_a = -1, .fails_b = -1, .refused = -1, .stop = -1};

static enum pp_status run_queue(struct taken *taken, int threads, struct pp_error *err)
{
    int next;
    const struct pp_work_queue of = {.first = FIRST,
                                     .end = END,
                                     .threads = threads,
                                     .work = work,
                                     .collect = take,
                                     .goes_on = look,
                                     .data = taken};
    enum pp_status status = pp_work_queue_run(&of, &next, err);
    assert_int_equal(next, taken->next);
    return status;
}

/* Asserts that the collected bytes are those expected, in order, up to the last index
 * collected. */
static void assert_prefix(const struct taken *taken)
{
    struct taken plain = nothing;
    for (int i = FIRST; i < taken->next; i++) {
        char *bytes;
        size_t length;
        work(&plain, 0, i, &bytes, &length, NULL);
        take(&plain, i, bytes, length, NULL);
        free(bytes);
    }
    assert_int_equal(taken->length, plain.length);
    assert_memory_equal(taken->bytes, plain.bytes, plain.length);
}

static void assert_all(const struct taken *taken)
{
    assert_int_equal(taken->next, END);
    assert_prefix(taken);
}

/* ---- threads ---- */

static const int sizes[] = {1, 2, 4, 9};

static void threads_give_the_bytes_of_a_plain_loop(void **state)
{
    (void)state;
    for (int s = 0; s < 4; s++) {
        struct taken taken = nothing;
        assert_int_equal(run_queue(&taken, sizes[s], NULL), PP_OK);
        assert_all(&taken);
    }
}

static void the_first_index_that_fails_is_named_after_all_before_it_are_taken(
    void **state)
{
    (void)state;
    for (int s = 0; s < 4; s++) {
        struct pp_error err = {0};
        struct taken taken = nothing;
        taken.fails_a = 97;
        taken.fails_b = 95;
        assert_int_equal(run_queue(&taken, sizes[s], &err), PP_BAD_INPUT);
        assert_string_equal(err.message, "index 95 is wrong");
        assert_int_equal(taken.next, 95);
    }
}

static void a_rejected_result_ends_the_run(void **state)
{
    (void)state;
    for (int s = 0; s < 4; s++) {
        struct pp_error err = {0};
        struct taken taken = nothing;
        taken.refused = 41;
        assert_int_equal(run_queue(&taken, sizes[s], &err), PP_SYSTEM);
        assert_string_equal(err.message, "index 41 cannot be kept");
        assert_int_equal(taken.next, 41);
    }
}

static void a_stop_leaves_collected_results_without_a_gap(void **state)
{
    (void)state;
    for (int s = 0; s < 4; s++) {
        struct taken taken = nothing;
        taken.stop = 50;
        assert_int_equal(run_queue(&taken, sizes[s], NULL), PP_OK);
        assert_true(sizes[s] == 1 ? taken.next == 50 : taken.next >= 50);
        assert_prefix(&taken);
    }
}

static void nothing_to_deal_is_done_at_once(void **state)
{
    (void)state;
    int next = 0;
    const struct pp_work_queue none = {
        .first = 7, .end = 7, .work = work, .collect = take};
    assert_int_equal(pp_work_queue_run(&none, &next, NULL), PP_OK);
    assert_int_equal(next, 7);
}

/* ---- ranks ---- */

struct letter {
    int from, to;
    char *bytes;
    size_t length;
};

struct post {
    pthread_mutex_t mutex;
    struct letter letters[MAIL_MOST];
    int count;
    int dies;       /* a rank that stops sending messages; -1: none */
    int dies_after; /* number of messages it sends before */
    int count_of_ranks;
    int threads; /* threads of each rank */
    struct taken *taken;
    enum pp_status status[RANKS_MOST];
    struct pp_error err;
};

struct address {
    struct post *post;
    int rank;
    int sent;
};

static enum pp_status post_send(void *data, int to, const void *bytes, size_t length,
                                struct pp_error *err)
{
    struct address *address = data;
    struct post *post = address->post;
    if (address->rank == post->dies && address->sent++ >= post->dies_after)
        return pp_fail(err, PP_SYSTEM, "dead");
    pthread_mutex_lock(&post->mutex);
    assert_true(post->count < MAIL_MOST);
    struct letter *letter = &post->letters[post->count++];
    *letter = (struct letter){address->rank, to, malloc(length), length};
    memcpy(letter->bytes, bytes, length);
    pthread_mutex_unlock(&post->mutex);
    return PP_OK;
}

static enum pp_status post_receive(void *data, int *from, char **bytes, size_t *length,
                                   struct pp_error *err)
{
    struct address *address = data;
    struct post *post = address->post;
    (void)err;
    *bytes = NULL;
    pthread_mutex_lock(&post->mutex);
    for (int i = 0; i < post->count && !*bytes; i++) {
        struct letter *letter = &post->letters[i];
        if (letter->to != address->rank || !letter->bytes)
            continue;
        *from = letter->from;
        *bytes = letter->bytes;
        *length = letter->length;
        letter->bytes = NULL;
    }
    pthread_mutex_unlock(&post->mutex);
    return PP_OK;
}

/* Work of the pool: runs one rank. */
static bool live(void *data, int worker, int rank)
{
    struct post *post = data;
    (void)worker;
    int next;
    struct address address = {post, rank, 0};
    const struct pp_ranks ranks = {rank, post->count_of_ranks, post_send, post_receive,
                                   &address};
    const struct pp_work_queue of = {.first = FIRST,
                                     .end = END,
                                     .threads = post->threads,
                                     .work = work,
                                     .collect = take,
                                     .goes_on = look,
                                     .data = post->taken,
                                     .ranks = &ranks};
    post->status[rank] = pp_work_queue_run(&of, &next, rank == 0 ? &post->err : NULL);
    return true;
}

static void deal_over_ranks(struct post *post, struct taken *taken, int ranks,
                            int threads)
{
    struct pp_thread_pool *pool;
    pthread_mutex_init(&post->mutex, NULL);
    post->count_of_ranks = ranks;
    post->threads = threads;
    post->taken = taken;
    assert_int_equal(pp_thread_pool_create(&pool, ranks, NULL), PP_OK);
    pp_thread_pool_run(pool, 0, ranks, live, post);
    pp_thread_pool_destroy(pool);
    pthread_mutex_destroy(&post->mutex);
    for (int i = 0; i < post->count; i++)
        free(post->letters[i].bytes);
}

static void ranks_give_the_bytes_of_a_plain_loop(void **state)
{
    (void)state;
    for (int ranks = 2; ranks <= RANKS_MOST; ranks++)
        for (int threads = 1; threads <= 3; threads++) {
            struct taken taken = nothing;
            struct post post = {.dies = -1};
            deal_over_ranks(&post, &taken, ranks, threads);
            assert_int_equal(post.status[0], PP_OK);
            for (int i = 1; i < ranks; i++)
                assert_int_equal(post.status[i], PP_INTERRUPTED);
            assert_all(&taken);
        }
}

static void a_rank_that_dies_costs_nothing_but_time(void **state)
{
    (void)state;
    struct taken taken = nothing;
    struct post post = {.dies = 2, .dies_after = 3};
    taken.slow = true;
    deal_over_ranks(&post, &taken, 3, 1);
    assert_int_equal(post.status[0], PP_OK);
    assert_all(&taken);
}

static void an_error_on_any_rank_is_rank_0_s(void **state)
{
    (void)state;
    for (int ranks = 2; ranks <= RANKS_MOST; ranks++) {
        struct taken taken = nothing;
        struct post post = {.dies = -1};
        taken.fails_a = 61;
        taken.fails_b = 103;
        deal_over_ranks(&post, &taken, ranks, 1);
        assert_int_equal(post.status[0], PP_BAD_INPUT);
        assert_string_equal(post.err.message, "index 61 is wrong");
        assert_int_equal(taken.next, 61);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_give_the_bytes_of_a_plain_loop),
        cmocka_unit_test(
            the_first_index_that_fails_is_named_after_all_before_it_are_taken),
        cmocka_unit_test(a_rejected_result_ends_the_run),
        cmocka_unit_test(a_stop_leaves_collected_results_without_a_gap),
        cmocka_unit_test(nothing_to_deal_is_done_at_once),
        cmocka_unit_test(ranks_give_the_bytes_of_a_plain_loop),
        cmocka_unit_test(a_rank_that_dies_costs_nothing_but_time),
        cmocka_unit_test(an_error_on_any_rank_is_rank_0_s),
    };
    add_tests(tests, NULL, NULL);
}
