/* schedule_file.h - writes the file of assess --schedule, in the format that the ending
 * of its name selects. */
#ifndef PP_CLI_ASSESS_SCHEDULE_FILE_H
#define PP_CLI_ASSESS_SCHEDULE_FILE_H

#include "reports/assess/assess_text.h"

/* PP_BAD_INPUT if the name does not end in .csv, .xlsx, .html or .pdf. */
enum pp_status pp_schedule_file_check(const char *path, struct pp_error *err);

/* Writes the schedule of the rooms' windows to that file, complete or not at all.
 * PP_BAD_INPUT: no skylight or sunlight at windows was assessed, or the format is not
 * available; PP_SYSTEM: the file cannot be written. */
enum pp_status pp_schedule_file_write(const char *path,
                                      const struct pp_assessments *all,
                                      struct pp_error *err);

#endif
