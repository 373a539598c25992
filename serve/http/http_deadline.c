/* http_deadline.c - see http_deadline.h. */
#include "serve/http/http_deadline.h"

#include <pthread.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <time.h>

struct pp_http_deadline {
    bool is_used, waits;
    int socket;
    time_t since;
};

struct pp_http_deadlines {
    pthread_mutex_t lock;
    struct pp_http_deadline list[PP_HTTP_CONNECTIONS_MOST];
};

static time_t seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec;
}

struct pp_http_deadlines *pp_http_deadline_list_create(void)
{
    struct pp_http_deadlines *list = calloc(1, sizeof *list);
    if (list)
        pthread_mutex_init(&list->lock, NULL);
    return list;
}

void pp_http_deadline_list_destroy(struct pp_http_deadlines *list)
{
    if (list)
        pthread_mutex_destroy(&list->lock);
    free(list);
}

struct pp_http_deadline *pp_http_deadline_begin(struct pp_http_deadlines *list,
                                                int socket)
{
    struct pp_http_deadline *found = NULL;
    pthread_mutex_lock(&list->lock);
    for (int i = 0; i < PP_HTTP_CONNECTIONS_MOST && !found; i++)
        if (!list->list[i].is_used)
            found = &list->list[i];
    if (found)
        *found = (struct pp_http_deadline){true, true, socket, seconds_now()};
    pthread_mutex_unlock(&list->lock);
    return found;
}

void pp_http_deadline_wait(struct pp_http_deadlines *list, struct pp_http_deadline *one,
                           bool waits)
{
    if (!one)
        return;
    pthread_mutex_lock(&list->lock);
    one->waits = waits;
    one->since = seconds_now();
    pthread_mutex_unlock(&list->lock);
}

void pp_http_deadline_end(struct pp_http_deadlines *list, struct pp_http_deadline *one)
{
    if (!one)
        return;
    pthread_mutex_lock(&list->lock);
    one->is_used = false;
    pthread_mutex_unlock(&list->lock);
}

void pp_http_deadline_look(struct pp_http_deadlines *list)
{
    time_t now = seconds_now();
    pthread_mutex_lock(&list->lock);
    for (int i = 0; i < PP_HTTP_CONNECTIONS_MOST; i++) {
        struct pp_http_deadline *one = &list->list[i];
        if (one->is_used && one->waits && now - one->since > PP_HTTP_REQUEST_SECONDS) {
            shutdown(one->socket, SHUT_RDWR);
            one->waits = false;
        }
    }
    pthread_mutex_unlock(&list->lock);
}
