/* exit_status.h - exit statuses of the program. */
#ifndef PP_CLI_EXIT_STATUS_H
#define PP_CLI_EXIT_STATUS_H

#include "model/base/error.h"

enum pp_exit {
    PP_EXIT_DONE = 0,
    PP_EXIT_INPUT = 1,   /* a file or its data is invalid */
    PP_EXIT_USAGE = 2,   /* the command line is invalid */
    PP_EXIT_MACHINE = 3, /* a system error: disk full, out of memory, no permission */
    PP_EXIT_INTERRUPTED = 130, /* results so far, if printed, are marked as
                                * unfinished */
};

static inline enum pp_exit pp_exit_status_of(enum pp_status status)
{
    switch (status) {
    case PP_OK:
        return PP_EXIT_DONE;
    case PP_BAD_INPUT:
        return PP_EXIT_INPUT;
    case PP_INTERRUPTED:
        return PP_EXIT_INTERRUPTED;
    case PP_SYSTEM:
        break;
    }
    return PP_EXIT_MACHINE;
}

#endif
