/* sha256.h - SHA-256 hash, which identifies an uploaded file. For use inside serve/
 * only. */
#ifndef PP_SERVE_STORES_SHA256_H
#define PP_SERVE_STORES_SHA256_H

#include <stddef.h>

/* Writes the SHA-256 hash (FIPS 180-4) as 64 hexadecimal digits and a null
 * character. */
void pp_sha256_hex(char hex[65], const char *bytes, size_t length);

#endif
