/* http_deadline.h - closes connections whose requests take too long to arrive. For use
 * inside serve/ only.
 *
 * A limit on idle time is not enough: a client that sends one byte a second is never
 * idle. Each connection therefore has a fixed time limit for a request. The time runs
 * from the beginning of the connection, or the end of its last answer, to the end of
 * the next request.
 */
#ifndef PP_SERVE_HTTP_HTTP_DEADLINE_H
#define PP_SERVE_HTTP_HTTP_DEADLINE_H

#include <stdbool.h>

enum { PP_HTTP_CONNECTIONS_MOST = 1000, PP_HTTP_REQUEST_SECONDS = 15 };

struct pp_http_deadlines;
struct pp_http_deadline;

struct pp_http_deadlines *pp_http_deadline_list_create(void); /* NULL: out of memory */
void pp_http_deadline_list_destroy(struct pp_http_deadlines *list);

/* Registers the connection on a socket. NULL if there are too many connections. */
struct pp_http_deadline *pp_http_deadline_begin(struct pp_http_deadlines *list,
                                                int socket);
/* Starts (`waits` true) or stops (false) the time limit for the next request of a
 * connection. Stop the time limit when a request is complete. */
void pp_http_deadline_wait(struct pp_http_deadlines *list, struct pp_http_deadline *one,
                           bool waits);
void pp_http_deadline_end(struct pp_http_deadlines *list, struct pp_http_deadline *one);

/* Shuts down sockets whose time limit has expired. */
void pp_http_deadline_look(struct pp_http_deadlines *list);

#endif
