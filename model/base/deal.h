/* deal.h - numbered work, dealt out to threads and to other processes; what it gives, as
 * bytes, is taken in the order of the numbers.
 *
 * The bytes of an index depend on nothing but the index, so that what is taken is the
 * same for any number of threads and ranks, whoever has done what, and however often.
 * Hence nobody waits for a rank that has fallen silent: what it had is dealt out again
 * when there is nothing else to do.
 *
 * Over ranks (ranks.h) rank 0 deals out chunks, works too, and alone takes. The others
 * come, with the same `work`, to the same call, which ends for them as interrupted: what
 * follows it is rank 0's. A process may deal over ranks once.
 */
#ifndef PP_MODEL_BASE_DEAL_H
#define PP_MODEL_BASE_DEAL_H

#include "model/base/ranks.h"

struct pp_deal {
    int first, end; /* indices: first, first + 1, ... up to end, which is not of them */
    int threads;    /* of this process, at one index each; 0: one for each processor;
                     * over ranks: one */

    /* Works out an index: *bytes, from malloc, and their number. By several threads at a
     * time; `worker`, from 0, is who of them. */
    enum pp_status (*work)(void *data, int worker, int index, char **bytes,
                           size_t *length, struct pp_error *err);

    /* Takes what an index gave, in the order of the indices, by one thread at a time. */
    enum pp_status (*take)(void *data, int index, const char *bytes, size_t length,
                           struct pp_error *err);

    /* Is it to go on? `done`: share of the indices that were taken. Between two indices,
     * by one thread at a time; NULL: it is. */
    bool (*look)(void *data, double done);

    void *data;
    const struct pp_ranks *ranks; /* not owned; NULL: this process alone */
};

/* Deals. *next is the index after the last that was taken, also where it fails or is
 * stopped: all before it have been taken. An index that fails ends it once all before
 * have been taken; of several that fail the first one's error is returned. */
enum pp_status pp_deal_run(const struct pp_deal *deal, int *next, struct pp_error *err);

#endif
