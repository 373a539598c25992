/* annual_json.h - annual results of rooms as JSON, "pepperpot-annual-1".
 *
 * Daylight autonomy, useful daylight and other fractions are in per cent, illuminances
 * in lx. Most figures are objects with "value" and standard error "se". For a missing
 * figure, "value" is null, and "why" gives the reason.
 */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_JSON_H
#define PP_REPORTS_ANNUAL_ANNUAL_JSON_H

#include <stdio.h>

#include "model/base/error.h"
#include "reports/annual/annual_result.h"

enum pp_status pp_annual_json(const struct pp_annual_results *results, FILE *out,
                              struct pp_error *err);

#endif
