/* df_json.h - daylight factors of rooms as JSON, "pepperpot-df-1". */
#ifndef PP_REPORTS_DF_JSON_H
#define PP_REPORTS_DF_JSON_H

#include <stdio.h>

#include "reports/df_result.h"

/* Writes one object, or for several rooms an array with one object per room. Values are
 * in per cent of the unobstructed horizontal illuminance, with ten significant
 * digits. */
enum pp_status pp_df_json(const struct pp_results *results, FILE *out,
                          struct pp_error *err);

#endif
