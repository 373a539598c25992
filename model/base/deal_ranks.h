/* deal_ranks.h - a deal over ranks, as rank 0 leads it and as the others follow. */
#ifndef PP_MODEL_BASE_DEAL_RANKS_H
#define PP_MODEL_BASE_DEAL_RANKS_H

#include "model/base/deal.h"

/* Rank 0: deals out to the ranks that ask, and to threads of its own; ends as
 * pp_deal_run does. */
enum pp_status pp_deal_ranks_lead(const struct pp_deal *deal, int *next,
                                  struct pp_error *err);

/* Another rank: asks and works until rank 0 says that it is over, or says nothing any
 * more; then fails with PP_INTERRUPTED. */
enum pp_status pp_deal_ranks_follow(const struct pp_deal *deal, struct pp_error *err);

/* Rank 0: tells all ranks that there is nothing more to be done, should they ask. */
void pp_deal_ranks_dismiss(const struct pp_ranks *ranks);

#endif
