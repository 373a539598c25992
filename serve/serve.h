/* serve.h - the drawing board's web server: one page and a JSON interface.
 *
 * It uses pepperpot.h and, for what that lacks, the program itself as a child process.
 * docs/http.md describes the interface. The server keeps nothing of a request but weather
 * files, in memory, and the results that `jobs` is for.
 */
#ifndef PP_SERVE_SERVE_H
#define PP_SERVE_SERVE_H

#include "pepperpot.h"

enum { PP_SERVE_HOSTS_MOST = 16 };

struct pp_serve_options {
    const char *address; /* to listen on, a number: "127.0.0.1", "::1", "0.0.0.0" */
    int port;            /* 0: one that is free */
    const char *token;   /* that every request of the interface carries; NULL: none */
    const char
        *hosts[PP_SERVE_HOSTS_MOST]; /* further names of the server, behind a proxy */
    int host_count;
    const char *jobs;    /* folder for results to be fetched later; NULL: no jobs */
    const char *program; /* path of pepperpot, to be run as a child */
    const char *room;    /* text of the room that the page opens with; NULL: none */
    size_t room_length;
    const char *key; /* that the page gets this room by; NULL: the token */

    /* Called once, when the server listens on a port. */
    void (*ready)(void *data, int port);
    /* Called some twenty times a second; true ends the server. */
    bool (*stop)(void *data);
    void *data;
};

/* Serves until `stop` says so; work that goes on then has a second to end. PP_SYSTEM: the
 * address cannot be listened on, or memory or threads are out. */
enum pp_status pp_serve_run(const struct pp_serve_options *options,
                            struct pp_error *err);

#endif
