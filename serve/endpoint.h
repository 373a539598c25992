/* endpoint.h - the list of the interface's endpoints. Inside serve/ only.
 *
 * A new endpoint needs a line in endpoint.c, a run function in its own file, and a path
 * in docs/openapi.json, which a test compares with this list.
 */
#ifndef PP_SERVE_ENDPOINT_H
#define PP_SERVE_ENDPOINT_H

#include "serve/work/task.h"

enum pp_endpoint_line { PP_LINE_STUDIES, PP_LINE_PROGRAMS };

struct pp_endpoint {
    const char *method;    /* "GET" or "POST" */
    const char *path;      /* "/api/df"; a final "/" stands for one variable part */
    const char *body_type; /* media type of a POST; NULL for GET */
    size_t body_most;      /* bytes */
    enum pp_endpoint_line line;
    pp_task_run *run;
    const char *summary;
};

/* Endpoints in list order; NULL past the end. */
const struct pp_endpoint *pp_endpoint_at(int index);

/* Finds an endpoint by path and method; kind is the variable part of the path. If it
 * returns NULL, *allowed is the method that the path supports, or NULL if there is no
 * such path. */
const struct pp_endpoint *pp_endpoint_find(const char *method, const char *path,
                                           char kind[32], const char **allowed);

#endif
