/* common_variance.c - see common_variance.h. */
#include "simulate/estimate/common_variance.h"

#include <stdlib.h>

#include "simulate/estimate/spread.h"

double pp_common_variance_of_all(const struct pp_planner *planner, int count)
{
    struct pp_sampled *list = calloc((size_t)count + 1, sizeof *list);
    if (!list)
        return 1.0; /* on the safe side */
    for (int i = 0; i < count; i++)
        list[i] = pp_planner_sampled(planner, i);
    double common = pp_spread_common(list, count);
    free(list);
    return common;
}

/* The points nearest to one, itself among them; how many there are. */
static int find_nearest(int nearest[PP_COMMON_VARIANCE_NEAREST],
                        const struct pp_vec3 *places, int all, int of)
{
    double away[PP_COMMON_VARIANCE_NEAREST];
    int count = 0;
    for (int i = 0; i < all; i++) {
        double off = pp_vec_length(pp_vec_sub(places[i], places[of]));
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

double pp_common_variance_of_near(const struct pp_planner *planner,
                                  const struct pp_vec3 *places, int count)
{
    enum { ASKED = 500 }; /* points at most, evenly from the list */
    int step = count / ASKED + 1, asked = 0;
    double sum = 0.0;
    for (int i = 0; i < count; i += step) {
        int nearest[PP_COMMON_VARIANCE_NEAREST];
        struct pp_sampled list[PP_COMMON_VARIANCE_NEAREST];
        int near = find_nearest(nearest, places, count, i);
        for (int k = 0; k < near; k++)
            list[k] = pp_planner_sampled(planner, nearest[k]);
        sum += pp_spread_common(list, near);
        asked++;
    }
    return asked ? sum / asked : 0.0;
}
