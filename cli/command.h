/* command.h - a command of the program; program/main.c has the list of all commands.
 *
 * An entry of the list defines how the arguments are read into the command's own
 * struct, how they are checked, and how the command runs. A new command needs a file
 * cmd_NAME.c in a folder of that name, a declaration here, and an entry in
 * program/main.c.
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
    const char *operands;                 /* "FILE..." */
    const char *about;                    /* a paragraph or more of its help */
    const struct pp_option_group *groups; /* with offsets in the command's own struct */
    size_t size;                          /* size of that struct, bytes */
    void (*more_help)(FILE *out);         /* prints the end of the help; NULL: only
                                           * options */

    void (*init)(void *options); /* called before the arguments are read */
    /* Checks the arguments before any file is opened. PP_BAD_INPUT if they are
     * inconsistent. */
    enum pp_status (*check)(void *options, char **operands, int count,
                            struct pp_error *err);
    enum pp_exit (*run)(void *options, char **operands, int count);
    void (*clear)(void *options); /* always called at the end */
    int words_before_files; /* number of operands before the files: 1 if the first is
                             * the kind of chart */

    /* True if ranks share the command's work. Its options then have a const struct
     * pp_ranks * at the offset ranks_place, which is set after init; NULL: no ranks. */
    bool uses_ranks;
    size_t ranks_place;
};

void pp_command_help(const struct pp_command *command, FILE *out);

/* Runs a command whose name is argv[0], prints its help, or reports invalid arguments.
 * ranks: NULL if this process is alone; a command that does not share its work runs on
 * rank 0 only. */
enum pp_exit pp_command_run(const struct pp_command *command, int argc, char **argv,
                            const struct pp_ranks *ranks);

extern const struct pp_command pp_command_new, pp_command_df, pp_command_chart,
    pp_command_render, pp_command_assess, pp_command_size, pp_command_availability,
    pp_command_validate, pp_command_export, pp_command_import, pp_command_atlas,
    pp_command_report, pp_command_compare, pp_command_annual, pp_command_serve,
    pp_command_doctor, pp_command_glare;

#endif
