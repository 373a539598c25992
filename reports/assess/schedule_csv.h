/* schedule_csv.h - the schedule of windows as CSV. Fractions are in per cent, except
 * ratios; areas are in m2. */
#ifndef PP_REPORTS_ASSESS_SCHEDULE_CSV_H
#define PP_REPORTS_ASSESS_SCHEDULE_CSV_H

#include <stdio.h>

#include "studies/criteria/windows/window_schedule.h"

void pp_schedule_csv(const struct pp_window_schedule *schedule, FILE *out);

#endif
