/* fuzz_request.c - the server of pepperpot serve answers a request with any path,
 * headers and body: with a valid status and, for every error, a sentence.
 *
 * For clang's libFuzzer (make fuzz). The first line of the input is method and path.
 * Header lines follow up to an empty line; the rest is the body. The target adds the
 * length of the body, so that every request is complete. Its server runs /bin/false
 * instead of the command.
 */
#include <arpa/inet.h>
#include <json.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "serve/serve.h"
#include "tests/fuzz/must.h"

/* Bytes of an answer after which the client disconnects, and longest time (ms) without
 * any bytes of an answer. Sanitizers and other programs slow the server down, so the
 * limit is longer than that of a server in use. */
enum { ANSWER_MOST = 1 << 17, SILENCE_MOST_MS = 5000 };

static atomic_int fuzz_port;
static atomic_bool fuzz_ends;
static pthread_t fuzz_server;

static void note_port(void *data, int port)
{
    (void)data;
    atomic_store(&fuzz_port, port);
}

static bool is_over(void *data)
{
    (void)data;
    return atomic_load(&fuzz_ends);
}

static void *run_server(void *data)
{
    static const char room[] =
        "<room version='1'><plan width='3' depth='4' height='3'/></room>";
    const struct pp_serve_options options = {.program = "/bin/false",
                                             .room = room,
                                             .room_length = sizeof room - 1,
                                             .key = "k",
                                             .ready = note_port,
                                             .stop = is_over};
    (void)data;
    must(pp_serve_run(&options, NULL) == PP_OK);
    return NULL;
}

static void end_server(void)
{
    atomic_store(&fuzz_ends, true);
    pthread_join(fuzz_server, NULL);
}

static void start_server(void)
{
    must(pthread_create(&fuzz_server, NULL, run_server, NULL) == 0);
    while (atomic_load(&fuzz_port) == 0)
        nanosleep(&(struct timespec){0, 1000000}, NULL);
    atexit(end_server);
}

/* A connection that leaves no port occupied after it is closed. */
static int connect_to_server(void)
{
    struct sockaddr_in address = {.sin_family = AF_INET,
                                  .sin_port = htons((uint16_t)atomic_load(&fuzz_port)),
                                  .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    int end = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    must(end >= 0 && connect(end, (void *)&address, sizeof address) == 0);
    setsockopt(end, SOL_SOCKET, SO_LINGER, &(struct linger){1, 0},
               sizeof(struct linger));
    return end;
}

/* True for headers that change the length of the request. */
static bool is_about_length(const char *line)
{
    return strncasecmp(line, "Content-Length", 14) == 0
           || strncasecmp(line, "Transfer-Encoding", 17) == 0
           || strncasecmp(line, "Expect", 6) == 0
           || strncasecmp(line, "Connection", 10) == 0
           || strncasecmp(line, "Upgrade", 7) == 0;
}

/* The request for an input: a null-terminated text of lines. */
static char *request_text(char *lines, size_t *length)
{
    char *text = NULL, *body = strstr(lines, "\n\n");
    FILE *out = open_memstream(&text, length);
    bool is_first = true;
    must(out != NULL);
    if (body) {
        *body = '\0';
        body += 2;
    }
    for (char *line; (line = strsep(&lines, "\n")); is_first = false)
        if (is_first)
            fprintf(out, "%s HTTP/1.1\r\nHost: 127.0.0.1\r\n", line);
        else if (*line != ' ' && *line != '\t' && !is_about_length(line))
            fprintf(out, "%s\r\n", line);
    fprintf(out, "Connection: close\r\nContent-Length: %zu\r\n\r\n%s",
            body ? strlen(body) : 0, body ? body : "");
    must(fclose(out) == 0);
    return text;
}

/* Sends the request, and returns the beginning of the answer, null-terminated. */
static char *answer_to(const char *request, size_t length)
{
    char *answer = malloc(ANSWER_MOST + 1);
    size_t got = 0;
    int end = connect_to_server();
    must(answer != NULL);
    while (got < ANSWER_MOST) {
        struct pollfd ready = {end, (short)(POLLIN | (length > 0 ? POLLOUT : 0)), 0};
        must(poll(&ready, 1, SILENCE_MOST_MS) > 0);
        if (ready.revents & POLLOUT) {
            ssize_t sent = send(end, request, length, MSG_NOSIGNAL | MSG_DONTWAIT);
            length = sent < 0 ? 0 : length - (size_t)sent;
            request += sent < 0 ? 0 : sent;
        }
        if (!(ready.revents & (POLLIN | POLLHUP | POLLERR)))
            continue;
        ssize_t count = recv(end, answer + got, ANSWER_MOST - got, 0);
        if (count <= 0)
            break;
        got += (size_t)count;
        answer[got] = '\0';
        if (strstr(answer, "\nevent: "))
            break; /* a stream: the rest is not read */
    }
    close(end);
    answer[got] = '\0';
    return answer;
}

/* Checks status and error of an answer; libmicrohttpd's own answers are pages. */
static void check_answer(const char *answer)
{
    int status = 0;
    const char *body = strstr(answer, "\r\n\r\n");
    if (*answer == '\0')
        return; /* the request is not HTTP */
    must(sscanf(answer, "HTTP/1.1 %3d", &status) == 1 && body);
    must(status == 200 || status == 202 || (status >= 400 && status < 500)
         || strstr(body, "the command failed"));
    if (body[4] == '\0' /* an answer to HEAD */
        || !strstr(answer, "\r\nContent-Type: application/json")
        || strstr(answer, "\r\nTransfer-Encoding: chunked"))
        return;
    struct json_object *object = json_tokener_parse(body), *sentence = NULL;
    must(strlen(answer) == ANSWER_MOST || object);
    must(status < 400 || json_object_object_get_ex(object, "error", &sentence));
    json_object_put(object);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    char *lines = strndup((const char *)bytes, length);
    if (atomic_load(&fuzz_port) == 0)
        start_server();
    must(lines != NULL);
    char *request = request_text(lines, &length);
    char *answer = answer_to(request, length);
    check_answer(answer);
    free(answer);
    free(request);
    free(lines);
    return 0;
}
