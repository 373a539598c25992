/* gains_report.h - the causes that limit daylight in a room, and the gains from
 * changing them, which are the last part of a room's assessment. */
#ifndef PP_REPORTS_GAINS_REPORT_H
#define PP_REPORTS_GAINS_REPORT_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "studies/sizing/gains.h"

/* Writes text in lines of `width` columns (60 or more). */
void pp_gains_report(const struct pp_gains *gains, int width, FILE *out);

/* Adds "gains": { "method", "average", "darkest", "holds_back", "changes": [] }, with
 * values in per cent. Returns false if memory is exhausted. */
bool pp_gains_report_json(struct json_object *object, const struct pp_gains *gains);

#endif
