/* sha256.h - the hash that identifies an uploaded file. Inside serve/ only. */
#ifndef PP_SERVE_STORES_SHA256_H
#define PP_SERVE_STORES_SHA256_H

#include <stddef.h>

/* SHA-256 of FIPS 180-4 as 64 hexadecimal digits and a NUL. */
void pp_sha256_hex(char hex[65], const char *bytes, size_t length);

#endif
