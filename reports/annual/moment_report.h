/* moment_report.h - the illuminances of rooms at one moment, as text, JSON and CSV.
 *
 * when: the time as typed; NULL: the sun was given without a time.
 *
 * JSON has the format of df, "pepperpot-df-1", with components in lux. It has no
 * daylight factors, which are defined for standard skies only.
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
