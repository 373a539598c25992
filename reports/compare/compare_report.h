/* compare_report.h - comparison of another program's values with those of this program,
 * and causes of the differences, as text and as JSON, "pepperpot-compare-1". */
#ifndef PP_REPORTS_COMPARE_COMPARE_REPORT_H
#define PP_REPORTS_COMPARE_COMPARE_REPORT_H

#include <stdio.h>

#include "studies/research/compare/compare.h"

/* Result of the command compare. */
struct pp_compare_result {
    const struct pp_compare_subject *subject; /* not owned */
    const char *other;   /* file with values of the other program; NULL: only values of
                          * this program for a variant */
    const char *variant; /* causes that make the variant, as typed; NULL: no variant */
    int given;           /* number of points in the file */
    const double
        *plain; /* values of this program without the variant, if there is a variant and
                 * no file; not owned */
    const struct pp_cause *const *causes;
    int cause_count;
    struct pp_compared compared; /* if there is no file, only the values of this
                                  * program, their errors and the count are set */
};

/* Advice is given if the noise of the remainder (standard deviation of the logarithm)
 * is at least this. */
#define PP_COMPARE_NOISY 0.015

void pp_compare_report(const struct pp_compare_result *result, int width, FILE *out);

enum pp_status pp_compare_report_json(const struct pp_compare_result *result, FILE *out,
                                      struct pp_error *err);

#endif
