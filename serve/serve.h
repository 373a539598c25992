/* serve.h - the web server of the drawing board: one page and an interface in JSON.
 *
 * The server calls the library (pepperpot.h). Functions that the library does not have
 * are performed by pepperpot as a child process. docs/http.md describes the interface.
 * The server stores only uploaded weather files, in a temporary folder, and the results
 * of jobs.
 */
#ifndef PP_SERVE_SERVE_H
#define PP_SERVE_SERVE_H

#include "pepperpot.h"

enum { PP_SERVE_HOSTS_MOST = 16 };

struct pp_serve_options {
    const char *address; /* numeric address on which the server listens: "127.0.0.1",
                          * "::1", "0.0.0.0" */
    int port;            /* 0: any free port */
    const char *token;   /* required for every API request; NULL: no token */
    const char
        *hosts[PP_SERVE_HOSTS_MOST]; /* further host names of the server, for use behind
                                      * a proxy */
    int host_count;
    const char *jobs;    /* folder for the results of jobs; NULL: no jobs */
    const char *program; /* path of pepperpot, for child processes */
    const char *room;    /* room file that the page opens initially; NULL: none */
    size_t room_length;
    const char *key; /* token for fetching `room` (/api/room); NULL: the same token as
                      * for other requests */

    /* Called once, when the server listens on a port. */
    void (*ready)(void *data, int port);
    /* Called about 20 times a second; returns true to stop the server. */
    bool (*stop)(void *data);
    void *data;
};

/* Runs the server until `stop` returns true. Running work then has a second to finish.
 * PP_BAD_INPUT if the address is not numeric. PP_SYSTEM if the port is not available,
 * memory is exhausted, or a thread cannot be started. */
enum pp_status pp_serve_run(const struct pp_serve_options *options,
                            struct pp_error *err);

#endif
