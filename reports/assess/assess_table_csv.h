/* assess_table_csv.h - rights of light of the rooms of a site as CSV: a room on each line, and
 * their sum on the last. */
#ifndef PP_REPORTS_ASSESS_ASSESS_TABLE_CSV_H
#define PP_REPORTS_ASSESS_ASSESS_TABLE_CSV_H

#include "reports/assess/assess_text.h"

/* Where something else is judged too, a finding on each line, as pp_assess_csv. */
enum pp_status pp_assess_table_csv(const struct pp_assessments *all, FILE *out,
                                   struct pp_error *err);

#endif
