/* task.h - the work for a request, and its answer. For use inside serve/ only.
 *
 * A new task belongs to the thread that reads requests. After the task is submitted to
 * a queue (work_line.h), a worker runs it in slices while its connection is suspended.
 * The answer is sent as a whole, or as a stream of events that begins before the work
 * ends. Request and queue are both owners of the task; the last owner to release the
 * task frees it.
 */
#ifndef PP_SERVE_WORK_TASK_H
#define PP_SERVE_WORK_TASK_H

#include <json.h>
#include <microhttpd.h>
#include <pthread.h>
#include <stdint.h>

#include "serve/server.h"

struct pp_task;

/* Runs one slice of work: about 40 ms of a simulation, or one child process. Returns
 * true if the answer is complete. */
typedef bool pp_task_run(struct pp_task *task);

struct pp_task {
    struct pp_server *server;
    pp_task_run *run;
    const char *command;      /* last part of the endpoint's path, such as "df" */
    char kind[32];            /* variable part of the path, such as "waldram"; empty:
                               * none */
    struct json_object *body; /* body of the request, a JSON object */
    uint64_t client;          /* hash of the client, for fair scheduling */

    void *state; /* state of the run function between slices */
    void (*free_state)(void *state);

    /* The answer. Access requires the lock. */
    pthread_mutex_t lock;
    unsigned status;  /* HTTP status */
    const char *type; /* media type, not owned */
    char *bytes;
    size_t length, taken; /* taken: number of bytes of a stream already sent */
    bool is_stream, is_done, is_suspended, is_cancelled;
    struct MHD_Connection *connection; /* NULL: none, or closed */
    int socket;
    int owners;

    /* For pp_task_is_given_up: when the socket was polled, and whether the task was
     * cancelled then. */
    atomic_long looked_ns;
    atomic_bool was_cancelled;

    /* Set by the queue (work_line.h). */
    struct pp_task *next;
    uint64_t turn;
};

/* Creates a task without a connection. Takes ownership of `body`, even after a failure.
 * NULL: out of memory. */
struct pp_task *pp_task_create(struct pp_server *server, pp_task_run *run,
                               const char *command, struct json_object *body);
void pp_task_release(struct pp_task *task); /* NULL is allowed */

/* True if the task was cancelled, the client has closed its connection (the socket is
 * polled), or the server is stopping. */
bool pp_task_is_cancelled(struct pp_task *task);
/* Like pp_task_is_cancelled, but polls the socket only every few milliseconds, so that
 * calculations can call it often. data: the task. */
bool pp_task_is_given_up(void *data);
void pp_task_cancel(struct pp_task *task);

/* Sets the complete answer, and takes ownership of `bytes`, which were allocated by
 * malloc; NULL: out of memory. */
void pp_task_answer(struct pp_task *task, unsigned status, const char *type,
                    char *bytes, size_t length);
/* Sets a JSON object as the answer, and frees the object. NULL: out of memory. */
void pp_task_answer_json(struct pp_task *task, unsigned status,
                         struct json_object *object);
/* Answers with { "error": "..." }. If a stream has begun, adds an event "error"
 * instead. */
void pp_task_fail(struct pp_task *task, unsigned status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Answers with an error of the library and the corresponding HTTP status. Does nothing
 * for PP_INTERRUPTED: nobody waits for the answer, or the server is stopping. */
void pp_task_fail_with(struct pp_task *task, const struct pp_error *err);

/* Adds an event to the stream, which begins if necessary. data: one or more lines. If
 * the client does not read and too many bytes are unsent, the task is cancelled. */
void pp_task_event(struct pp_task *task, const char *name, const char *data);

/* Marks the answer as complete and resumes the connection. */
void pp_task_finish(struct pp_task *task);

#endif
