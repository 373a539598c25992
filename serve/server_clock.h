/* server_clock.h - a clock for waiting. For use inside serve/ only. */
#ifndef PP_SERVE_SERVER_CLOCK_H
#define PP_SERVE_SERVER_CLOCK_H

#include <time.h>

/* Seconds since an arbitrary moment; never set back. */
static inline double pp_server_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
