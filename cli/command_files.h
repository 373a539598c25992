/* command_files.h - the files that a command line names, told apart. */
#ifndef PP_CLI_COMMAND_FILES_H
#define PP_CLI_COMMAND_FILES_H

#include "cli/options.h"
#include "model/base/error.h"

/* Is no file that the options write another one of theirs, or one of the files that are
 * read? PP_BAD_INPUT if one is, whatever it is called the second time. files: those of
 * the operands. Options are known by their readers: pp_options_read_output and pp_options_read_updated
 * write, pp_options_read_input reads. */
enum pp_status pp_command_files_apart(const struct pp_command_line *line, char **files,
                                      int file_count, struct pp_error *err);

#endif
