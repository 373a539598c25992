/* test_work_line.c - clients take turns, however many tasks each has in the queue. */
#include "tests/lib/near.h"

#include <time.h>

#include "serve/work/work_line.h"

enum { TASKS_MOST = 32 };

/* Clients in the order in which their tasks started. */
static struct {
    pthread_mutex_t lock;
    uint64_t clients[TASKS_MOST];
    int count;
    bool is_held; /* the worker is waiting */
    bool is_open;
} seen = {.lock = PTHREAD_MUTEX_INITIALIZER};

static void nap(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
}

static bool note_client(struct pp_task *task)
{
    pthread_mutex_lock(&seen.lock);
    seen.clients[seen.count++] = task->client;
    pthread_mutex_unlock(&seen.lock);
    return true;
}

/* Keeps the only worker busy until all tasks are in the queue. */
static bool hold(struct pp_task *task)
{
    (void)task;
    pthread_mutex_lock(&seen.lock);
    seen.is_held = true;
    bool done = seen.is_open;
    pthread_mutex_unlock(&seen.lock);
    while (!done) {
        nap();
        pthread_mutex_lock(&seen.lock);
        done = seen.is_open;
        pthread_mutex_unlock(&seen.lock);
    }
    return true;
}

static void join(struct pp_server *server, struct pp_work_line *line, pp_task_run *run,
                 uint64_t client)
{
    struct pp_task *task =
        pp_task_create(server, run, "test", json_object_new_object());
    assert_non_null(task);
    task->client = client;
    assert_int_equal(pp_work_line_submit(line, task), PP_WORK_LINE_TAKEN);
    pp_task_release(task);
}

/* Gives the worker a task that keeps it busy, and returns when the task has started. */
static void hold_worker(struct pp_server *server, struct pp_work_line *line)
{
    bool is_held = false;
    seen.count = 0;
    seen.is_held = seen.is_open = false;
    join(server, line, hold, 9);
    while (!is_held) {
        nap();
        pthread_mutex_lock(&seen.lock);
        is_held = seen.is_held;
        pthread_mutex_unlock(&seen.lock);
    }
}

static void a_client_with_one_task_does_not_wait_for_ten_of_another(void **state)
{
    (void)state;
    struct pp_server server = {0};
    struct pp_work_line *line = pp_work_line_create(1);
    hold_worker(&server, line);
    for (int i = 0; i < 10; i++)
        join(&server, line, note_client, 1);
    join(&server, line, note_client, 2);
    join(&server, line, note_client, 3);
    pthread_mutex_lock(&seen.lock);
    seen.is_open = true;
    pthread_mutex_unlock(&seen.lock);
    while (pp_work_line_count(line) > 0)
        nap();
    assert_true(pp_work_line_destroy(line, 5.0));
    assert_int_equal(seen.count, 12);
    assert_int_equal(seen.clients[0], 1);
    assert_int_equal(seen.clients[1], 2);
    assert_int_equal(seen.clients[2], 3);
}

static void a_line_that_is_full_refuses(void **state)
{
    (void)state;
    struct pp_server server = {0};
    struct pp_work_line *line = pp_work_line_create(1);
    hold_worker(&server, line);
    for (int i = 0; i < PP_WORK_LINE_CLIENT_MOST; i++)
        join(&server, line, hold, 1);
    struct pp_task *task =
        pp_task_create(&server, hold, "test", json_object_new_object());
    task->client = 1;
    assert_int_equal(pp_work_line_submit(line, task), PP_WORK_LINE_CLIENT_FULL);
    task->client = 2;
    assert_int_equal(pp_work_line_submit(line, task), PP_WORK_LINE_TAKEN);
    pp_task_release(task);
    pthread_mutex_lock(&seen.lock);
    seen.is_open = true;
    pthread_mutex_unlock(&seen.lock);
    assert_true(pp_work_line_destroy(line, 5.0));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_client_with_one_task_does_not_wait_for_ten_of_another),
        cmocka_unit_test(a_line_that_is_full_refuses),
    };
    add_tests(tests, NULL, NULL);
}
