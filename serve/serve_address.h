/* serve_address.h - who can reach an address. */
#ifndef PP_SERVE_SERVE_ADDRESS_H
#define PP_SERVE_SERVE_ADDRESS_H

#include <stdbool.h>

/* Is it an address of this machine alone? NULL is 127.0.0.1. */
bool pp_serve_address_is_loopback(const char *address);

#endif
