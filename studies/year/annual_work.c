/* annual_work.c - the steps of the computation, and its loops over points. */
#include "studies/year/annual_work.h"

#include <math.h>

bool pp_annual_work_goes_on(void *data, double done)
{
    struct pp_annual_work *work = data;
    const struct pp_watch *watch = &work->options->watch;
    double share = work->begun + done * (work->ended - work->begun);
    if (watch->look && !watch->look(watch->data, share, NAN))
        work->stopped = true;
    return !work->stopped;
}

bool pp_annual_work_next_step(struct pp_annual_work *work, double ended)
{
    work->begun = work->ended;
    work->ended = ended;
    return pp_annual_work_goes_on(work, 0.0);
}

/* Worker 0 is the calling thread, which watches. */
static bool run_block(void *data, int worker, int block)
{
    struct pp_annual_work *work = data;
    if (worker == 0 && !pp_annual_work_goes_on(work, (double)block / work->blocks))
        return false;
    return work->function(work, worker, block);
}

enum pp_status pp_annual_work_for_points(struct pp_annual_work *work, int block,
                                         pp_thread_pool_work *function,
                                         struct pp_error *err)
{
    work->blocks = (work->receiver_count + block - 1) / block;
    work->function = function;
    pp_thread_pool_run(work->pool, 0, work->blocks, run_block, work);
    if (work->stopped)
        return pp_fail(err, PP_INTERRUPTED, "interrupted");
    for (int x = 0; x < work->receiver_count; x++)
        if (work->status[x] == PP_BAD_INPUT)
            return pp_fail(
                err, PP_BAD_INPUT,
                "the outline of the sky seen through an opening has too many corners");
        else if (work->status[x] != PP_OK)
            return pp_fail_memory(err);
    return PP_OK;
}
