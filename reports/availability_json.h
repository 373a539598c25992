/* availability_json.h - availability of daylight as JSON,
 * "pepperpot-availability-1". */
#ifndef PP_REPORTS_AVAILABILITY_JSON_H
#define PP_REPORTS_AVAILABILITY_JSON_H

#include <stdio.h>

#include "reports/availability_result.h"

/* Writes one object, or for several rooms an array with one object per room. */
enum pp_status pp_availability_json(const struct pp_availability_results *results,
                                    FILE *out, struct pp_error *err);

#endif
