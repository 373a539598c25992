/* ranks.h - processes that work at one thing, and the way in which they write to one
 * another, as functions: what brings the messages (MPI, or a test) is not known here.
 *
 * Rank 0 is the one that the user sees: it alone takes, prints and writes.
 */
#ifndef PP_MODEL_BASE_RANKS_H
#define PP_MODEL_BASE_RANKS_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

struct pp_ranks {
    int rank;  /* this process, from 0 */
    int count; /* of processes, 2 or more */

    /* Sends a message; does not wait until it has arrived. To who is dead: nothing. */
    enum pp_status (*send)(void *data, int to, const void *bytes, size_t length,
                           struct pp_error *err);

    /* A message that has come, if there is one: *bytes, which are the caller's to free,
     * *length of them, by *from; else *bytes is NULL. Does not wait. Messages by one
     * rank come in the order in which they were sent. */
    enum pp_status (*receive)(void *data, int *from, char **bytes, size_t *length,
                              struct pp_error *err);

    void *data;
};

#endif
