/* annual_csv.h - annual results of rooms as CSV: one line for each point, one for the
 * average, and one for each control of the electric light. Most figures have two
 * columns: value and standard error. */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_CSV_H
#define PP_REPORTS_ANNUAL_ANNUAL_CSV_H

#include <stdio.h>

#include "model/base/error.h"
#include "reports/annual/annual_result.h"

enum pp_status pp_annual_csv(const struct pp_annual_results *results, FILE *out,
                             struct pp_error *err);

#endif
