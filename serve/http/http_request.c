/* http_request.c - see http_request.h. */
#include "serve/http/http_request.h"

#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "serve/endpoint.h"
#include "serve/http/http_deadline.h"
#include "serve/http/http_guard.h"
#include "serve/http/page_files.h"
#include "serve/work/work_line.h"

struct http_request {
    const struct pp_endpoint *endpoint;
    char kind[32];
    char *body;
    size_t length, expected;
    struct pp_task *task;
};

/* ---- answers ---- */

/* The page may load scripts and images only from this server, and connect only to
 * it. */
static const char content_policy[] =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: "
    "blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

static enum MHD_Result send_response(struct MHD_Connection *connection, unsigned status,
                                     const char *type, struct MHD_Response *response)
{
    if (!response)
        return MHD_NO;
    MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, type);
    MHD_add_response_header(response, "Content-Security-Policy", content_policy);
    MHD_add_response_header(response, "X-Content-Type-Options", "nosniff");
    MHD_add_response_header(response, "Referrer-Policy", "no-referrer");
    MHD_add_response_header(response, "Cross-Origin-Resource-Policy", "same-origin");
    MHD_add_response_header(response, "Cross-Origin-Opener-Policy", "same-origin");
    MHD_add_response_header(response, MHD_HTTP_HEADER_CACHE_CONTROL, "no-store");
    if (status == MHD_HTTP_UNAUTHORIZED)
        MHD_add_response_header(response, MHD_HTTP_HEADER_WWW_AUTHENTICATE, "Bearer");
    if (status == MHD_HTTP_SERVICE_UNAVAILABLE || status == MHD_HTTP_TOO_MANY_REQUESTS)
        MHD_add_response_header(response, MHD_HTTP_HEADER_RETRY_AFTER, "1");
    enum MHD_Result queued = MHD_queue_response(connection, status, response);
    MHD_destroy_response(response);
    return queued;
}

/* Answers with { "error": "..." }. The sentence must not need JSON escapes. allowed:
 * value of the header Allow for status 405; NULL: no such header. */
static enum MHD_Result refuse(struct MHD_Connection *connection, unsigned status,
                              const char *sentence, const char *allowed)
{
    char text[400];
    int length = snprintf(text, sizeof text, "{ \"error\": \"%s\" }\n", sentence);
    struct MHD_Response *response =
        MHD_create_response_from_buffer((size_t)length, text, MHD_RESPMEM_MUST_COPY);
    if (response && allowed)
        MHD_add_response_header(response, MHD_HTTP_HEADER_ALLOW, allowed);
    return send_response(connection, status, "application/json", response);
}

/* Copies the available bytes of a stream to the response. */
static ssize_t read_stream(void *data, uint64_t position, char *buffer, size_t most)
{
    struct pp_task *task = data;
    (void)position;
    ssize_t given = MHD_CONTENT_READER_END_OF_STREAM;
    pthread_mutex_lock(&task->lock);
    size_t waiting = task->length - task->taken;
    if (waiting > 0) {
        given = (ssize_t)(waiting < most ? waiting : most);
        memcpy(buffer, task->bytes + task->taken, (size_t)given);
        task->taken += (size_t)given;
    } else if (!task->is_done) {
        task->is_suspended = true;
        MHD_suspend_connection(task->connection);
        given = 0;
    }
    pthread_mutex_unlock(&task->lock);
    return given;
}

static enum MHD_Result send_answer(struct MHD_Connection *connection,
                                   struct pp_task *task)
{
    enum { STREAM_BLOCK = 16 << 10 };
    pthread_mutex_lock(&task->lock);
    struct MHD_Response *response = NULL;
    unsigned status = task->status;
    const char *type = task->type;
    if (task->is_stream)
        response = MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, STREAM_BLOCK,
                                                     read_stream, task, NULL);
    else if (status) {
        response = MHD_create_response_from_buffer(task->length, task->bytes,
                                                   MHD_RESPMEM_MUST_FREE);
        if (response)
            task->bytes = NULL; /* now owned by the response */
    }
    pthread_mutex_unlock(&task->lock);
    if (!status)
        return refuse(connection, MHD_HTTP_SERVICE_UNAVAILABLE,
                      "the server is shutting down, or the command was stopped", NULL);
    return send_response(connection, status, type, response);
}

static enum MHD_Result send_page_file(struct MHD_Connection *connection,
                                      const char *url)
{
    const struct pp_page_file *file = pp_page_files_find(url);
    if (!file)
        return refuse(connection, MHD_HTTP_NOT_FOUND, "there is no such path", NULL);
    struct MHD_Response *response = MHD_create_response_from_buffer(
        file->length, (void *)(uintptr_t)file->text, MHD_RESPMEM_PERSISTENT);
    return send_response(connection, MHD_HTTP_OK, file->type, response);
}

/* ---- first headers of a request ---- */

static const char *header(struct MHD_Connection *connection, const char *name)
{
    return MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
}

static enum MHD_Result begin_request(struct pp_server *server,
                                     struct MHD_Connection *connection, const char *url,
                                     const char *method, void **place)
{
    const struct pp_http_headers headers = {
        .method = method,
        .host = header(connection, MHD_HTTP_HEADER_HOST),
        .origin = header(connection, MHD_HTTP_HEADER_ORIGIN),
        .content_type = header(connection, MHD_HTTP_HEADER_CONTENT_TYPE),
        .authorization = header(connection, MHD_HTTP_HEADER_AUTHORIZATION),
        .fetch_site = header(connection, "Sec-Fetch-Site")};
    const char *allowed, *why;
    bool is_page = strncmp(url, "/api/", 5) != 0;
    char kind[32];
    const struct pp_endpoint *endpoint = pp_endpoint_find(method, url, kind, &allowed);
    const struct pp_serve_options *options = server->options;
    bool is_room = strcmp(url, "/api/room") == 0;
    unsigned status = pp_http_guard_check(
        options, &headers, endpoint ? endpoint->body_type : NULL, is_page,
        is_room && options->key ? options->key : options->token, &why);
    if (status)
        return refuse(connection, status, why, NULL);
    if (is_page && strcmp(method, "GET") != 0 && strcmp(method, "HEAD") != 0)
        return refuse(connection, MHD_HTTP_METHOD_NOT_ALLOWED,
                      "the page is read-only; expected GET", "GET, HEAD");
    if (is_page)
        return send_page_file(connection, url);
    if (!endpoint)
        return allowed ? refuse(connection, MHD_HTTP_METHOD_NOT_ALLOWED,
                                "this path does not support the method", allowed)
                       : refuse(connection, MHD_HTTP_NOT_FOUND, "there is no such path",
                                NULL);
    size_t expected = 0;
    if (endpoint->body_type) {
        const char *length = header(connection, MHD_HTTP_HEADER_CONTENT_LENGTH);
        if (!length)
            return refuse(connection, MHD_HTTP_LENGTH_REQUIRED,
                          "expected a Content-Length", NULL);
        unsigned long long bytes = strtoull(length, NULL, 10);
        if (bytes > endpoint->body_most)
            return refuse(connection, MHD_HTTP_CONTENT_TOO_LARGE,
                          "the request is too large", NULL);
        expected = (size_t)bytes;
    }
    struct http_request *request = calloc(1, sizeof *request);
    if (!request)
        return MHD_NO;
    request->endpoint = endpoint;
    request->expected = expected;
    memcpy(request->kind, kind, sizeof kind);
    request->body = malloc(expected + 1);
    *place = request;
    return request->body ? MHD_YES : MHD_NO;
}

/* ---- end of a request ---- */

/* Identifies the client for fair scheduling: a hash of the page's name, or of the
 * address if no page is named. */
static uint64_t client_of(struct MHD_Connection *connection)
{
    uint64_t hash = 1469598103934665603u; /* FNV-1a */
    const char *page = header(connection, "X-Pepperpot-Page");
    const union MHD_ConnectionInfo *info =
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
    char address[INET6_ADDRSTRLEN] = "";
    if (!page && info && info->client_addr) {
        const struct sockaddr *from = info->client_addr;
        const void *bytes =
            from->sa_family == AF_INET6
                ? (const void *)&((const struct sockaddr_in6 *)from)->sin6_addr
                : (const void *)&((const struct sockaddr_in *)from)->sin_addr;
        inet_ntop(from->sa_family, bytes, address, sizeof address);
    }
    for (const char *at = page ? page : address; *at; at++)
        hash = (hash ^ (unsigned char)*at) * 1099511628211u;
    return hash;
}

/* Parses the body as a JSON object. A body of another media type becomes { "bytes":
 * "..." }. NULL: not a JSON object, or out of memory. */
static struct json_object *body_object(const struct http_request *request)
{
    enum { DEPTH_MOST = 8 };
    struct json_object *object = NULL;
    if (!request->endpoint->body_type)
        return json_object_new_object();
    if (strcmp(request->endpoint->body_type, "application/json") != 0) {
        object = json_object_new_object();
        if (object)
            json_object_object_add(
                object, "bytes",
                json_object_new_string_len(request->body, (int)request->length));
        return object;
    }
    struct json_tokener *tokener = json_tokener_new_ex(DEPTH_MOST);
    if (!tokener)
        return NULL;
    json_tokener_set_flags(tokener, JSON_TOKENER_STRICT | JSON_TOKENER_VALIDATE_UTF8);
    request->body[request->length] = '\0';
    object = json_tokener_parse_ex(tokener, request->body, (int)request->length + 1);
    if (json_tokener_get_error(tokener) != json_tokener_success
        || !json_object_is_type(object, json_type_object)) {
        json_object_put(object);
        object = NULL;
    }
    json_tokener_free(tokener);
    return object;
}

static enum MHD_Result submit(struct pp_server *server,
                              struct MHD_Connection *connection,
                              struct http_request *request)
{
    const struct pp_endpoint *endpoint = request->endpoint;
    struct json_object *body = body_object(request);
    free(request->body);
    request->body = NULL;
    if (!body)
        return refuse(connection, MHD_HTTP_BAD_REQUEST,
                      "the body is not a JSON object, or is nested too deeply", NULL);
    const char *command = strrchr(endpoint->path, '/') + 1;
    struct pp_task *task =
        pp_task_create(server, endpoint->run, *command ? command : "chart", body);
    if (!task)
        return MHD_NO;
    memcpy(task->kind, request->kind, sizeof task->kind);
    task->client = client_of(connection);
    const union MHD_ConnectionInfo *info =
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
    task->socket = info ? info->connect_fd : -1;
    task->connection = connection;
    task->is_suspended = true;
    MHD_suspend_connection(connection);
    request->task = task;
    enum pp_work_line_verdict verdict = pp_work_line_submit(
        endpoint->line == PP_LINE_STUDIES ? server->studies : server->programs, task);
    if (verdict == PP_WORK_LINE_TAKEN)
        return MHD_YES;
    pp_task_fail(task,
                 verdict == PP_WORK_LINE_FULL ? MHD_HTTP_SERVICE_UNAVAILABLE
                                              : MHD_HTTP_TOO_MANY_REQUESTS,
                 verdict == PP_WORK_LINE_FULL
                     ? "the server is busy; try again later"
                     : "too many requests from this page are waiting; try again later");
    pp_task_finish(task);
    return MHD_YES;
}

/* ---- callbacks ---- */

static struct pp_http_deadline *deadline_of(struct MHD_Connection *connection)
{
    const union MHD_ConnectionInfo *info =
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
    return info ? info->socket_context : NULL;
}

enum MHD_Result pp_http_request_access(void *data, struct MHD_Connection *connection,
                                       const char *url, const char *method,
                                       const char *version, const char *upload,
                                       size_t *upload_size, void **place)
{
    struct pp_server *server = data;
    struct http_request *request = *place;
    (void)version;
    if (!request)
        return begin_request(server, connection, url, method, place);
    if (*upload_size > 0) {
        if (request->length + *upload_size > request->expected)
            return MHD_NO;
        memcpy(request->body + request->length, upload, *upload_size);
        request->length += *upload_size;
        *upload_size = 0;
        return MHD_YES;
    }
    if (request->task)
        return send_answer(connection, request->task);
    pp_http_deadline_wait(server->deadlines, deadline_of(connection), false);
    return submit(server, connection, request);
}

void pp_http_request_completed(void *data, struct MHD_Connection *connection,
                               void **place, enum MHD_RequestTerminationCode how)
{
    struct pp_server *server = data;
    struct http_request *request = *place;
    (void)how;
    pp_http_deadline_wait(server->deadlines, deadline_of(connection), true);
    if (!request)
        return;
    if (request->task) {
        struct pp_task *task = request->task;
        pthread_mutex_lock(&task->lock);
        task->connection = NULL;
        task->is_cancelled = true;
        pthread_mutex_unlock(&task->lock);
        pp_task_release(task);
    }
    free(request->body);
    free(request);
    *place = NULL;
}

void pp_http_request_connection(void *data, struct MHD_Connection *connection,
                                void **deadline,
                                enum MHD_ConnectionNotificationCode what)
{
    struct pp_server *server = data;
    if (what == MHD_CONNECTION_NOTIFY_CLOSED) {
        pp_http_deadline_end(server->deadlines, *deadline);
        *deadline = NULL;
        return;
    }
    const union MHD_ConnectionInfo *info =
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
    *deadline =
        info ? pp_http_deadline_begin(server->deadlines, info->connect_fd) : NULL;
}
