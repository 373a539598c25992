/* base64.h - encodes bytes as base64 text. For use inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_BASE64_H
#define PP_SERVE_ANSWERS_BASE64_H

#include <stddef.h>

/* Encodes bytes according to RFC 4648, section 4. Returns a null-terminated string,
 * which the caller frees. NULL: out of memory. */
char *pp_base64_of(const char *bytes, size_t length);

#endif
