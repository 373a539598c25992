/* server.h - state shared by the parts of a running server. For use inside serve/
 * only. */
#ifndef PP_SERVE_SERVER_H
#define PP_SERVE_SERVER_H

#include <microhttpd.h>
#include <stdatomic.h>

#include "serve/serve.h"

struct pp_work_line;
struct pp_http_deadlines;
struct pp_weather_store;

struct pp_server {
    const struct pp_serve_options *options;
    struct MHD_Daemon *daemon;
    int port;
    bool is_loopback;
    struct pp_work_line *studies;  /* queue of work done in this process */
    struct pp_work_line *programs; /* queue of work done by child processes */
    struct pp_http_deadlines *deadlines;
    struct pp_weather_store *weather;
    atomic_bool ending;
};

#endif
