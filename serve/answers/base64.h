/* base64.h - bytes as base64 text. Inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_BASE64_H
#define PP_SERVE_ANSWERS_BASE64_H

#include <stddef.h>

/* RFC 4648, section 4, with a 0 behind; the caller frees it. NULL: memory is out. */
char *pp_base64_of(const char *bytes, size_t length);

#endif
