/* command.c - runs any command: its options, its check, its work, its end. */
#include "cli/command.h"

#include <stdlib.h>

#include "cli/command_files.h"
#include "cli/message.h"

static struct pp_command_line line_of(const struct pp_command *command, void *options)
{
    return (struct pp_command_line){.command = command->name,
                                    .operands = command->operands,
                                    .about = command->about,
                                    .groups = command->groups,
                                    .more_help = command->more_help,
                                    .values = options};
}

void pp_command_help(const struct pp_command *command, FILE *out)
{
    const struct pp_command_line line = line_of(command, NULL);
    pp_options_help(&line, out);
}

static enum pp_exit run_with(const struct pp_command *command, void *options, int argc,
                             char **argv)
{
    const struct pp_command_line line = line_of(command, options);
    struct pp_error err = {0};
    int count;
    bool wants_help;
    enum pp_status status =
        pp_options_read(&line, argc, argv, &count, &wants_help, &err);
    if (status == PP_OK && wants_help) {
        pp_options_help(&line, stdout);
        return PP_EXIT_DONE;
    }
    int words =
        count < command->words_before_files ? count : command->words_before_files;
    if (status == PP_OK)
        status = command->check(options, argv, count, &err);
    if (status == PP_OK)
        status = pp_command_files_apart(&line, argv + words, count - words, &err);
    if (status == PP_SYSTEM)
        return pp_message_error(&err);
    return status == PP_OK ? command->run(options, argv, count)
                           : pp_message_usage(command->name, &err);
}

enum pp_exit pp_command_run(const struct pp_command *command, int argc, char **argv,
                            const struct pp_ranks *ranks)
{
    struct pp_error err;
    if (ranks && ranks->rank > 0 && !command->uses_ranks)
        return PP_EXIT_DONE;
    void *options = calloc(1, command->size);
    if (!options) {
        pp_fail_memory(&err);
        return pp_message_error(&err);
    }
    command->init(options);
    if (command->uses_ranks)
        *(const struct pp_ranks **)((char *)options + command->ranks_place) = ranks;
    enum pp_exit exit_status = run_with(command, options, argc, argv);
    command->clear(options);
    free(options);
    return exit_status;
}
