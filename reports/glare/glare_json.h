/* glare_json.h - daylight glare probability of rooms as JSON, in the format
 * "pepperpot-glare-1". */
#ifndef PP_REPORTS_GLARE_GLARE_JSON_H
#define PP_REPORTS_GLARE_GLARE_JSON_H

#include "reports/glare/glare_report.h"

enum pp_status pp_glare_json(const struct pp_glare_results *results, FILE *out,
                             struct pp_error *err);

#endif
