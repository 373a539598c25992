/* advice_report.h - recommended methods, as text and as JSON. */
#ifndef PP_REPORTS_ATLAS_ADVICE_REPORT_H
#define PP_REPORTS_ATLAS_ADVICE_REPORT_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/parts/json.h"
#include "studies/bands/advice.h"

/* Prints a paragraph for the average and for each group of points. */
void pp_advice_report(const struct pp_advice *advice, const struct pp_report *report,
                      int width, FILE *out);

/* Adds "advice": a list of { "of", "points", "use", "corrected", "regime", "rooms",
 * "ratio", "formula", "assumption", "others" }, where "ratio" is [low, median, high] of
 * the simulated value divided by the method's value. If there is no advice, adds
 * "advice": null and the reason, "no-advice". Returns false if memory is exhausted. */
bool pp_advice_report_json(struct json_object *object, const struct pp_advice *advice);

#endif
