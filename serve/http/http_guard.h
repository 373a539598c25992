/* http_guard.h - accepts or rejects requests according to their headers. For use inside
 * serve/ only. */
#ifndef PP_SERVE_HTTP_HTTP_GUARD_H
#define PP_SERVE_HTTP_HTTP_GUARD_H

#include <stdbool.h>

#include "serve/serve.h"

/* Headers of a request; NULL: the header is missing. */
struct pp_http_headers {
    const char *method;
    const char *host, *origin, *content_type, *authorization, *fetch_site;
};

/* True if the Host header is permitted: 127.0.0.1, localhost, [::1], the server's
 * address, or a name in `hosts`. If the server is not limited to loopback, any numeric
 * address is also permitted, since a DNS rebinding attack requires a name. The port is
 * ignored, because a proxy may use another port. */
bool pp_http_guard_host(const struct pp_serve_options *options, const char *host);

/* True if the texts are equal, or `wanted` is NULL. The duration does not depend on the
 * position of a difference. */
bool pp_http_guard_same(const char *wanted, const char *given);

/* Returns 0 if the request is accepted. Otherwise returns the HTTP status of the error
 * and sets *why to the reason. body_type: media type that the body must have; NULL:
 * none; is_page: the path is a file of the web page, which is public; token: token that
 * the path requires; NULL: none. */
unsigned pp_http_guard_check(const struct pp_serve_options *options,
                             const struct pp_http_headers *headers,
                             const char *body_type, bool is_page, const char *token,
                             const char **why);

#endif
