/* planner_options.c - options within their ranges. */
#include "simulate/estimate/planner_options.h"

#include "simulate/estimate/plan.h"

enum pp_status pp_planner_options_check(const struct pp_planner_options *options,
                                        struct pp_error *err)
{
    if (!(options->error >= 0.0 && options->error <= 1.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "a standard error of %g cannot be aimed at; expected a fraction "
                       "from 0 to 1",
                       options->error);
    if (options->samples < 0 || options->samples > PP_MOST_PATHS)
        return pp_fail(err, PP_BAD_INPUT,
                       "%ld samples a point are not possible; expected up to %d",
                       options->samples, (int)PP_MOST_PATHS);
    if (options->threads < 0)
        return pp_fail(err, PP_BAD_INPUT, "%d threads are not possible",
                       options->threads);
    return PP_OK;
}
