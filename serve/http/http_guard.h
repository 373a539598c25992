/* http_guard.h - accepts or refuses requests by their headers. Inside serve/ only. */
#ifndef PP_SERVE_HTTP_HTTP_GUARD_H
#define PP_SERVE_HTTP_HTTP_GUARD_H

#include <stdbool.h>

#include "serve/serve.h"

/* Headers of a request; NULL where there is none. */
struct pp_http_headers {
    const char *method;
    const char *host, *origin, *content_type, *authorization, *fetch_site;
};

/* Is the Host one of the server's? A loopback server goes by 127.0.0.1, localhost and
 * [::1]; any other by every numeric address, too, since only names can be made to point to
 * it by others (DNS rebinding); and both by the names in `hosts`. The port, if any, is
 * not compared: a proxy may have another. */
bool pp_http_guard_host(const struct pp_serve_options *options, const char *host);

/* True if both texts are equal; the time does not depend on where they differ. wanted
 * NULL: true. */
bool pp_http_guard_same(const char *wanted, const char *given);

/* Returns 0, or the status to refuse the request with, and *why. is_page: the path is of the
 * page, whose files are no secret. token: that the path needs; NULL: none. */
unsigned pp_http_guard_check(const struct pp_serve_options *options,
                             const struct pp_http_headers *headers,
                             const char *body_type, bool is_page, const char *token,
                             const char **why);

#endif
