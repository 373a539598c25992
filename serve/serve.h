/* serve.h - the drawing board's web server: one page and a JSON interface.
 *
 * The server calls the library (pepperpot.h). Functions that the library lacks are done
 * by pepperpot as a child process. docs/http.md describes the interface. Requests leave
 * no data behind, except weather files, in a temporary folder, and the results of jobs.
 */
#ifndef PP_SERVE_SERVE_H
#define PP_SERVE_SERVE_H

#include "pepperpot.h"

enum { PP_SERVE_HOSTS_MOST = 16 };

struct pp_serve_options {
    const char *address; /* numeric address to listen on: "127.0.0.1", "::1",
                          * "0.0.0.0" */
    int port;            /* 0: any free port */
    const char *token;   /* every API request must have it; NULL: no token */
    const char
        *hosts[PP_SERVE_HOSTS_MOST]; /* further names of the server, behind a proxy */
    int host_count;
    const char *jobs;    /* folder for the results of jobs; NULL: no jobs */
    const char *program; /* path of pepperpot, for child processes */
    const char *room;    /* room file that the page opens first; NULL: none */
    size_t room_length;
    const char *key; /* token required to fetch `room` (/api/room); NULL: the general
                      * token */

    /* Called once the server listens on a port. */
    void (*ready)(void *data, int port);
    /* Called about 20 times a second; true stops the server. */
    bool (*stop)(void *data);
    void *data;
};

/* Serves until `stop` returns true; running work then has a second to finish.
 * PP_BAD_INPUT if the address is not numeric; PP_SYSTEM if the port is not available,
 * memory runs out, or a thread cannot be started. */
enum pp_status pp_serve_run(const struct pp_serve_options *options,
                            struct pp_error *err);

#endif
