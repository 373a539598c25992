/* main.c - pepperpot, daylight factors by hand methods and ray tracing: the list of
 * commands, the program's own options, and the work before and after a command. */
#include "config.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <locale.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/message.h"
#include "cli/ranks/mpirun.h"
#include "model/base/text.h"

static const struct pp_command *const commands[] = {
    &pp_command_new,    &pp_command_df,           &pp_command_chart,
    &pp_command_render, &pp_command_assess,       &pp_command_report,
    &pp_command_size,   &pp_command_availability, &pp_command_annual,
    &pp_command_glare,  &pp_command_validate,     &pp_command_compare,
    &pp_command_atlas,  &pp_command_export,       &pp_command_import,
    &pp_command_serve,  &pp_command_doctor,       NULL,
};

enum { COMMAND_COUNT = sizeof commands / sizeof *commands - 1 };

static void print_help(void)
{
    puts("Usage: pepperpot COMMAND [OPTIONS] [FILE...]\n       pepperpot FILE.xml "
         "[OPTIONS]   same as pepperpot df\n\nDaylight factors of rooms by the classic "
         "hand methods, with their charts,\nand a simulation of the same rooms for "
         "comparison.\n\nCommands:");
    for (int i = 0; i < COMMAND_COUNT; i++)
        printf("  %-12s %s\n", commands[i]->name, commands[i]->summary);
    puts(
        "\nOptions:\n  -h, --help     Print this help and stop. pepperpot help COMMAND "
        "and\n                 pepperpot COMMAND --help describe a command.\n      "
        "--version  Print the version and stop.\n\nExit status: 0 success, 1 error in "
        "the input, 2 error on the command line,\n3 system error, 130 interrupted.");
}

static void list_commands(const char *names[COMMAND_COUNT])
{
    for (int i = 0; i < COMMAND_COUNT; i++)
        names[i] = commands[i]->name;
}

static enum pp_exit fail_unknown_command(const char *word)
{
    const char *names[COMMAND_COUNT];
    list_commands(names);
    char question[128];
    pp_text_did_you_mean(question, sizeof question, "",
                         pp_text_nearest(word, names, COMMAND_COUNT), "");
    pp_message("there is no %s \"%s\"%s%s", word[0] == '-' ? "option" : "command", word,
               question[0] ? "; " : "", question);
    fputs("Try: pepperpot --help\n", stderr);
    return PP_EXIT_USAGE;
}

/* Finds a command by name; NULL: there is none. */
static const struct pp_command *find_command(const char *name)
{
    for (int i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(name, commands[i]->name) == 0)
            return commands[i];
    return NULL;
}

/* Prints the help of the program or of the given command. */
static enum pp_exit run_help(int argc, char **argv)
{
    const struct pp_command *command = argc > 0 ? find_command(argv[0]) : NULL;
    if (argc > 1) {
        pp_message("help describes one command, but there are %d words; expected one",
                   argc);
        return PP_EXIT_USAGE;
    }
    if (argc > 0 && !command)
        return fail_unknown_command(argv[0]);
    if (command)
        pp_command_help(command, stdout);
    else
        print_help();
    return PP_EXIT_DONE;
}

static bool names_room_file(const char *word)
{
    const char *extension = strrchr(word, '.');
    return word[0] != '-' && extension && strcasecmp(extension, ".xml") == 0;
}

static enum pp_exit run_program(int argc, char **argv, const struct pp_ranks *ranks)
{
    const char *word = argc > 1 ? argv[1] : NULL;
    if (!word) {
        const char *names[COMMAND_COUNT];
        char known[256];
        list_commands(names);
        pp_message("expected a command: %s",
                   pp_text_list_names(known, sizeof known, names, COMMAND_COUNT));
        fputs("Try: pepperpot --help\n", stderr);
        return PP_EXIT_USAGE;
    }
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
        print_help();
        return PP_EXIT_DONE;
    }
    if (strcmp(word, "--version") == 0) {
        puts(PACKAGE_NAME " " PACKAGE_VERSION);
        return PP_EXIT_DONE;
    }
    if (strcmp(word, "help") == 0)
        return run_help(argc - 2, argv + 2);
    const struct pp_command *command = find_command(word);
    if (command)
        return pp_command_run(command, argc - 1, argv + 1, ranks);
    if (names_room_file(word)) /* argv[0] stands for the name of the command */
        return pp_command_run(&pp_command_df, argc, argv, ranks);
    return fail_unknown_command(word);
}

/* Opens standard streams that were closed. Otherwise the next file to be opened would
 * become a standard stream and receive messages. The replacements cannot be used: the
 * input is not readable, and the outputs are not writable. */
static void occupy_standard_streams(void)
{
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++)
        if (fcntl(file, F_GETFD) < 0)
            open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/* Reports an error for which GLib, used by Pango, would abort, and exits: GLib cannot
 * start a thread or allocate memory. Passes on other messages. */
static GLogWriterOutput write_glib_log(GLogLevelFlags level, const GLogField *fields,
                                       gsize count, gpointer data)
{
    if (!(level & G_LOG_LEVEL_ERROR))
        return g_log_writer_default(level, fields, count, data);
    const char *text = "out of memory";
    for (gsize i = 0; i < count; i++)
        if (strcmp(fields[i].key, "MESSAGE") == 0)
            text = fields[i].value;
    pp_message("the system refused what drawing text needs: %s", text);
    _exit(PP_EXIT_MACHINE);
}

int main(int argc, char **argv)
{
    occupy_standard_streams();
    signal(SIGXFSZ,
           SIG_IGN); /* exceeding the file size limit then fails as a write error */
    g_log_set_writer_func(write_glib_log, NULL, NULL);
    setlocale(LC_CTYPE, ""); /* the terminal's character set; decimal points stay */

    struct pp_mpirun mpirun;
    enum pp_exit status = pp_mpirun_begin(&mpirun);
    if (status == PP_EXIT_DONE)
        status = run_program(argc, argv, mpirun.ranks.count > 1 ? &mpirun.ranks : NULL);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        pp_message("standard output cannot be written: %s", strerror(errno));
        status = PP_EXIT_MACHINE;
    }
    return pp_mpirun_end(&mpirun, status);
}
