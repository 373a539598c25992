/* command.h - what a command of the program is; program/main.c has the list of them.
 *
 * A command is an entry of that list: how its words are read into a struct of its own,
 * what makes sense of them, and what it does then. A new one is a file cmd_NAME.c in a
 * folder of its name, a line here and one in program/main.c.
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
    const struct pp_option_group *groups; /* with places in the command's own struct, */
    size_t size;                          /* which has that many bytes */
    void (*more_help)(FILE *out);         /* what the help ends with; NULL: options */

    void (*init)(void *options); /* before the words are read */
    /* Do the words make sense, before any file is opened? PP_BAD_INPUT if not. */
    enum pp_status (*check)(void *options, char **operands, int count,
                            struct pp_error *err);
    enum pp_exit (*run)(void *options, char **operands, int count);
    void (*clear)(void *options); /* in any case */
    int words_before_files; /* how many operands are not yet files: 1 for a kind */

    /* Does it share its work among ranks? Then a const struct pp_ranks * is at that
     * place of the options, set behind init: NULL where there are none. */
    bool uses_ranks;
    size_t ranks_place;
};

void pp_command_help(const struct pp_command *command, FILE *out);

/* argv[0] is the command's name. Prints its help, or says what is wrong with its words,
 * or runs it. ranks: NULL where this process is alone; of a command that does not share work,
 * only rank 0 does anything. */
enum pp_exit pp_command_run(const struct pp_command *command, int argc, char **argv,
                            const struct pp_ranks *ranks);

extern const struct pp_command pp_command_new, pp_command_df, pp_command_chart,
    pp_command_render, pp_command_assess, pp_command_size, pp_command_availability,
    pp_command_validate, pp_command_export, pp_command_import, pp_command_atlas,
    pp_command_report, pp_command_compare, pp_command_annual, pp_command_serve,
    pp_command_doctor;

#endif
