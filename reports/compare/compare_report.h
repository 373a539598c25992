/* compare_report.h - another program's values beside ours, and where the difference comes
 * from: as text, and as JSON of format pepperpot-compare-1. */
#ifndef PP_REPORTS_COMPARE_COMPARE_REPORT_H
#define PP_REPORTS_COMPARE_COMPARE_REPORT_H

#include <stdio.h>

#include "studies/research/compare/compare.h"

/* Result of compare. */
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

/* Noise (logarithm) of what is left from which something is to be done about it. */
#define PP_COMPARE_NOISY 0.015

void pp_compare_report(const struct pp_compare_result *result, int width, FILE *out);

enum pp_status pp_compare_report_json(const struct pp_compare_result *result, FILE *out,
                                      struct pp_error *err);

#endif
