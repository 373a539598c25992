/* common_variance.c - see common_variance.h. */
#include "simulate/estimate/common_variance.h"

#include <stdlib.h>

#include "simulate/estimate/spread.h"

double pp_common_variance_of_all(const struct pp_planner *planner, int count)
{
    struct pp_sampled *list = calloc((size_t)count + 1, sizeof *list);
    if (!list)
        return 1.0; /* out of memory: full correlation, the conservative value */
    for (int i = 0; i < count; i++)
        list[i] = pp_planner_sampled(planner, i);
    double common = pp_spread_common(list, count);
    free(list);
    return common;
}

/* Context for evaluating every step-th point with its nearest neighbours. */
struct neighbourhood {
    const struct pp_planner *planner;
    const struct pp_vec3 *places;
    int count, step; /* every step-th of `count` points is evaluated */
    double *common;  /* factors of the evaluated points */
};

/* Finds the points nearest to point `index`, including the point itself; returns their
 * number. */
static int find_nearest(int nearest[PP_COMMON_VARIANCE_NEAREST],
                        const struct neighbourhood *of, int index)
{
    double away[PP_COMMON_VARIANCE_NEAREST]; /* squared */
    int count = 0;
    for (int i = 0; i < of->count; i++) {
        struct pp_vec3 between = pp_vec_sub(of->places[i], of->places[index]);
        double off = pp_vec_dot(between, between);
        int at = count;
        for (; at > 0 && off < away[at - 1]; at--)
            if (at < PP_COMMON_VARIANCE_NEAREST) {
                away[at] = away[at - 1];
                nearest[at] = nearest[at - 1];
            }
        if (at == PP_COMMON_VARIANCE_NEAREST)
            continue;
        away[at] = off;
        nearest[at] = i;
        count += count < PP_COMMON_VARIANCE_NEAREST;
    }
    return count;
}

static bool ask(void *data, int worker, int index)
{
    (void)worker;
    const struct neighbourhood *of = data;
    int nearest[PP_COMMON_VARIANCE_NEAREST];
    struct pp_sampled list[PP_COMMON_VARIANCE_NEAREST];
    int near = find_nearest(nearest, of, index * of->step);
    for (int k = 0; k < near; k++)
        list[k] = pp_planner_sampled(of->planner, nearest[k]);
    of->common[index] = pp_spread_common(list, near);
    return true;
}

double pp_common_variance_of_near(const struct pp_planner *planner,
                                  const struct pp_vec3 *places, int count)
{
    enum { ASKED = 500 }; /* most points evaluated, evenly spaced in the list */
    int step = count / ASKED + 1, asked = (count + step - 1) / step;
    struct neighbourhood of = {planner, places, count, step,
                               calloc((size_t)asked + 1, sizeof *of.common)};
    if (!of.common)
        return 1.0; /* out of memory: full correlation, the conservative value */
    pp_thread_pool_run(pp_planner_crew(planner), 0, asked, ask, &of);
    double sum = 0.0;
    for (int i = 0; i < asked; i++)
        sum += of.common[i];
    free(of.common);
    return asked ? sum / asked : 0.0;
}
