/* command.h - a command of the program. program/main.c lists all commands.
 *
 * Each command is a struct pp_command, with functions that check its arguments and run
 * it. Arguments are read into a struct peculiar to the command. To add a command, write
 * cmd_NAME.c in a folder of that name, declare the command here, and add it to the list
 * in program/main.c.
 */
#ifndef PP_CLI_COMMAND_H
#define PP_CLI_COMMAND_H

#include <stddef.h>
#include <stdio.h>

#include "cli/exit_status.h"
#include "cli/options.h"
#include "model/base/ranks.h"

struct pp_command {
    const char *name, *summary;
    const char *operands;                 /* operands in the help text, such as
                                           * "FILE..." */
    const char *about;                    /* description in the help text, one paragraph
                                           * or more */
    const struct pp_option_group *groups; /* options; offsets refer to the command's own
                                           * struct */
    size_t size;                          /* size of the command's own struct, bytes */
    void (*more_help)(FILE *out);         /* prints the end of the help text; NULL:
                                           * there are only options */

    void (*init)(void *options); /* called before arguments are read */
    /* Checks the arguments before any file is opened. Returns PP_BAD_INPUT if they are
     * inconsistent. */
    enum pp_status (*check)(void *options, char **operands, int count,
                            struct pp_error *err);
    enum pp_exit (*run)(void *options, char **operands, int count);
    void (*clear)(void *options); /* always called at the end */
    int words_before_files; /* number of operands before the files: 1 if the first is a
                             * kind of chart */

    /* True if ranks (MPI processes) share the work of the command. The command's
     * options then contain a const struct pp_ranks * at offset ranks_place. The pointer
     * is set after init, and is NULL if there are no ranks. */
    bool uses_ranks;
    size_t ranks_place;
};

void pp_command_help(const struct pp_command *command, FILE *out);

/* Runs the command, prints its help text, or reports invalid arguments. argv[0]: name
 * of the command. ranks: NULL if there is only this process. A command that does not
 * share its work runs on rank 0 only. */
enum pp_exit pp_command_run(const struct pp_command *command, int argc, char **argv,
                            const struct pp_ranks *ranks);

extern const struct pp_command pp_command_new, pp_command_df, pp_command_chart,
    pp_command_render, pp_command_assess, pp_command_size, pp_command_availability,
    pp_command_validate, pp_command_export, pp_command_import, pp_command_atlas,
    pp_command_report, pp_command_compare, pp_command_annual, pp_command_serve,
    pp_command_doctor, pp_command_glare;

#endif
