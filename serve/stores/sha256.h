/* sha256.h - the hash that names an uploaded file. Inside serve/ only. */
#ifndef PP_SERVE_STORES_SHA256_H
#define PP_SERVE_STORES_SHA256_H

#include <stddef.h>

/* SHA-256 of FIPS 180-4 in 64 hexadecimal digits, with a 0 behind. */
void pp_sha256_hex(char hex[65], const char *bytes, size_t length);

#endif
