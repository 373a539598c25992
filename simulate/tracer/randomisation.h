/* randomisation.h - the unit of work: one randomisation of one point, with the sums of
 * its paths. */
#ifndef PP_SIMULATE_TRACER_RANDOMISATION_H
#define PP_SIMULATE_TRACER_RANDOMISATION_H

#include <stdbool.h>
#include <stdint.h>

#include "simulate/tracer/path.h"

/* The three expectations of path.h. */
enum pp_estimator { PP_DIRECT, PP_GATHER, PP_CORRECTION, PP_ESTIMATORS };

/* Numbers of paths, by estimator. */
struct pp_counts {
    uint32_t of[PP_ESTIMATORS];
};

/* The sums over the paths of one randomisation. */
struct pp_randomisation {
    uint64_t seed;
    struct pp_light direct;
    double gather, correction;
    double decorations; /* the allowance that the reflected component is read with */
    struct pp_counts done;
    long rays[PP_ESTIMATORS];
    long leaks;
};

/* Follows the paths from done to wanted, at most `most` of each, in the order of the
 * sequence: the sums do not depend on how the way there is divided. state: a thread's
 * own, with its scene and radiosity set. */
void pp_randomisation_run(struct pp_randomisation *randomisation,
                          struct pp_path_state *state, const struct pp_sobol *sobol,
                          const struct pp_start *start, struct pp_counts wanted,
                          uint32_t most);

bool pp_randomisation_is_done(const struct pp_randomisation *randomisation,
                              struct pp_counts wanted);

/* Have all three estimators had paths? */
bool pp_randomisation_is_begun(const struct pp_randomisation *randomisation);

/* The mean of one estimator's paths (all components), with the allowance. */
double pp_randomisation_part(const struct pp_randomisation *randomisation,
                             enum pp_estimator estimator);

/* The mean of a component (PP_SC .. PP_DF), of a begun randomisation. */
double pp_randomisation_value(const struct pp_randomisation *randomisation,
                              int component);

#endif
