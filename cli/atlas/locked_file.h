/* locked_file.h - a file that grows during a run, which only one run can have open. */
#ifndef PP_CLI_ATLAS_LOCKED_FILE_H
#define PP_CLI_ATLAS_LOCKED_FILE_H

#include <stdio.h>

#include "model/base/error.h"

/* Opens the file for reading and writing, at its beginning, and creates it if it does not
 * exist. On success the caller closes *stream. */
enum pp_status pp_locked_file_open(FILE **stream, const char *path,
                                   struct pp_error *err);

#endif
