/* item.c - see item.h. */
#include "simulate/tracer/item.h"

#include "model/results/reading.h"
#include "simulate/sampling/hash.h"

static void one_path(struct pp_item *item, struct pp_walk *walk,
                     const struct pp_start *start, enum pp_estimator estimator)
{
    switch (estimator) {
    case PP_DIRECT:
        pp_path_direct(walk, start, &item->direct);
        return;
    case PP_GATHER:
        item->gather += pp_path_gather(walk, start);
        return;
    default:
        item->correction += pp_path_correction(walk, start);
    }
}

void pp_item_run(struct pp_item *item, struct pp_walk *walk,
                 const struct pp_sobol *sobol, const struct pp_start *start,
                 struct pp_counts wanted, uint32_t most)
{
    item->decorations = walk->scene->decorations;
    for (int k = 0; k < PP_ESTIMATORS; k++) {
        uint32_t first = item->done.of[k], end = wanted.of[k];
        if (end <= first)
            continue;
        if (end - first > most)
            end = first + most;
        long rays = walk->rays, leaks = walk->leaks;
        pp_sequence_init(&walk->sequence, sobol, pp_hash(item->seed, (uint64_t)k));
        for (uint32_t i = first; i < end; i++) {
            walk->index = i;
            one_path(item, walk, start, k);
        }
        item->done.of[k] = end;
        item->rays[k] += walk->rays - rays;
        item->leaks += walk->leaks - leaks;
    }
}

bool pp_item_is_done(const struct pp_item *item, struct pp_counts wanted)
{
    for (int k = 0; k < PP_ESTIMATORS; k++)
        if (item->done.of[k] < wanted.of[k])
            return false;
    return true;
}

bool pp_item_is_begun(const struct pp_item *item)
{
    return item->done.of[PP_DIRECT] && item->done.of[PP_GATHER]
           && item->done.of[PP_CORRECTION];
}

double pp_item_part(const struct pp_item *item, enum pp_estimator estimator)
{
    double n = item->done.of[estimator];
    double D = item->decorations;
    const double *direct = item->direct.part;
    switch (estimator) {
    case PP_DIRECT:
        return (direct[PP_SC] + direct[PP_ERC] + D * direct[PP_IRC]) / n;
    case PP_GATHER:
        return D * item->gather / n;
    default:
        return D * item->correction / n;
    }
}

double pp_item_value(const struct pp_item *item, int component)
{
    double direct = item->done.of[PP_DIRECT];
    double reflected =
        pp_item_part(item, PP_GATHER) + pp_item_part(item, PP_CORRECTION);
    switch (component) {
    case PP_SC:
    case PP_ERC:
        return item->direct.part[component] / direct;
    case PP_IRC:
        return item->decorations * item->direct.part[PP_IRC] / direct + reflected;
    default:
        return pp_item_part(item, PP_DIRECT) + reflected;
    }
}
