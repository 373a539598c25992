/* serve_address.c - see serve_address.h. */
#include "serve/serve_address.h"

#include <arpa/inet.h>
#include <stddef.h>
#include <string.h>

bool pp_serve_address_is_loopback(const char *address)
{
    unsigned char bytes[4];
    if (!address || strcmp(address, "::1") == 0)
        return true;
    return inet_pton(AF_INET, address, bytes) == 1 && bytes[0] == 127;
}
