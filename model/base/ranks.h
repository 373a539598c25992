/* ranks.h - processes that share work, and functions to exchange messages, independent
 * of the transport (MPI, or a test).
 *
 * Only rank 0 reads input, prints and writes.
 */
#ifndef PP_MODEL_BASE_RANKS_H
#define PP_MODEL_BASE_RANKS_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

struct pp_ranks {
    int rank;  /* index of this process, from 0 */
    int count; /* number of processes, 2 or more */

    /* Sends a message without waiting for its arrival. A message to a dead rank is
     * dropped. */
    enum pp_status (*send)(void *data, int to, const void *bytes, size_t length,
                           struct pp_error *err);

    /* Receives a message, if one has arrived: *bytes (freed by the caller), *length
     * bytes, from rank *from; else *bytes is NULL. Does not wait. Messages from one
     * rank arrive in the order of sending. */
    enum pp_status (*receive)(void *data, int *from, char **bytes, size_t *length,
                              struct pp_error *err);

    void *data;
};

#endif
