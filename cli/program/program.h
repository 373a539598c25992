/* program.h - a program of commands, from its words to its exit status. */
#ifndef PP_CLI_PROGRAM_PROGRAM_H
#define PP_CLI_PROGRAM_PROGRAM_H

#include "cli/command.h"

/* Does the work of main() and returns its status. The list of commands ends with NULL. */
int pp_program(int argc, char **argv, const struct pp_command *const *commands);

#endif
