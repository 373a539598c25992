/* assess_table_csv.h - rights of light of the rooms of a site as CSV: a room on each line, and
 * their sum on the last. */
#ifndef PP_REPORTS_ASSESS_ASSESS_TABLE_CSV_H
#define PP_REPORTS_ASSESS_ASSESS_TABLE_CSV_H

#include "reports/assess/assess_text.h"

/* Writes a finding on each line, like pp_assess_csv, if other criteria are assessed as
 * well. */
enum pp_status pp_assess_table_csv(const struct pp_assessments *all, FILE *out,
                                   struct pp_error *err);

#endif
