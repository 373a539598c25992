/* randomisation.c - paths followed, and their means by estimator and by component. */
#include "simulate/tracer/randomisation.h"

#include "model/results/reading.h"
#include "simulate/sampling/hash.h"

static void one_path(struct pp_randomisation *randomisation,
                     struct pp_path_state *state, const struct pp_start *start,
                     enum pp_estimator estimator)
{
    switch (estimator) {
    case PP_DIRECT:
        pp_path_direct(state, start, &randomisation->direct);
        return;
    case PP_GATHER:
        randomisation->gather += pp_path_gather(state, start);
        return;
    default:
        randomisation->correction += pp_path_correction(state, start);
    }
}

void pp_randomisation_run(struct pp_randomisation *randomisation,
                          struct pp_path_state *state, const struct pp_sobol *sobol,
                          const struct pp_start *start, struct pp_counts wanted,
                          uint32_t most)
{
    randomisation->decorations = state->scene->decorations;
    for (int k = 0; k < PP_ESTIMATORS; k++) {
        uint32_t first = randomisation->done.of[k], end = wanted.of[k];
        if (end <= first)
            continue;
        if (end - first > most)
            end = first + most;
        long rays = state->rays, leaks = state->leaks;
        pp_sobol_sequence_init(&state->sequence, sobol,
                               pp_hash(randomisation->seed, (uint64_t)k));
        for (uint32_t i = first; i < end; i++) {
            state->index = i;
            one_path(randomisation, state, start, k);
        }
        randomisation->done.of[k] = end;
        randomisation->rays[k] += state->rays - rays;
        randomisation->leaks += state->leaks - leaks;
    }
}

bool pp_randomisation_is_done(const struct pp_randomisation *randomisation,
                              struct pp_counts wanted)
{
    for (int k = 0; k < PP_ESTIMATORS; k++)
        if (randomisation->done.of[k] < wanted.of[k])
            return false;
    return true;
}

bool pp_randomisation_is_begun(const struct pp_randomisation *randomisation)
{
    return randomisation->done.of[PP_DIRECT] && randomisation->done.of[PP_GATHER]
           && randomisation->done.of[PP_CORRECTION];
}

double pp_randomisation_part(const struct pp_randomisation *randomisation,
                             enum pp_estimator estimator)
{
    double n = randomisation->done.of[estimator];
    double D = randomisation->decorations;
    const double *direct = randomisation->direct.part;
    switch (estimator) {
    case PP_DIRECT:
        return (direct[PP_SC] + direct[PP_ERC] + D * direct[PP_IRC]) / n;
    case PP_GATHER:
        return D * randomisation->gather / n;
    default:
        return D * randomisation->correction / n;
    }
}

double pp_randomisation_value(const struct pp_randomisation *randomisation,
                              int component)
{
    double direct = randomisation->done.of[PP_DIRECT];
    double reflected = pp_randomisation_part(randomisation, PP_GATHER)
                       + pp_randomisation_part(randomisation, PP_CORRECTION);
    switch (component) {
    case PP_SC:
    case PP_ERC:
        return randomisation->direct.part[component] / direct;
    case PP_IRC:
        return randomisation->decorations * randomisation->direct.part[PP_IRC] / direct
               + reflected;
    default:
        return pp_randomisation_part(randomisation, PP_DIRECT) + reflected;
    }
}
