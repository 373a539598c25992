/* compare_report.h - the comparison of another program's values with ours and the
 * causes of the differences, as text and as JSON of format pepperpot-compare-1. */
#ifndef PP_REPORTS_COMPARE_COMPARE_REPORT_H
#define PP_REPORTS_COMPARE_COMPARE_REPORT_H

#include <stdio.h>

#include "studies/research/compare/compare.h"

/* Result of compare. */
struct pp_compare_result {
    const struct pp_compare_subject *subject; /* not owned */
    const char *other;   /* file with the other program's values; NULL: only ours, with
                          * a variant */
    const char *variant; /* switches of the variant; NULL: no variant */
    int given;           /* number of points in the file */
    const double
        *plain; /* our values without the variant, if there is a variant and no file;
                 * not owned */
    const struct pp_cause *const *causes;
    int cause_count;
    struct pp_compared compared; /* without a file only our values, their errors and the
                                  * count are set */
};

/* Least noise of the remainder (standard deviation of the logarithm) for which advice
 * is given. */
#define PP_COMPARE_NOISY 0.015

void pp_compare_report(const struct pp_compare_result *result, int width, FILE *out);

enum pp_status pp_compare_report_json(const struct pp_compare_result *result, FILE *out,
                                      struct pp_error *err);

#endif
