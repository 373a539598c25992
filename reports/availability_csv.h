/* availability_csv.h - availability of daylight, as CSV. */
#ifndef PP_REPORTS_AVAILABILITY_CSV_H
#define PP_REPORTS_AVAILABILITY_CSV_H

#include <stdio.h>

#include "reports/availability_result.h"

/* Writes one line for each place, method, illuminance and period, as CSV [RFC4180]. */
enum pp_status pp_availability_csv(const struct pp_availability_results *results,
                                   FILE *out, struct pp_error *err);

#endif
