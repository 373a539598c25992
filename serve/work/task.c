/* task.c - see task.h. */
#include "serve/work/task.h"

#include <poll.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Maximum number of unsent bytes of a stream. */
enum { WAITING_MOST = 8 << 20 };

static const char json_media_type[] = "application/json";
static const char memory_text[] = "{ \"error\": \"out of memory\" }\n";

struct pp_task *pp_task_create(struct pp_server *server, pp_task_run *run,
                               const char *command, struct json_object *body)
{
    struct pp_task *task = calloc(1, sizeof *task);
    if (!task || pthread_mutex_init(&task->lock, NULL) != 0) {
        free(task);
        json_object_put(body);
        return NULL;
    }
    task->server = server;
    task->run = run;
    task->command = command;
    task->body = body;
    task->socket = -1;
    task->owners = 1;
    return task;
}

void pp_task_release(struct pp_task *task)
{
    if (!task)
        return;
    pthread_mutex_lock(&task->lock);
    int left = --task->owners;
    pthread_mutex_unlock(&task->lock);
    if (left > 0)
        return;
    if (task->state && task->free_state)
        task->free_state(task->state);
    json_object_put(task->body);
    free(task->bytes);
    pthread_mutex_destroy(&task->lock);
    free(task);
}

bool pp_task_is_cancelled(struct pp_task *task)
{
    pthread_mutex_lock(&task->lock);
    if (task->connection && !task->is_cancelled) {
        struct pollfd socket = {.fd = task->socket, .events = POLLRDHUP};
        if (poll(&socket, 1, 0) > 0
            && (socket.revents & (POLLRDHUP | POLLHUP | POLLERR)))
            task->is_cancelled = true;
    }
    bool is_cancelled = task->is_cancelled;
    pthread_mutex_unlock(&task->lock);
    return is_cancelled || atomic_load(&task->server->ending);
}

bool pp_task_is_given_up(void *data)
{
    struct pp_task *task = data;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC_COARSE, &now); /* changes every few milliseconds */
    if (atomic_exchange(&task->looked_ns, now.tv_nsec) != now.tv_nsec)
        atomic_store(&task->was_cancelled, pp_task_is_cancelled(task));
    return atomic_load(&task->was_cancelled);
}

void pp_task_cancel(struct pp_task *task)
{
    pthread_mutex_lock(&task->lock);
    task->is_cancelled = true;
    pthread_mutex_unlock(&task->lock);
}

/* Resumes the connection if it is suspended. The caller must hold the task's lock. */
static void wake_connection(struct pp_task *task)
{
    if (!task->is_suspended)
        return;
    task->is_suspended = false;
    MHD_resume_connection(task->connection);
}

void pp_task_answer(struct pp_task *task, unsigned status, const char *type,
                    char *bytes, size_t length)
{
    if (!bytes) {
        status = MHD_HTTP_INTERNAL_SERVER_ERROR;
        type = json_media_type;
        bytes = strdup(memory_text);
        length = bytes ? strlen(bytes) : 0;
    }
    pthread_mutex_lock(&task->lock);
    free(task->bytes);
    task->status = status;
    task->type = type;
    task->bytes = bytes;
    task->length = length;
    pthread_mutex_unlock(&task->lock);
}

void pp_task_answer_json(struct pp_task *task, unsigned status,
                         struct json_object *object)
{
    size_t length = 0;
    const char *text = object ? json_object_to_json_string_length(
                           object, JSON_C_TO_STRING_NOSLASHESCAPE, &length)
                              : NULL;
    char *bytes = text ? malloc(length + 2) : NULL;
    if (bytes) {
        memcpy(bytes, text, length);
        memcpy(bytes + length, "\n", 2);
    }
    json_object_put(object);
    pp_task_answer(task, status, json_media_type, bytes, length + 1);
}

void pp_task_fail(struct pp_task *task, unsigned status, const char *format, ...)
{
    char sentence[1200];
    va_list list;
    va_start(list, format);
    vsnprintf(sentence, sizeof sentence, format, list);
    va_end(list);
    struct json_object *object = json_object_new_object();
    if (object)
        json_object_object_add(object, "error", json_object_new_string(sentence));
    pthread_mutex_lock(&task->lock);
    bool streams = task->is_stream;
    pthread_mutex_unlock(&task->lock);
    if (!streams) {
        pp_task_answer_json(task, status, object);
        return;
    }
    pp_task_event(task, "error", object ? json_object_to_json_string(object) : "{}");
    json_object_put(object);
}

void pp_task_fail_with(struct pp_task *task, const struct pp_error *err)
{
    if (err->status == PP_INTERRUPTED)
        return;
    pp_task_fail(task,
                 err->status == PP_BAD_INPUT ? MHD_HTTP_UNPROCESSABLE_CONTENT
                                             : MHD_HTTP_INTERNAL_SERVER_ERROR,
                 "%s", err->message);
}

/* Appends to the unsent bytes. The caller must hold the lock. Returns false if memory
 * is exhausted. */
static bool append_bytes(struct pp_task *task, const char *bytes, size_t length)
{
    if (task->taken > 0) {
        memmove(task->bytes, task->bytes + task->taken, task->length - task->taken);
        task->length -= task->taken;
        task->taken = 0;
    }
    char *grown = realloc(task->bytes, task->length + length + 1);
    if (!grown)
        return false;
    memcpy(grown + task->length, bytes, length);
    task->bytes = grown;
    task->length += length;
    return true;
}

/* Text of an event: "event: NAME", each line of the data after "data: ", and an empty
 * line. */
static char *event_text(const char *name, const char *data, size_t *length)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, length);
    if (!out)
        return NULL;
    fprintf(out, "event: %s\n", name);
    for (const char *line = data; *line;) {
        size_t bytes = strcspn(line, "\n");
        fprintf(out, "data: %.*s\n", (int)bytes, line);
        line += bytes + (line[bytes] == '\n');
    }
    fputc('\n', out);
    if (fclose(out) == 0)
        return text;
    free(text);
    return NULL;
}

void pp_task_event(struct pp_task *task, const char *name, const char *data)
{
    size_t length = 0;
    char *text = event_text(name, data, &length);
    pthread_mutex_lock(&task->lock);
    if (!task->is_stream) {
        task->is_stream = true;
        task->status = MHD_HTTP_OK;
        task->type = "text/event-stream";
    }
    if (!text || task->length - task->taken + length > WAITING_MOST
        || !append_bytes(task, text, length))
        task->is_cancelled = true;
    wake_connection(task);
    pthread_mutex_unlock(&task->lock);
    free(text);
}

void pp_task_finish(struct pp_task *task)
{
    pthread_mutex_lock(&task->lock);
    task->is_done = true;
    wake_connection(task);
    pthread_mutex_unlock(&task->lock);
}
