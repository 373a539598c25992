/* serve_address.h - checks whether an address can be reached from other machines. */
#ifndef PP_SERVE_SERVE_ADDRESS_H
#define PP_SERVE_SERVE_ADDRESS_H

#include <stdbool.h>

/* True if the address can be reached only from this machine. NULL means 127.0.0.1. */
bool pp_serve_address_is_loopback(const char *address);

#endif
