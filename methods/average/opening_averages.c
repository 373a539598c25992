/* opening_averages.c - asks the method for one opening after another, or for several at
 * once. */
#include "methods/average/opening_averages.h"

#include "methods/fast/beams.h"

struct averages {
    struct pp_part *parts;
    const struct pp_method *method;
    struct pp_beams *beams;
    const struct pp_outside_light *light;
    const void *tools;
    struct pp_thread_pool *pool;

    /* The first opening without an average, and what became of it; by the lock. */
    int first;
    enum pp_status status;
    struct pp_error err;
};

static bool average_one(void *data, int worker, int i)
{
    (void)worker;
    struct averages *averages = data;
    struct pp_error err = {0};
    bool known = false;
    enum pp_status status = averages->method->average(
        averages->beams, averages->light, pp_beams_world(averages->beams)->openings + i,
        averages->tools, averages->parts + i, &known, &err);
    if (status == PP_OK && known)
        return true;
    pp_thread_pool_lock(averages->pool);
    if (i < averages->first) {
        averages->first = i;
        averages->status = status;
        averages->err = err;
    }
    pp_thread_pool_unlock(averages->pool);
    return false;
}

enum pp_status pp_opening_averages(struct pp_part *parts, bool *known,
                                   const struct pp_method *method,
                                   struct pp_beams *beams,
                                   const struct pp_outside_light *light,
                                   const void *tools, struct pp_thread_pool *pool,
                                   struct pp_error *err)
{
    int count = pp_beams_world(beams)->opening_count;
    struct averages averages = {parts, method, beams,         light,
                                tools, pool,   .first = count};
    pp_thread_pool_run(pool, 0, count, average_one, &averages);
    *known = averages.first == count;
    return averages.status == PP_OK
               ? PP_OK
               : pp_fail(err, averages.status, "%s", averages.err.message);
}
