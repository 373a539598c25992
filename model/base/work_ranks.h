/* work_ranks.h - a work queue over ranks: rank 0 leads, the others follow. */
#ifndef PP_MODEL_BASE_WORK_RANKS_H
#define PP_MODEL_BASE_WORK_RANKS_H

#include "model/base/work_queue.h"

/* Leads the queue on rank 0: assigns work to its threads and to ranks that ask. Returns
 * like pp_work_queue_run. */
enum pp_status pp_work_ranks_lead(const struct pp_work_queue *queue, int *next,
                                  struct pp_error *err);

/* Runs another rank: requests and computes work until rank 0 has no more or does not
 * answer; then fails with PP_INTERRUPTED. */
enum pp_status pp_work_ranks_follow(const struct pp_work_queue *queue,
                                    struct pp_error *err);

/* Tells all ranks that no work is left; rank 0 only. */
void pp_work_ranks_dismiss(const struct pp_ranks *ranks);

#endif
