/* work_line.c - see work_line.h. */
#include "serve/work/work_line.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

struct pp_work_line {
    pthread_mutex_t lock;
    pthread_cond_t wake;
    struct pp_task *waiting; /* list in order of arrival */
    int waiting_count, working;
    uint64_t turn; /* turn of the task that began last */
    bool ending;
    pthread_t *workers;
    int worker_count;
};

/* Appends a task to the queue and sets its turn. The caller must hold the lock. */
static void join_line(struct pp_work_line *line, struct pp_task *task)
{
    uint64_t turn = line->turn;
    struct pp_task **end = &line->waiting;
    for (; *end; end = &(*end)->next)
        if ((*end)->client == task->client && (*end)->turn > turn)
            turn = (*end)->turn;
    task->turn = turn + 1;
    task->next = NULL;
    *end = task;
    line->waiting_count++;
}

/* Removes and returns the task with the lowest turn. If there are several, the one that
 * was added first. The caller must hold the lock. */
static struct pp_task *leave_line(struct pp_work_line *line)
{
    struct pp_task **best = &line->waiting;
    for (struct pp_task **at = &line->waiting; *at; at = &(*at)->next)
        if ((*at)->turn < (*best)->turn)
            best = at;
    struct pp_task *task = *best;
    *best = task->next;
    line->waiting_count--;
    line->turn = task->turn;
    return task;
}

static void *work_on_line(void *data)
{
    struct pp_work_line *line = data;
    pthread_mutex_lock(&line->lock);
    for (;;) {
        while (!line->waiting && !line->ending)
            pthread_cond_wait(&line->wake, &line->lock);
        if (!line->waiting)
            break;
        struct pp_task *task = leave_line(line);
        line->working++;
        pthread_mutex_unlock(&line->lock);
        bool done = pp_task_is_cancelled(task) || task->run(task);
        if (done) {
            pp_task_finish(task);
            pp_task_release(task);
        }
        pthread_mutex_lock(&line->lock);
        line->working--;
        if (!done)
            join_line(line, task);
    }
    pthread_mutex_unlock(&line->lock);
    return NULL;
}

struct pp_work_line *pp_work_line_create(int workers)
{
    struct pp_work_line *line = calloc(1, sizeof *line);
    if (!line)
        return NULL;
    pthread_mutex_init(&line->lock, NULL);
    pthread_cond_init(&line->wake, NULL);
    line->workers = calloc((size_t)workers, sizeof *line->workers);
    while (
        line->workers && line->worker_count < workers
        && pthread_create(&line->workers[line->worker_count], NULL, work_on_line, line)
               == 0)
        line->worker_count++;
    if (line->worker_count > 0)
        return line;
    pp_work_line_destroy(line, 1.0);
    return NULL;
}

enum pp_work_line_verdict pp_work_line_submit(struct pp_work_line *line,
                                              struct pp_task *task)
{
    enum pp_work_line_verdict verdict = PP_WORK_LINE_TAKEN;
    int own = 0;
    pthread_mutex_lock(&line->lock);
    for (const struct pp_task *at = line->waiting; at; at = at->next)
        own += at->client == task->client;
    if (line->waiting_count >= PP_WORK_LINE_MOST || line->ending)
        verdict = PP_WORK_LINE_FULL;
    else if (own >= PP_WORK_LINE_CLIENT_MOST)
        verdict = PP_WORK_LINE_CLIENT_FULL;
    if (verdict == PP_WORK_LINE_TAKEN) {
        task->owners++; /* no lock needed: no other thread knows the task yet */
        join_line(line, task);
        pthread_cond_signal(&line->wake);
    }
    pthread_mutex_unlock(&line->lock);
    return verdict;
}

int pp_work_line_count(struct pp_work_line *line)
{
    pthread_mutex_lock(&line->lock);
    int count = line->waiting_count + line->working;
    pthread_mutex_unlock(&line->lock);
    return count;
}

bool pp_work_line_destroy(struct pp_work_line *line, double seconds)
{
    if (!line)
        return true;
    pthread_mutex_lock(&line->lock);
    line->ending = true;
    pthread_cond_broadcast(&line->wake);
    pthread_mutex_unlock(&line->lock);
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    seconds = fmax(seconds, 0.0) + 1e-9 * (double)until.tv_nsec;
    until.tv_sec += (time_t)seconds;
    until.tv_nsec = (long)(1e9 * fmod(seconds, 1.0));
    for (int i = 0; i < line->worker_count; i++)
        if (pthread_timedjoin_np(line->workers[i], NULL, &until) != 0)
            return false;
    free(line->workers);
    pthread_cond_destroy(&line->wake);
    pthread_mutex_destroy(&line->lock);
    free(line);
    return true;
}
