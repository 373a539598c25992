#include "cli/command_line.h"

#include <stdio.h>

#include "cli/command_files.h"
#include "cli/message.h"

bool pp_command_line_starts(const struct pp_command_line *line, char **files,
                            int file_count, enum pp_status status, bool wants_help,
                            struct pp_error *err, enum pp_exit *exit_status)
{
    *exit_status = PP_EXIT_DONE;
    if (status == PP_OK && !wants_help)
        status = pp_command_files_apart(line, files, file_count, err);
    if (status == PP_SYSTEM)
        *exit_status = pp_message_error(err);
    else if (status != PP_OK)
        *exit_status = pp_message_usage(line->command, err);
    else if (wants_help)
        pp_options_help(line, stdout);
    return status == PP_OK && !wants_help;
}
