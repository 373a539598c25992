/* gains_report.h - the causes that limit a room's daylight, and the gains from changing
 * them: the end of its assessment. */
#ifndef PP_REPORTS_GAINS_REPORT_H
#define PP_REPORTS_GAINS_REPORT_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "studies/sizing/gains.h"

/* Writes text `width` columns wide (60 or more). */
void pp_gains_report(const struct pp_gains *gains, int width, FILE *out);

/* Adds "gains": { "method", "average", "darkest", "holds_back", "changes": [] }, values
 * in per cent. False: out of memory. */
bool pp_gains_report_json(struct json_object *object, const struct pp_gains *gains);

#endif
