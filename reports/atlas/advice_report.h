/* advice_report.h - which method to use, in words and as JSON. */
#ifndef PP_REPORTS_ATLAS_ADVICE_REPORT_H
#define PP_REPORTS_ATLAS_ADVICE_REPORT_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/parts/json.h"
#include "studies/bands/advice.h"

/* A paragraph for the average and for each group of points. */
void pp_advice_report(const struct pp_advice *advice, const struct pp_report *report,
                      int width, FILE *out);

/* Adds "advice": a list of { "of", "points", "use", "regime", "rooms", "ratio",
 * "formula", "assumption", "others" }, where a ratio is [low, median, high] of truth over
 * figure; or "advice": null and "no-advice": why. False when memory is out. */
bool pp_advice_report_json(struct json_object *object, const struct pp_advice *advice);

#endif
