/* http_deadline.h - closes connections whose requests take too long to arrive. Inside
 * serve/ only.
 *
 * A limit on idle time is not enough: a client that sends one byte a second is never
 * idle. Each connection therefore has a fixed time, from its beginning or the end of
 * its last answer to the end of its next request.
 */
#ifndef PP_SERVE_HTTP_HTTP_DEADLINE_H
#define PP_SERVE_HTTP_HTTP_DEADLINE_H

#include <stdbool.h>

enum { PP_HTTP_CONNECTIONS_MOST = 1000, PP_HTTP_REQUEST_SECONDS = 15 };

struct pp_http_deadlines;
struct pp_http_deadline;

struct pp_http_deadlines *pp_http_deadline_list_create(void); /* NULL: no memory */
void pp_http_deadline_list_destroy(struct pp_http_deadlines *list);

/* Registers a connection on that socket; NULL if there are too many. */
struct pp_http_deadline *pp_http_deadline_begin(struct pp_http_deadlines *list,
                                                int socket);
/* waits = true: starts the time limit for the connection's next request; false: stops
 * it, when a request is complete. */
void pp_http_deadline_wait(struct pp_http_deadlines *list, struct pp_http_deadline *one,
                           bool waits);
void pp_http_deadline_end(struct pp_http_deadlines *list, struct pp_http_deadline *one);

/* Shuts down the sockets whose time has expired. */
void pp_http_deadline_look(struct pp_http_deadlines *list);

#endif
