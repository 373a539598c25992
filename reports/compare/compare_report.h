/* compare_report.h - another program's values beside ours, and where the difference comes
 * from: as text, and as JSON of format pepperpot-compare-1. */
#ifndef PP_REPORTS_COMPARE_COMPARE_REPORT_H
#define PP_REPORTS_COMPARE_COMPARE_REPORT_H

#include <stdio.h>

#include "reports/compare/compare_result.h"

void pp_compare_report(const struct pp_compare_result *result, int width, FILE *out);

enum pp_status pp_compare_report_json(const struct pp_compare_result *result, FILE *out,
                                      struct pp_error *err);

#endif
