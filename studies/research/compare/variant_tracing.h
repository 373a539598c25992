/* variant_tracing.h - options for the simulation of variants, and its progress
 * callback. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_TRACING_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_TRACING_H

#include <stdbool.h>
#include <stdint.h>

struct pp_variant_tracing {
    double error; /* target standard error over value, above 0 */
    uint64_t seed;
    int threads;                           /* 0: one for each processor */
    bool (*look)(void *data, double done); /* returns whether to continue; done: 0 to 1;
                                            * NULL: not called */
    void *data;
};

#endif
