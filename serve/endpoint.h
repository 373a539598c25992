/* endpoint.h - the list of endpoints of the HTTP interface. For use inside serve/ only.
 *
 * To add an endpoint, write its run function in a separate file, and add a line to
 * endpoint.c and a path to docs/openapi.json. A test compares docs/openapi.json with
 * the list.
 */
#ifndef PP_SERVE_ENDPOINT_H
#define PP_SERVE_ENDPOINT_H

#include "serve/work/task.h"

enum pp_endpoint_line { PP_LINE_STUDIES, PP_LINE_PROGRAMS };

struct pp_endpoint {
    const char *method;    /* "GET" or "POST" */
    const char *path;      /* such as "/api/df"; a final "/" is followed by a variable
                            * part */
    const char *body_type; /* media type of the body of a POST; NULL for GET */
    size_t body_most;      /* maximum size of the body, bytes */
    enum pp_endpoint_line line;
    pp_task_run *run;
    const char *summary;
};

/* Endpoints in list order; NULL past the end. */
const struct pp_endpoint *pp_endpoint_at(int index);

/* Finds an endpoint by path and method; `kind` is set to the variable part of the path.
 * If it returns NULL, *allowed is the method that the path supports; NULL: there is no
 * such path. */
const struct pp_endpoint *pp_endpoint_find(const char *method, const char *path,
                                           char kind[32], const char **allowed);

#endif
