/* commands.h - the commands of the program; main.c has the list.
 *
 * Each gets its own words (argv[0] is its name), prints, and returns the exit status.
 */
#ifndef PP_CLI_COMMANDS_H
#define PP_CLI_COMMANDS_H

#include "cli/exit_status.h"

typedef enum pp_exit pp_command(int argc, char **argv);

pp_command cmd_df;
pp_command cmd_size;
pp_command cmd_chart;
pp_command cmd_render;
pp_command cmd_assess;
pp_command cmd_availability;
pp_command cmd_export;
pp_command cmd_import;
pp_command cmd_validate;

#endif
