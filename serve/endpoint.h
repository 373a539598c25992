/* endpoint.h - the list of the interface's endpoints. Inside serve/ only.
 *
 * A new one is a line in endpoint.c, a run function in a file of its own, and a path in
 * docs/openapi.json, which a test compares with this list.
 */
#ifndef PP_SERVE_ENDPOINT_H
#define PP_SERVE_ENDPOINT_H

#include "serve/work/task.h"

enum pp_endpoint_line { PP_LINE_STUDIES, PP_LINE_PROGRAMS };

struct pp_endpoint {
    const char *method;    /* "GET" or "POST" */
    const char *path;      /* "/api/df"; one that ends with "/" takes one more part */
    const char *body_type; /* of a POST */
    size_t body_most;      /* bytes */
    enum pp_endpoint_line line;
    pp_task_run *run;
    const char *summary;
};

/* In list order; NULL behind the last. */
const struct pp_endpoint *pp_endpoint_at(int index);

/* The endpoint of a path and method; kind gets the last part of a path that takes one.
 * NULL, and *allowed NULL: there is no such path; *allowed: the path takes that method. */
const struct pp_endpoint *pp_endpoint_find(const char *method, const char *path,
                                           char kind[32], const char **allowed);

#endif
