/* compare_result.h - results of compare, for its reports. */
#ifndef PP_REPORTS_COMPARE_COMPARE_RESULT_H
#define PP_REPORTS_COMPARE_COMPARE_RESULT_H

#include "studies/research/compare/compare.h"

struct pp_compare_result {
    const struct pp_compare_subject *subject; /* not owned */
    const char *other;   /* the other program's file; NULL: ours alone, as if */
    const char *variant; /* words; NULL: none */
    int given;           /* how many points the file has */
    const double
        *plain; /* ours as they are, with variant and without a file; not owned */
    const struct pp_cause *const *causes;
    int cause_count;
    struct pp_compared compared; /* without a file: ours, errors and count alone */
};

/* Noise of the remainder (logarithm) from which advice about it is given. */
#define PP_COMPARE_NOISY 0.015

#endif
