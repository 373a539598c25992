/* schedule_xlsx.h - the schedule of windows as an Excel workbook, written with
 * libxlsxwriter. */
#ifndef PP_REPORTS_ASSESS_SCHEDULE_XLSX_H
#define PP_REPORTS_ASSESS_SCHEDULE_XLSX_H

#include <stdio.h>

#include "studies/criteria/windows/window_schedule.h"

/* Writes the same columns as in CSV, with losses from 20, 30 and 40 % coloured. The
 * bytes depend on the schedule only. folder: directory for temporary files.
 * PP_BAD_INPUT if the program was built without the library. */
enum pp_status pp_schedule_xlsx(const struct pp_window_schedule *schedule,
                                const char *folder, FILE *out, struct pp_error *err);

#endif
