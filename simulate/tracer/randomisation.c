/* randomisation.c - see randomisation.h. */
#include "simulate/tracer/randomisation.h"

#include "model/results/reading.h"
#include "simulate/sampling/hash.h"

static void one_path(struct pp_randomisation *item, struct pp_path_state *state,
                     const struct pp_start *start, enum pp_estimator estimator)
{
    switch (estimator) {
    case PP_DIRECT:
        pp_path_direct(state, start, &item->direct);
        return;
    case PP_GATHER:
        item->gather += pp_path_gather(state, start);
        return;
    default:
        item->correction += pp_path_correction(state, start);
    }
}

void pp_randomisation_run(struct pp_randomisation *item, struct pp_path_state *state,
                          const struct pp_sobol *sobol, const struct pp_start *start,
                          struct pp_counts wanted, uint32_t most)
{
    item->decorations = state->scene->decorations;
    for (int k = 0; k < PP_ESTIMATORS; k++) {
        uint32_t first = item->done.of[k], end = wanted.of[k];
        if (end <= first)
            continue;
        if (end - first > most)
            end = first + most;
        long rays = state->rays, leaks = state->leaks;
        pp_sobol_sequence_init(&state->sequence, sobol,
                               pp_hash(item->seed, (uint64_t)k));
        for (uint32_t i = first; i < end; i++) {
            state->index = i;
            one_path(item, state, start, k);
        }
        item->done.of[k] = end;
        item->rays[k] += state->rays - rays;
        item->leaks += state->leaks - leaks;
    }
}

bool pp_randomisation_is_done(const struct pp_randomisation *item,
                              struct pp_counts wanted)
{
    for (int k = 0; k < PP_ESTIMATORS; k++)
        if (item->done.of[k] < wanted.of[k])
            return false;
    return true;
}

bool pp_randomisation_is_begun(const struct pp_randomisation *item)
{
    return item->done.of[PP_DIRECT] && item->done.of[PP_GATHER]
           && item->done.of[PP_CORRECTION];
}

double pp_randomisation_part(const struct pp_randomisation *item,
                             enum pp_estimator estimator)
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

double pp_randomisation_value(const struct pp_randomisation *item, int component)
{
    double direct = item->done.of[PP_DIRECT];
    double reflected = pp_randomisation_part(item, PP_GATHER)
                       + pp_randomisation_part(item, PP_CORRECTION);
    switch (component) {
    case PP_SC:
    case PP_ERC:
        return item->direct.part[component] / direct;
    case PP_IRC:
        return item->decorations * item->direct.part[PP_IRC] / direct + reflected;
    default:
        return pp_randomisation_part(item, PP_DIRECT) + reflected;
    }
}
