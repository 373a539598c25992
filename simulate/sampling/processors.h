/* processors.h - how many threads may run at once on this machine, and which one this
 * is. */
#ifndef PP_SIMULATE_SAMPLING_PROCESSORS_H
#define PP_SIMULATE_SAMPLING_PROCESSORS_H

#ifdef _OPENMP
#include <omp.h>
#endif

static inline int pp_processors(void)
{
#ifdef _OPENMP
    return omp_get_num_procs();
#else
    return 1;
#endif
}

/* Which of a team's threads this is, from 0. */
static inline int pp_processor(void)
{
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

#endif
