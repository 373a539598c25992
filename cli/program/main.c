/* main.c - pepperpot: the commands that draw nothing, without the libraries that draw,
 * which take longer to load than a room's daylight factors take to work out. For all else
 * it becomes the whole program. */
#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "cli/message.h"
#include "cli/program/program.h"
#include "cli/program/program_part.h"

static const struct pp_command *const commands[] = {
    &pp_command_df,           &pp_command_assess,
    &pp_command_availability, &pp_command_validate,
    &pp_command_export,       &pp_command_import,
    &pp_command_compare,      NULL,
};

static bool is_here(const char *word)
{
    for (int i = 0; word && commands[i]; i++)
        if (strcmp(word, commands[i]->name) == 0)
            return true;
    return word && strcmp(word, "--version") == 0;
}

int main(int argc, char **argv)
{
    if (is_here(argv[1]))
        return pp_program(argc, argv, commands);
    char path[PP_PROGRAM_PART_PATH];
    pp_program_part(path, "", PP_PROGRAM_FOLDER, "pepperpot-whole");
    execv(path, argv);
    pp_message("%s, which has the rest of the program, can't be started: %s", path,
               strerror(errno));
    return PP_EXIT_MACHINE;
}
