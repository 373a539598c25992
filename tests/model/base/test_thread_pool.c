/* test_thread_pool.c - a thread pool processes each index once. */
#include "tests/lib/near.h"

#include <stdatomic.h>
#include <string.h>

#include "model/base/clock.h"
#include "model/base/thread_pool.h"

enum { MOST = 10007, MEMBERS_MOST = 9 };

/* Work done, for each index and each worker. */
struct done {
    atomic_int times[MOST];
    atomic_bool busy[MEMBERS_MOST];
    atomic_int
        clashes; /* a worker that runs twice at the same time, or has an invalid number */
    int size;    /* number of workers in the pool */
    int stop_at; /* index at which the work stops; -1: none */
};

static bool note(void *data, int worker, int index)
{
    struct done *done = data;
    if (worker < 0 || worker >= done->size
        || atomic_exchange(&done->busy[worker], true)) {
        atomic_fetch_add(&done->clashes, 1);
        return false;
    }
    atomic_fetch_add(&done->times[index], 1);
    atomic_store(&done->busy[worker], false);
    return index != done->stop_at;
}

/* Processes indices one at a time, or several at a time. */
typedef int runner(struct pp_thread_pool *pool, int first, int end,
                   pp_thread_pool_work *work, void *data);
static runner *const runners[] = {pp_thread_pool_run, pp_thread_pool_run_small};

/* Runs the pool once; returns the index where it ended. */
static int run(struct done *done, runner *run_indices, int size, int first, int end,
               int stop_at)
{
    struct pp_thread_pool *pool;
    memset(done, 0, sizeof *done);
    assert_int_equal(pp_thread_pool_create(&pool, size, NULL), PP_OK);
    assert_int_equal(pp_thread_pool_size(pool), size);
    done->size = size;
    done->stop_at = stop_at;
    int next = run_indices(pool, first, end, note, done);
    pp_thread_pool_destroy(pool);
    assert_int_equal(done->clashes, 0);
    return next;
}

static const int sizes[] = {1, 2, 3, MEMBERS_MOST};

static void every_index_is_done_once(void **state)
{
    (void)state;
    static struct done done;
    static const int ranges[][2] = {{0, MOST}, {17, 18}, {5, 8}, {4000, 4077}};
    for (int s = 0; s < 8; s++)
        for (int r = 0; r < 4; r++) {
            int first = ranges[r][0], end = ranges[r][1];
            assert_int_equal(run(&done, runners[s / 4], sizes[s % 4], first, end, -1),
                             end);
            for (int i = 0; i < MOST; i++)
                assert_int_equal(done.times[i], i >= first && i < end);
        }
}

static void an_empty_range_of_indices_is_no_work(void **state)
{
    (void)state;
    static struct done done;
    for (int s = 0; s < 8; s++) {
        assert_int_equal(run(&done, runners[s / 4], sizes[s % 4], 0, 0, -1), 0);
        assert_int_equal(run(&done, runners[s / 4], sizes[s % 4], 7, 7, -1), 7);
        assert_int_equal(run(&done, runners[s / 4], sizes[s % 4], 7, 3, -1), 7);
        for (int i = 0; i < MOST; i++)
            assert_int_equal(done.times[i], 0);
    }
}

/* Indices that were started are completed, so there are no gaps. */
static void work_that_stops_leaves_no_gap(void **state)
{
    (void)state;
    static struct done done;
    for (int s = 0; s < 8; s++)
        for (int stop_at = 0; stop_at < 400; stop_at += 37) {
            int next = run(&done, runners[s / 4], sizes[s % 4], 0, MOST, stop_at);
            assert_true(next > stop_at);
            if (s == 0) /* one worker, one index at a time */
                assert_int_equal(next, stop_at + 1);
            if (s == 4)
                assert_true(next <= stop_at + 16);
            for (int i = 0; i < MOST; i++)
                assert_int_equal(done.times[i], i < next);
        }
    assert_int_equal(run(&done, pp_thread_pool_run, 3, 0, MOST, MOST - 1), MOST);
}

/* Two indices, each of which waits until the other has started. */
struct meeting {
    atomic_int begun;
    atomic_int met;
};

static bool meet(void *data, int worker, int index)
{
    (void)worker, (void)index;
    struct meeting *meeting = data;
    double patience_s = pp_clock_s() + 20.0;
    atomic_fetch_add(&meeting->begun, 1);
    while (atomic_load(&meeting->begun) < 2 && pp_clock_s() < patience_s)
        ;
    atomic_fetch_add(&meeting->met, atomic_load(&meeting->begun) == 2);
    return true;
}

static void two_members_work_at_the_same_time(void **state)
{
    (void)state;
    struct pp_thread_pool *pool;
    struct meeting meeting = {0};
    assert_int_equal(pp_thread_pool_create(&pool, 2, NULL), PP_OK);
    assert_int_equal(pp_thread_pool_run(pool, 0, 2, meet, &meeting), 2);
    assert_int_equal(meeting.met, 2);
    pp_thread_pool_destroy(pool);
}

/* A sum to which all workers add. */
struct shared_sum {
    struct pp_thread_pool *pool;
    long sum;
};

static bool add(void *data, int worker, int index)
{
    (void)worker;
    struct shared_sum *shared = data;
    pp_thread_pool_lock(shared->pool);
    shared->sum += index;
    pp_thread_pool_unlock(shared->pool);
    return true;
}

/* Many short runs: a worker may wake up late, during a later run than the one it was
 * started for. */
static void a_thread_pool_runs_many_times(void **state)
{
    (void)state;
    struct shared_sum shared = {0};
    long expected = 0;
    assert_int_equal(pp_thread_pool_create(&shared.pool, 4, NULL), PP_OK);
    for (int k = 0; k < 3000; k++) {
        int count = k % 11;
        assert_int_equal(pp_thread_pool_run(shared.pool, 0, count, add, &shared),
                         count);
        expected += (long)count * (count - 1) / 2;
        assert_int_equal(shared.sum, expected);
    }
    pp_thread_pool_destroy(shared.pool);
}

static void without_a_number_it_has_the_processors(void **state)
{
    (void)state;
    struct pp_thread_pool *pool;
    assert_int_equal(pp_thread_pool_create(&pool, 0, NULL), PP_OK);
    assert_true(pp_thread_pool_size(pool) >= 1);
    pp_thread_pool_destroy(pool);
    pp_thread_pool_destroy(NULL);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_index_is_done_once),
        cmocka_unit_test(an_empty_range_of_indices_is_no_work),
        cmocka_unit_test(work_that_stops_leaves_no_gap),
        cmocka_unit_test(two_members_work_at_the_same_time),
        cmocka_unit_test(a_thread_pool_runs_many_times),
        cmocka_unit_test(without_a_number_it_has_the_processors),
    };
    add_tests(tests, NULL, NULL);
}
