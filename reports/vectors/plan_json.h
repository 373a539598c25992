/* plan_json.h - contours and no-sky line of a plan as JSON, for programs that draw
 * them. */
#ifndef PP_REPORTS_VECTORS_PLAN_JSON_H
#define PP_REPORTS_VECTORS_PLAN_JSON_H

#include <stdio.h>

#include "studies/plan_study.h"

/* Prints one object, "pepperpot-plan-1". Lengths are in metres, levels in per cent. */
enum pp_status pp_plan_json(const struct pp_plan_study *study, FILE *out,
                            struct pp_error *err);

#endif
