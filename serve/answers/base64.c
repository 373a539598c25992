/* base64.c - see base64.h. */
#include "serve/answers/base64.h"

#include <stdlib.h>

char *pp_base64_of(const char *bytes, size_t length)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    char *text = malloc(4 * ((length + 2) / 3) + 1), *at = text;
    for (size_t i = 0; text && i < length; i += 3) {
        unsigned block = 0;
        for (size_t k = 0; k < 3; k++)
            block = block << 8 | (i + k < length ? (unsigned char)bytes[i + k] : 0u);
        for (size_t k = 0; k < 4; k++)
            *at++ = i + k > length ? '=' : letters[block >> (18 - 6 * k) & 63];
    }
    if (text)
        *at = '\0';
    return text;
}
