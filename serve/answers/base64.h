/* base64.h - bytes as base64 text. Inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_BASE64_H
#define PP_SERVE_ANSWERS_BASE64_H

#include <stddef.h>

/* Encodes bytes by RFC 4648, section 4. Returns a NUL-terminated string that the caller
 * frees; NULL: out of memory. */
char *pp_base64_of(const char *bytes, size_t length);

#endif
