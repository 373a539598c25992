/* command_line.h - from the words of a command to the start of its work. */
#ifndef PP_CLI_COMMAND_LINE_H
#define PP_CLI_COMMAND_LINE_H

#include <stdbool.h>

#include "cli/exit_status.h"
#include "cli/options.h"
#include "model/base/error.h"

/* Once the words are read and checked, with what `status` and `err` say, and `files`
 * those that they name: whether the command shall start. If not, its help was printed
 * or its mistake said, and *exit_status is how it ends; if so, *exit_status is
 * PP_EXIT_DONE. */
bool pp_command_line_starts(const struct pp_command_line *line, char **files,
                            int file_count, enum pp_status status, bool wants_help,
                            struct pp_error *err, enum pp_exit *exit_status);

#endif
