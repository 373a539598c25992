/* deal.c - the threads of one process, which enter what they have done in the book. */
#include "model/base/deal.h"

#include "model/base/clock.h"
#include "model/base/deal_book.h"
#include "model/base/deal_ranks.h"
#include "model/base/thread_pool.h"

struct dealing {
    const struct pp_deal *deal;
    struct pp_deal_book *book; /* by one thread at a time: the pool's lock */
    struct pp_thread_pool *pool;
};

/* Pool work: index by index. What is behind one that has failed is not wanted. */
static bool do_index(void *data, int worker, int index)
{
    const struct dealing *dealing = data;
    struct pp_deal_gift gift;
    pp_deal_book_work(dealing->deal, worker, index, &gift);
    pp_thread_pool_lock(dealing->pool);
    pp_deal_book_enter(dealing->book, index, &gift);
    bool more = gift.status == PP_OK && !pp_deal_book_is_over(dealing->book);
    pp_thread_pool_unlock(dealing->pool);
    return more;
}

static enum pp_status run_alone(const struct pp_deal *deal, int *next,
                                struct pp_error *err)
{
    struct dealing dealing = {.deal = deal};
    enum pp_status status = pp_deal_book_create(&dealing.book, deal, err);
    if (status != PP_OK)
        return status;
    status = pp_thread_pool_create(&dealing.pool, deal->threads, err);
    if (status == PP_OK) {
        pp_thread_pool_run(dealing.pool, deal->first, deal->end, do_index, &dealing);
        status = pp_deal_book_end(dealing.book, next, err);
    }
    pp_thread_pool_destroy(dealing.pool);
    pp_deal_book_destroy(dealing.book);
    return status;
}

enum pp_status pp_deal_run(const struct pp_deal *deal, int *next, struct pp_error *err)
{
    *next = deal->first;
    if (!deal->ranks)
        return run_alone(deal, next, err);
    return deal->ranks->rank == 0 ? pp_deal_ranks_lead(deal, next, err)
                                  : pp_deal_ranks_follow(deal, err);
}
