/* http_request.h - callbacks of libmicrohttpd, from the first header of a request to
 * the last byte of its answer. For use inside serve/ only. */
#ifndef PP_SERVE_HTTP_HTTP_REQUEST_H
#define PP_SERVE_HTTP_HTTP_REQUEST_H

#include "serve/server.h"

enum MHD_Result pp_http_request_access(void *server, struct MHD_Connection *connection,
                                       const char *url, const char *method,
                                       const char *version, const char *upload,
                                       size_t *upload_size, void **request);

void pp_http_request_completed(void *server, struct MHD_Connection *connection,
                               void **request, enum MHD_RequestTerminationCode how);

void pp_http_request_connection(void *server, struct MHD_Connection *connection,
                                void **deadline,
                                enum MHD_ConnectionNotificationCode what);

#endif
