/* schedule_file.h - writes the file of assess --schedule, in the format given by the
 * extension of its name. */
#ifndef PP_CLI_ASSESS_SCHEDULE_FILE_H
#define PP_CLI_ASSESS_SCHEDULE_FILE_H

#include "reports/assess/assess_text.h"

/* Checks the file name. PP_BAD_INPUT if it does not end in .csv, .xlsx, .html or
 * .pdf. */
enum pp_status pp_schedule_file_check(const char *path, struct pp_error *err);

/* Writes the schedule of the rooms' windows to the file. On failure no incomplete file
 * is left. PP_BAD_INPUT: neither skylight nor sunlight at windows was assessed, or the
 * format is not available. PP_SYSTEM: the file cannot be written. */
enum pp_status pp_schedule_file_write(const char *path,
                                      const struct pp_assessments *all,
                                      struct pp_error *err);

#endif
