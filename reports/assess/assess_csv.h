/* assess_csv.h - findings of criteria as CSV, for rooms and for sites. */
#ifndef PP_REPORTS_ASSESS_ASSESS_CSV_H
#define PP_REPORTS_ASSESS_ASSESS_CSV_H

#include "reports/assess/assess_text.h"

/* Writes one finding per line. */
enum pp_status pp_assess_csv(const struct pp_assessments *all, FILE *out,
                             struct pp_error *err);

/* Writes the findings of a site. If only rights of light are assessed, writes one line
 * per room and a last line with the sum. Otherwise like pp_assess_csv. */
enum pp_status pp_assess_csv_of_site(const struct pp_assessments *all, FILE *out,
                                     struct pp_error *err);

#endif
