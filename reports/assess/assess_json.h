/* assess_json.h - assessments of rooms, as JSON of format pepperpot-assess-1. */
#ifndef PP_REPORTS_ASSESS_ASSESS_JSON_H
#define PP_REPORTS_ASSESS_ASSESS_JSON_H

#include <stdio.h>

#include "reports/assess/assess_text.h"

/* Writes one object ("pepperpot-assess-1"), or for several rooms an array with one
 * object per room. */
enum pp_status pp_assess_json(const struct pp_assessments *assessments, FILE *out,
                              struct pp_error *err);

#endif
