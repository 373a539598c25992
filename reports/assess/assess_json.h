/* assess_json.h - assessments of rooms, as JSON of format pepperpot-assess-1. */
#ifndef PP_REPORTS_ASSESS_ASSESS_JSON_H
#define PP_REPORTS_ASSESS_ASSESS_JSON_H

#include <stdio.h>

#include "reports/assess/assess_text.h"

/* Writes one object per room ("pepperpot-assess-1"), an array of them for several
 * rooms. */
enum pp_status pp_assess_json(const struct pp_assessments *assessments, FILE *out,
                              struct pp_error *err);

#endif
