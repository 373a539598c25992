/* df_csv.h - daylight factors of rooms, as CSV. */
#ifndef PP_REPORTS_DF_CSV_H
#define PP_REPORTS_DF_CSV_H

#include <stdio.h>

#include "reports/df_result.h"

/* Writes a header line and one line per value [RFC4180]. Lines end with CR LF. Values
 * are in per cent of the unobstructed horizontal illuminance, with ten significant
 * digits. A missing value is an empty field. */
enum pp_status pp_df_csv(const struct pp_results *results, FILE *out,
                         struct pp_error *err);

#endif
