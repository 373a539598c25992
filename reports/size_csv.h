/* size_csv.h - sized windows as CSV, one room per line. Daylight factors are in per
 * cent. */
#ifndef PP_REPORTS_SIZE_CSV_H
#define PP_REPORTS_SIZE_CSV_H

#include "reports/size_report.h"

enum pp_status pp_size_csv(const struct pp_size_results *results, FILE *out,
                           struct pp_error *err);

/* New size: length (m) of the first window that changes, or the number of windows. NAN
 * if there is no result, or nothing changes. */
double pp_size_csv_size(const struct pp_size_room_result *result,
                        enum pp_size_change change);

#endif
