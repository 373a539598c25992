/* validate_report.h - results of `validate` for rooms, as text, JSON and CSV. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_REPORT_H
#define PP_REPORTS_VALIDATE_VALIDATE_REPORT_H

#include <stdio.h>

#include "studies/research/validation/comparison.h"
#include "reports/df_result.h"

/* Rooms with their comparisons, and the comparison over all rooms. */
struct pp_validation {
    const struct pp_results *results;
    struct pp_comparison **rooms; /* one list of comparisons for each result */
    int *counts;
    struct pp_overall *overall;
    int overall_count;
};

void pp_validate_report_rooms(const struct pp_validation *validation, int width,
                              FILE *out);
enum pp_status pp_validate_report_rooms_json(const struct pp_validation *validation,
                                             FILE *out, struct pp_error *err);
void pp_validate_report_rooms_csv(const struct pp_validation *validation, FILE *out);

#endif
