/* crew.c - members that sleep on a condition until there is work, and the indices they
 * take from a common counter.
 */
#include "model/base/crew.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Of indices with little work: how many a member takes at once, at most, and how often it
 * does so, at least, so that all come to the end together. */
enum { HANDFUL = 16, HANDFULS = 16 };

struct crew_member {
    struct pp_crew *crew; /* not owned */
    int number;           /* from 1; 0 is the caller */
    pthread_t thread;
};

struct pp_crew {
    int size;
    struct crew_member *members; /* but the caller */
    int started;                 /* of them */

    pthread_mutex_t mutex; /* of open, dismissed, number and at_work */
    pthread_cond_t come;   /* there is work, or the crew is dismissed */
    pthread_cond_t left;   /* nobody is at work any more */
    bool open;             /* may members come to the work? */
    bool dismissed;
    long number; /* of the work: who has been at it does not come again */
    int at_work; /* members, but the caller */

    /* The work at hand: written while no member is at work. */
    pp_crew_work *work;
    void *data;
    int end;
    int handful; /* of indices that a member takes at once */
    atomic_int next;
    atomic_bool stopped;

    pthread_mutex_t own; /* of the work itself: pp_crew_lock */
};

/* Of this process, whose processors may be fewer than the machine's. */
static int processors(void)
{
    cpu_set_t set;
    int count = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
    return count > 1 ? count : 1;
}

enum pp_status pp_crew_create(struct pp_crew **result, int threads,
                              struct pp_error *err)
{
    *result = NULL;
    struct pp_crew *crew = calloc(1, sizeof *crew);
    if (!crew)
        return pp_fail_memory(err);
    crew->size = threads > 0 ? threads : processors();
    crew->members = calloc((size_t)crew->size, sizeof *crew->members);
    if (!crew->members) {
        free(crew);
        return pp_fail_memory(err);
    }
    pthread_mutex_init(&crew->mutex, NULL);
    pthread_mutex_init(&crew->own, NULL);
    pthread_cond_init(&crew->come, NULL);
    pthread_cond_init(&crew->left, NULL);
    *result = crew;
    return PP_OK;
}

void pp_crew_destroy(struct pp_crew *crew)
{
    if (!crew)
        return;
    pthread_mutex_lock(&crew->mutex);
    crew->dismissed = true;
    pthread_cond_broadcast(&crew->come);
    pthread_mutex_unlock(&crew->mutex);
    for (int i = 0; i < crew->started; i++)
        pthread_join(crew->members[i].thread, NULL);
    pthread_cond_destroy(&crew->left);
    pthread_cond_destroy(&crew->come);
    pthread_mutex_destroy(&crew->own);
    pthread_mutex_destroy(&crew->mutex);
    free(crew->members);
    free(crew);
}

int pp_crew_size(const struct pp_crew *crew)
{
    return crew->size;
}

/* Takes indices until there are none. No index is taken after one whose work has
 * stopped the rest, but what was taken is done, so that those that are done are the first. */
static void take(struct pp_crew *crew, int member)
{
    while (!atomic_load(&crew->stopped)) {
        int first = atomic_fetch_add(&crew->next, crew->handful);
        if (first >= crew->end)
            break;
        int left = crew->end - first;
        int count = left < crew->handful ? left : crew->handful;
        for (int i = first; i < first + count; i++)
            if (!crew->work(crew->data, member, i))
                atomic_store(&crew->stopped, true);
    }
}

static void *life(void *data)
{
    const struct crew_member *member = data;
    struct pp_crew *crew = member->crew;
    long seen = 0;
    pthread_mutex_lock(&crew->mutex);
    while (!crew->dismissed) {
        if (!crew->open || crew->number == seen) {
            pthread_cond_wait(&crew->come, &crew->mutex);
            continue;
        }
        seen = crew->number;
        crew->at_work++;
        pthread_mutex_unlock(&crew->mutex);
        take(crew, member->number);
        pthread_mutex_lock(&crew->mutex);
        if (--crew->at_work == 0)
            pthread_cond_signal(&crew->left);
    }
    pthread_mutex_unlock(&crew->mutex);
    return NULL;
}

/* Starts members until there are `wanted`. Signals are for the program's own thread. */
static void start(struct pp_crew *crew, int wanted)
{
    sigset_t all, before;
    if (crew->started >= wanted)
        return;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    while (crew->started < wanted) {
        struct crew_member *member = &crew->members[crew->started];
        *member = (struct crew_member){.crew = crew, .number = crew->started + 1};
        if (pthread_create(&member->thread, NULL, life, member) != 0)
            break;
        crew->started++;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

static void call(struct pp_crew *crew)
{
    pthread_mutex_lock(&crew->mutex);
    crew->open = true;
    crew->number++;
    pthread_cond_broadcast(&crew->come);
    pthread_mutex_unlock(&crew->mutex);
}

/* Who comes from now on is too late; who is at work has an index to finish. */
static void close_and_wait(struct pp_crew *crew)
{
    pthread_mutex_lock(&crew->mutex);
    crew->open = false;
    while (crew->at_work > 0)
        pthread_cond_wait(&crew->left, &crew->mutex);
    pthread_mutex_unlock(&crew->mutex);
}

static int run(struct pp_crew *crew, int first, int end, int handful,
               pp_crew_work *work, void *data)
{
    int count = end - first;
    if (count <= 0)
        return first;
    crew->work = work;
    crew->data = data;
    crew->end = end;
    crew->handful = handful;
    atomic_store(&crew->next, first);
    atomic_store(&crew->stopped, false);
    int others = (count < crew->size ? count : crew->size) - 1;
    if (others > 0) {
        start(crew, others);
        call(crew);
    }
    take(crew, 0);
    if (others > 0)
        close_and_wait(crew);
    int next = atomic_load(&crew->next);
    return next < end ? next : end;
}

int pp_crew_run(struct pp_crew *crew, int first, int end, pp_crew_work *work,
                void *data)
{
    return run(crew, first, end, 1, work, data);
}

int pp_crew_run_small(struct pp_crew *crew, int first, int end, pp_crew_work *work,
                      void *data)
{
    int fair = (end - first) / (HANDFULS * crew->size);
    int handful = fair < 1 ? 1 : fair > HANDFUL ? HANDFUL : fair;
    return run(crew, first, end, handful, work, data);
}

void pp_crew_lock(struct pp_crew *crew)
{
    pthread_mutex_lock(&crew->own);
}

void pp_crew_unlock(struct pp_crew *crew)
{
    pthread_mutex_unlock(&crew->own);
}
