/* schedule_xlsx.h - the schedule of windows as an Excel workbook, written with
 * libxlsxwriter. */
#ifndef PP_REPORTS_ASSESS_SCHEDULE_XLSX_H
#define PP_REPORTS_ASSESS_SCHEDULE_XLSX_H

#include <stdio.h>

#include "studies/criteria/windows/window_schedule.h"

/* Writes the columns of the CSV schedule without `file` and `sun_hours`, and the
 * cumulative columns only if there is a cumulative state. Losses are coloured in bands
 * that begin at 20, 30 and 40 %. Equal schedules give equal bytes. folder: directory
 * for temporary files. PP_BAD_INPUT if the program was built without the library. */
enum pp_status pp_schedule_xlsx(const struct pp_window_schedule *schedule,
                                const char *folder, FILE *out, struct pp_error *err);

#endif
