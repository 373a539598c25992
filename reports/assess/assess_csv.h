/* assess_csv.h - results of criteria as CSV, of rooms and of sites. */
#ifndef PP_REPORTS_ASSESS_ASSESS_CSV_H
#define PP_REPORTS_ASSESS_ASSESS_CSV_H

#include "reports/assess/assess_text.h"

/* A finding on each line. */
enum pp_status pp_assess_csv(const struct pp_assessments *all, FILE *out,
                             struct pp_error *err);

/* Rights of light of the rooms of a site, if nothing else is assessed: a room on each line,
 * and their sum on the last. Else as pp_assess_csv. */
enum pp_status pp_assess_csv_of_site(const struct pp_assessments *all, FILE *out,
                                     struct pp_error *err);

#endif
