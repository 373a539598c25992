/* stop.h - lets a calculation be stopped from outside, for instance when nobody waits
 * for its result any more. Calculations that may take long check the condition between
 * their steps, and then fail with PP_INTERRUPTED. */
#ifndef PP_MODEL_BASE_STOP_H
#define PP_MODEL_BASE_STOP_H

#include "model/base/error.h"

/* A condition; called from several threads at once. came NULL: never. */
struct pp_stop {
    bool (*came)(void *data);
    void *data;
};

/* PP_INTERRUPTED if the condition holds, else PP_OK. */
static inline enum pp_status pp_stop_check(struct pp_stop stop, struct pp_error *err)
{
    return stop.came && stop.came(stop.data)
               ? pp_fail(err, PP_INTERRUPTED, "interrupted")
               : PP_OK;
}

#endif
