/* assess_csv.h - rooms held against the criteria, a finding on each line of a CSV. */
#ifndef PP_REPORTS_ASSESS_ASSESS_CSV_H
#define PP_REPORTS_ASSESS_ASSESS_CSV_H

#include "reports/assess/assess_text.h"

enum pp_status pp_assess_csv(const struct pp_assessments *all, FILE *out,
                             struct pp_error *err);

#endif
