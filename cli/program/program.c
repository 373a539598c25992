/* program.c - the program's own words, and what it does before and after a command. */
#include "cli/program/program.h"

#include "config.h"

#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/ranks/mpirun.h"
#include "model/base/text.h"

enum { MOST_COMMANDS = 16 };

static void print_help(const struct pp_command *const *commands)
{
    puts("Usage: pepperpot COMMAND [OPTIONS] [FILE...]\n\n"
         "Daylight factors of rooms by the classic hand methods, the charts they are\n"
         "worked on, and a simulation of the same room to set beside them.\n\n"
         "Commands:");
    for (int i = 0; commands[i]; i++)
        printf("  %-12s %s\n", commands[i]->name, commands[i]->summary);
    puts("\nOptions:\n"
         "  -h, --help     Print this help and stop; after a command: its own.\n"
         "      --version  Print the version and stop.\n\n"
         "Exit status: 0 done, 1 the input is wrong, 2 the command line is wrong,\n"
         "3 the machine failed, 130 interrupted.");
}

static int list_names(const char *names[MOST_COMMANDS],
                      const struct pp_command *const *commands)
{
    int count = 0;
    for (; commands[count] && count < MOST_COMMANDS; count++)
        names[count] = commands[count]->name;
    return count;
}

static enum pp_exit fail_unknown(const char *word,
                                 const struct pp_command *const *commands)
{
    const char *names[MOST_COMMANDS];
    int count = list_names(names, commands);
    char question[128];
    pp_text_did_you_mean(question, sizeof question, "",
                         pp_text_nearest(word, names, count), "");
    pp_message("there is no %s \"%s\"%s%s", word[0] == '-' ? "option" : "command", word,
               question[0] ? "; " : "", question);
    fputs("Try: pepperpot --help\n", stderr);
    return PP_EXIT_USAGE;
}

static enum pp_exit run_program(int argc, char **argv,
                                const struct pp_command *const *commands,
                                const struct pp_ranks *ranks)
{
    const char *word = argc > 1 ? argv[1] : NULL;
    if (!word) {
        const char *names[MOST_COMMANDS];
        char known[256];
        int count = list_names(names, commands);
        pp_message("expected a command: %s",
                   pp_text_list_names(known, sizeof known, names, count));
        fputs("Try: pepperpot --help\n", stderr);
        return PP_EXIT_USAGE;
    }
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
        print_help(commands);
        return PP_EXIT_DONE;
    }
    if (strcmp(word, "--version") == 0) {
        puts(PACKAGE_NAME " " PACKAGE_VERSION);
        return PP_EXIT_DONE;
    }
    for (int i = 0; commands[i]; i++)
        if (strcmp(word, commands[i]->name) == 0)
            return pp_command_run(commands[i], argc - 1, argv + 1, ranks);
    return fail_unknown(word, commands);
}

/* A standard stream that was closed would lend its number to the next file opened,
 * which would then get our messages. What stands in for it refuses to be used. */
static void occupy_standard_streams(void)
{
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++)
        if (fcntl(file, F_GETFD) < 0)
            open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int pp_program(int argc, char **argv, const struct pp_command *const *commands)
{
    occupy_standard_streams();
    setlocale(LC_CTYPE, ""); /* the terminal's characters; numbers keep their point */

    struct pp_mpirun mpirun;
    enum pp_exit status = pp_mpirun_begin(&mpirun);
    if (status == PP_EXIT_DONE)
        status = run_program(argc, argv, commands,
                             mpirun.ranks.count > 1 ? &mpirun.ranks : NULL);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        pp_message("standard output can't be written: %s", strerror(errno));
        status = PP_EXIT_MACHINE;
    }
    return pp_mpirun_end(&mpirun, status);
}
