/* work_ranks.h - a work queue over ranks: rank 0 leads, the others follow. */
#ifndef PP_MODEL_BASE_WORK_RANKS_H
#define PP_MODEL_BASE_WORK_RANKS_H

#include "model/base/work_queue.h"

/* Rank 0: assigns work to ranks that ask, and to its own threads; ends as
 * pp_work_queue_run does. */
enum pp_status pp_work_ranks_lead(const struct pp_work_queue *queue, int *next,
                                  struct pp_error *err);

/* Runs another rank: requests work and does it, until rank 0 has no more or is silent;
 * then fails with PP_INTERRUPTED. */
enum pp_status pp_work_ranks_follow(const struct pp_work_queue *queue,
                                    struct pp_error *err);

/* Rank 0: sends all ranks the message that no work is left. */
void pp_work_ranks_dismiss(const struct pp_ranks *ranks);

#endif
