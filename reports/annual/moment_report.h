/* moment_report.h - the illuminances of rooms at one moment, as text, JSON and CSV.
 *
 * Argument `when`: the time as typed; NULL: the position of the sun was given instead.
 *
 * The JSON format is that of df, "pepperpot-df-1", with components in lux. Daylight
 * factors are omitted, since they are defined only for standard skies.
 */
#ifndef PP_REPORTS_ANNUAL_MOMENT_REPORT_H
#define PP_REPORTS_ANNUAL_MOMENT_REPORT_H

#include <stdio.h>

#include "model/base/error.h"
#include "reports/annual/annual_result.h"

enum pp_status pp_moment_report_text(const struct pp_annual_results *results,
                                     const char *when, int width, FILE *out,
                                     struct pp_error *err);
enum pp_status pp_moment_report_json(const struct pp_annual_results *results,
                                     const char *when, FILE *out, struct pp_error *err);
enum pp_status pp_moment_report_csv(const struct pp_annual_results *results,
                                    const char *when, FILE *out, struct pp_error *err);

#endif
