/* task.h - the work for a request, and its answer. Inside serve/ only.
 *
 * A task belongs to the thread that reads requests until it is submitted to a line
 * (work_line.h). From then on a worker runs it, in slices, while its connection is
 * suspended. The answer is one whole, or a stream of events that begins before the work
 * ends. Both the request and the line own the task: the last to release it frees it.
 */
#ifndef PP_SERVE_WORK_TASK_H
#define PP_SERVE_WORK_TASK_H

#include <json.h>
#include <microhttpd.h>
#include <pthread.h>
#include <stdint.h>

#include "serve/server.h"

struct pp_task;

/* One slice of work, some 50 ms. True: the answer is complete. */
typedef bool pp_task_run(struct pp_task *task);

struct pp_task {
    struct pp_server *server;
    pp_task_run *run;
    const char *command;      /* "df", of the endpoint */
    char kind[32];            /* last part of the path, "waldram"; empty: none */
    struct json_object *body; /* of the request, an object */
    uint64_t client;          /* whose turn it is */

    void *state; /* of the run function, between slices */
    void (*free_state)(void *state);

    /* The answer, under the lock. */
    pthread_mutex_t lock;
    unsigned status;  /* HTTP's */
    const char *type; /* its media type, not owned */
    char *bytes;
    size_t length, taken; /* taken: of a stream, what has been sent */
    bool is_stream, is_done, is_suspended, is_cancelled;
    struct MHD_Connection *connection; /* NULL: it has none, or has lost it */
    int socket;
    int owners;

    /* Set by the work line. */
    struct pp_task *next;
    uint64_t turn;
};

/* A task without a connection; NULL: memory is out. Takes over body. */
struct pp_task *pp_task_create(struct pp_server *server, pp_task_run *run,
                               const char *command, struct json_object *body);
void pp_task_release(struct pp_task *task); /* NULL is allowed */

/* True if the client has closed its connection; checks the socket, too. */
bool pp_task_is_cancelled(struct pp_task *task);
void pp_task_cancel(struct pp_task *task);

/* Sets the whole answer; takes over bytes (malloc; NULL: memory is out). */
void pp_task_answer(struct pp_task *task, unsigned status, const char *type,
                    char *bytes, size_t length);
/* The same of an object, which is freed; NULL: memory is out. */
void pp_task_answer_json(struct pp_task *task, unsigned status,
                         struct json_object *object);
/* { "error": "..." }; in a stream that has begun, an event "error". */
void pp_task_fail(struct pp_task *task, unsigned status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* The same with the status that belongs to the error of the library. */
void pp_task_fail_with(struct pp_task *task, const struct pp_error *err);

/* Begins the stream, if it has not begun, and adds an event of one or more lines of data.
 * A client that does not read is cancelled. */
void pp_task_event(struct pp_task *task, const char *name, const char *data);

/* Ends the work: wakes the connection. */
void pp_task_finish(struct pp_task *task);

#endif
