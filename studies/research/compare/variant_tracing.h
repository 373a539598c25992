/* variant_tracing.h - how values as if are traced, and who is asked on the way. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_TRACING_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_TRACING_H

#include <stdbool.h>
#include <stdint.h>

struct pp_variant_tracing {
    double error; /* wanted standard error over value, above 0 */
    uint64_t seed;
    int threads;                           /* 0: as many as there are processors */
    bool (*look)(void *data, double done); /* go on? done: 0 to 1; NULL: nobody asks */
    void *data;
};

#endif
