/* assess_csv.h - results of criteria as CSV, for rooms and for sites. */
#ifndef PP_REPORTS_ASSESS_ASSESS_CSV_H
#define PP_REPORTS_ASSESS_ASSESS_CSV_H

#include "reports/assess/assess_text.h"

/* Writes one finding per line. */
enum pp_status pp_assess_csv(const struct pp_assessments *all, FILE *out,
                             struct pp_error *err);

/* If only rights of light are assessed, writes one line per room of the site, and their
 * sum on the last line. Otherwise like pp_assess_csv. */
enum pp_status pp_assess_csv_of_site(const struct pp_assessments *all, FILE *out,
                                     struct pp_error *err);

#endif
