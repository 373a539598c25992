/* http_guard.c - see http_guard.h. */
#include "serve/http/http_guard.h"

#include <arpa/inet.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include <microhttpd.h>

#include "serve/serve_address.h"

enum { HOST_BYTES = 256 };

/* Extracts the host without the port: "[::1]:80" gives "::1". Returns false if the text
 * is not a valid host. */
static bool bare_host(char bare[HOST_BYTES], const char *host)
{
    size_t length;
    if (*host == '[') {
        const char *end = strchr(++host, ']');
        if (!end || (end[1] != '\0' && end[1] != ':'))
            return false;
        length = (size_t)(end - host);
    } else {
        length = strcspn(host, ":");
    }
    if (length == 0 || length >= HOST_BYTES)
        return false;
    memcpy(bare, host, length);
    bare[length] = '\0';
    return true;
}

static bool is_number_address(const char *bare)
{
    unsigned char bytes[16];
    return inet_pton(AF_INET, bare, bytes) == 1
           || inet_pton(AF_INET6, bare, bytes) == 1;
}

bool pp_http_guard_host(const struct pp_serve_options *options, const char *host)
{
    static const char *const own[] = {"127.0.0.1", "localhost", "::1"};
    char bare[HOST_BYTES];
    if (!host || !bare_host(bare, host))
        return false;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (strcasecmp(bare, own[i]) == 0)
            return true;
    for (int i = 0; i < options->host_count; i++)
        if (strcasecmp(bare, options->hosts[i]) == 0)
            return true;
    if (options->address && strcmp(bare, options->address) == 0)
        return true;
    return !pp_serve_address_is_loopback(options->address) && is_number_address(bare);
}

bool pp_http_guard_same(const char *wanted, const char *given)
{
    if (!wanted)
        return true;
    size_t length = strlen(wanted), given_length = given ? strlen(given) : 0;
    unsigned char differences = length != given_length;
    for (size_t i = 0; i < length; i++)
        differences |= (unsigned char)(wanted[i] ^ (i < given_length ? given[i] : 0));
    return differences == 0;
}

/* True if host and port of the origin are equal to the Host header. */
static bool is_own_origin(const char *origin, const char *host)
{
    const char *scheme_end = strstr(origin, "://");
    return scheme_end && host && strcasecmp(scheme_end + 3, host) == 0;
}

/* True if the media types are equal; parameters of `given` are ignored. */
static bool is_of_type(const char *given, const char *wanted)
{
    size_t length = strlen(wanted);
    return given && strncasecmp(given, wanted, length) == 0
           && strchr("; \t", given[length]);
}

static const char *bearer(const char *authorization)
{
    static const char scheme[] = "Bearer ";
    return authorization && strncasecmp(authorization, scheme, sizeof scheme - 1) == 0
               ? authorization + sizeof scheme - 1
               : NULL;
}

unsigned pp_http_guard_check(const struct pp_serve_options *options,
                             const struct pp_http_headers *headers,
                             const char *body_type, bool is_page, const char *token,
                             const char **why)
{
    if (!pp_http_guard_host(options, headers->host)) {
        *why = "the server does not accept this Host; start it with --host NAME to "
               "allow it";
        return MHD_HTTP_MISDIRECTED_REQUEST;
    }
    if ((headers->origin && !is_own_origin(headers->origin, headers->host))
        || (!is_page && headers->fetch_site
            && strcmp(headers->fetch_site, "same-origin") != 0
            && strcmp(headers->fetch_site, "none") != 0)) {
        *why = "the request comes from another origin";
        return MHD_HTTP_FORBIDDEN;
    }
    if (!is_page && !pp_http_guard_same(token, bearer(headers->authorization))) {
        *why = "expected the header Authorization: Bearer TOKEN with the token of the "
               "server";
        return MHD_HTTP_UNAUTHORIZED;
    }
    if (body_type && !is_of_type(headers->content_type, body_type)) {
        *why = strcmp(body_type, "application/json") == 0
                   ? "expected Content-Type: application/json"
                   : "expected Content-Type: application/octet-stream";
        return MHD_HTTP_UNSUPPORTED_MEDIA_TYPE;
    }
    return 0;
}
