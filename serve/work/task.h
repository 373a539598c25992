/* task.h - the work for a request, and its answer. Inside serve/ only.
 *
 * A new task belongs to the thread that reads requests, until it is submitted to a
 * queue (work_line.h). A worker then runs it in slices, while its connection is
 * suspended. The answer is sent as a whole, or as a stream of events that begins before
 * the work ends. The request and the queue both own the task; the last of them to
 * release it frees it.
 */
#ifndef PP_SERVE_WORK_TASK_H
#define PP_SERVE_WORK_TASK_H

#include <json.h>
#include <microhttpd.h>
#include <pthread.h>
#include <stdint.h>

#include "serve/server.h"

struct pp_task;

/* Runs one slice of work, about 50 ms. Returns true if the answer is complete. */
typedef bool pp_task_run(struct pp_task *task);

struct pp_task {
    struct pp_server *server;
    pp_task_run *run;
    const char *command;      /* "df": the last part of the endpoint's path */
    char kind[32];            /* variable part of the path, "waldram"; empty: none */
    struct json_object *body; /* request body, an object */
    uint64_t client;          /* hash of the client, for fair scheduling */

    void *state; /* kept for the run function between slices */
    void (*free_state)(void *state);

    /* The answer; access needs the lock. */
    pthread_mutex_t lock;
    unsigned status;  /* HTTP's */
    const char *type; /* media type, not owned */
    char *bytes;
    size_t length, taken; /* taken: number of bytes of a stream already sent */
    bool is_stream, is_done, is_suspended, is_cancelled;
    struct MHD_Connection *connection; /* NULL: none, or closed */
    int socket;
    int owners;

    /* Set by the queue. */
    struct pp_task *next;
    uint64_t turn;
};

/* Creates a task without a connection; NULL: out of memory. Takes ownership of body
 * even then. */
struct pp_task *pp_task_create(struct pp_server *server, pp_task_run *run,
                               const char *command, struct json_object *body);
void pp_task_release(struct pp_task *task); /* NULL is allowed */

/* True if the client has closed its connection or the server is stopping; polls the
 * socket. */
bool pp_task_is_cancelled(struct pp_task *task);
void pp_task_cancel(struct pp_task *task);

/* Sets the complete answer; takes ownership of bytes (malloc; NULL: out of memory). */
void pp_task_answer(struct pp_task *task, unsigned status, const char *type,
                    char *bytes, size_t length);
/* Sets a JSON object as the answer and frees it; NULL: out of memory. */
void pp_task_answer_json(struct pp_task *task, unsigned status,
                         struct json_object *object);
/* Answers with { "error": "..." }; a stream that has begun gets an event "error". */
void pp_task_fail(struct pp_task *task, unsigned status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Answers with the library's error and the HTTP status for it. */
void pp_task_fail_with(struct pp_task *task, const struct pp_error *err);

/* Adds an event to the stream, and begins the stream if necessary; data may have
 * several lines. If the client does not read, and too many bytes are unsent, the task
 * is cancelled. */
void pp_task_event(struct pp_task *task, const char *name, const char *data);

/* Marks the answer as complete and resumes the connection. */
void pp_task_finish(struct pp_task *task);

#endif
