/* serve.c - see serve.h. */
#include "serve/serve.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "serve/http/http_deadline.h"
#include "serve/http/http_request.h"
#include "serve/serve_address.h"
#include "serve/server.h"
#include "serve/server_clock.h"
#include "serve/stores/weather_store.h"
#include "serve/work/work_line.h"

/* Times after a stop (s): until work is cancelled, until the server no longer waits for
 * cancelled work, and until connections are closed. */
static const double work_ends_s = 1.0, waiting_ends_s = 1.5, sending_ends_s = 1.7;

static enum pp_status fail_serve(struct pp_error *err, const char *what)
{
    if (err) {
        err->status = PP_SYSTEM;
        snprintf(err->message, sizeof err->message, "%s", what);
    }
    return PP_SYSTEM;
}

static void sleep_s(double seconds)
{
    const struct timespec time = {(time_t)seconds,
                                  (long)(1e9 * (seconds - (double)(time_t)seconds))};
    nanosleep(&time, NULL);
}

/* Converts a numeric address to a socket address. Returns false if the address is not
 * numeric. */
static bool socket_address(struct sockaddr_storage *storage, const char *address,
                           int port)
{
    struct sockaddr_in *four = (struct sockaddr_in *)storage;
    struct sockaddr_in6 *six = (struct sockaddr_in6 *)storage;
    memset(storage, 0, sizeof *storage);
    if (inet_pton(AF_INET, address, &four->sin_addr) == 1) {
        four->sin_family = AF_INET;
        four->sin_port = htons((uint16_t)port);
        return true;
    }
    six->sin6_family = AF_INET6;
    six->sin6_port = htons((uint16_t)port);
    return inet_pton(AF_INET6, address, &six->sin6_addr) == 1;
}

static enum pp_status start_daemon(struct pp_server *server, struct pp_error *err)
{
    const struct pp_serve_options *options = server->options;
    const char *address = options->address ? options->address : "127.0.0.1";
    struct sockaddr_storage storage;
    char sentence[200];
    if (!socket_address(&storage, address, options->port)) {
        snprintf(sentence, sizeof sentence,
                 "\"%.80s\" is not an IP address; expected one such as 127.0.0.1",
                 address);
        fail_serve(err, sentence);
        err->status = PP_BAD_INPUT;
        return PP_BAD_INPUT;
    }
    unsigned flags = MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME;
    if (storage.ss_family == AF_INET6)
        flags |= MHD_USE_IPv6;
    server->daemon = MHD_start_daemon(
        flags, (uint16_t)options->port, NULL, NULL, pp_http_request_access, server,
        MHD_OPTION_SOCK_ADDR, &storage, MHD_OPTION_NOTIFY_COMPLETED,
        pp_http_request_completed, server, MHD_OPTION_NOTIFY_CONNECTION,
        pp_http_request_connection, server, MHD_OPTION_CONNECTION_LIMIT,
        (unsigned)PP_HTTP_CONNECTIONS_MOST, MHD_OPTION_CONNECTION_TIMEOUT,
        (unsigned)(4 * PP_HTTP_REQUEST_SECONDS), MHD_OPTION_LISTENING_ADDRESS_REUSE, 1u,
        MHD_OPTION_END);
    if (!server->daemon) {
        snprintf(sentence, sizeof sentence,
                 "cannot listen on %.80s, port %d; another program may be using it",
                 address, options->port);
        return fail_serve(err, sentence);
    }
    const union MHD_DaemonInfo *info =
        MHD_get_daemon_info(server->daemon, MHD_DAEMON_INFO_BIND_PORT);
    server->port = info ? info->port : options->port;
    return PP_OK;
}

static int count_work(const struct pp_server *server)
{
    return pp_work_line_count(server->studies) + pp_work_line_count(server->programs);
}

/* Stops accepting requests, waits for running work, cancels the rest, and sends the
 * answers that are ready. Returns false if work in this process did not stop in time;
 * it then continues until the process ends. */
static bool end_server(struct pp_server *server)
{
    MHD_socket listening = MHD_quiesce_daemon(server->daemon);
    if (listening != MHD_INVALID_SOCKET)
        close(listening);
    double began = pp_server_clock();
    while (pp_server_clock() < began + work_ends_s && count_work(server) > 0)
        sleep_s(0.02);
    atomic_store(&server->ending, true);
    if (!pp_work_line_destroy(server->programs,
                              began + waiting_ends_s - pp_server_clock())
        || !pp_work_line_destroy(server->studies,
                                 began + waiting_ends_s - pp_server_clock()))
        return false;
    while (pp_server_clock() < began + sending_ends_s) {
        const union MHD_DaemonInfo *info =
            MHD_get_daemon_info(server->daemon, MHD_DAEMON_INFO_CURRENT_CONNECTIONS);
        if (!info || info->num_connections == 0)
            break;
        sleep_s(0.02);
    }
    MHD_stop_daemon(server->daemon);
    return true;
}

enum pp_status pp_serve_run(const struct pp_serve_options *options,
                            struct pp_error *err)
{
    struct pp_server *server = calloc(1, sizeof *server);
    struct pp_error own;
    err = err ? err : &own;
    if (!server)
        return fail_serve(err, "out of memory");
    server->options = options;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    int workers = processors < 2 ? 2 : processors > 16 ? 16 : (int)processors;
    enum pp_status status = PP_OK;
    signal(SIGPIPE, SIG_IGN);
    server->is_loopback = pp_serve_address_is_loopback(options->address);
    server->deadlines = pp_http_deadline_list_create();
    server->weather = pp_weather_store_create();
    server->studies = pp_work_line_create(workers);
    server->programs = pp_work_line_create(workers);
    if (!server->deadlines || !server->weather || !server->studies || !server->programs)
        status = fail_serve(err, "the server cannot be started: there is not enough "
                                 "memory, no thread, or no folder for files in /tmp");
    if (status == PP_OK)
        status = start_daemon(server, err);
    if (status == PP_OK) {
        options->ready(options->data, server->port);
        while (!options->stop(options->data)) {
            sleep_s(0.05);
            pp_http_deadline_look(server->deadlines);
        }
        if (!end_server(server)) {
            pp_weather_store_empty(server->weather);
            return PP_OK;
        }
    } else {
        pp_work_line_destroy(server->studies, 1.0);
        pp_work_line_destroy(server->programs, 1.0);
    }
    pp_weather_store_destroy(server->weather);
    pp_http_deadline_list_destroy(server->deadlines);
    free(server);
    return status;
}
