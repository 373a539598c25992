/* options.h - parses the arguments of a command by tables, which are also the source of
 * the help.
 *
 * The value of a long option follows "=" or is the next word. The value of a letter
 * option follows it directly or is the next word. The value of a short form such as -aa
 * is the next word. "--" ends the options; "-" alone is a file.
 */
#ifndef PP_CLI_OPTIONS_H
#define PP_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "model/base/error.h"

/* Parses `text` and stores the value at `place`. On failure the message describes the
 * expected value, as the end of the sentence "--error is "x"; expected ...". */
typedef enum pp_status pp_option_reader(const char *text, void *place,
                                        struct pp_error *err);

struct pp_option {
    const char *name;  /* long and short form: "error" for --error, "accuracy -aa" for
                        * --accuracy and -aa; NULL ends a list */
    char letter;       /* letter form: 'o' for -o; 0: none */
    const char *value; /* name of the value in the help; NULL: a switch */
    const char *help;
    pp_option_reader *read; /* NULL: a switch, which sets a bool to true */
    size_t offset;          /* offset of the value in the struct of the group */
};

/* Options whose values are in the same struct. In the help, consecutive groups with the
 * same title are combined. */
struct pp_option_group {
    const char *title; /* NULL ends a list of groups */
    const struct pp_option *options;
    size_t offset; /* offset of the group's struct in the command's struct */
};

struct pp_command_line {
    const char *command; /* name of the command, such as "df" */
    const char *operands;
    const char *about; /* description of the command in the help, one paragraph or
                        * more */
    const struct pp_option_group *groups;
    void (*more_help)(FILE *out); /* prints the end of the help; NULL: there are only
                                   * options */
    void *values;                 /* struct with the values of the command's options */
};

/* Reads argv[1] to argv[argc - 1]. Moves the operands, in order, to the start of argv;
 * *operand_count is their number. *help is set to true if --help or -h is found; the
 * arguments after it are then not checked. PP_BAD_INPUT for an invalid argument. */
enum pp_status pp_options_read(const struct pp_command_line *line, int argc,
                               char **argv, int *operand_count, bool *help,
                               struct pp_error *err);

/* Prints the help of a command. */
void pp_options_help(const struct pp_command_line *line, FILE *out);

/* Prints a help line for a word that is not an option, in the same layout as
 * options. */
void pp_options_help_word(const char *word, const char *text, FILE *out);

/* Reads at most `most` numbers separated by the character `between`. Returns their
 * number, or -1 if the text is not such a list. */
int pp_options_numbers(const char *text, char between, double *list, int most);

/* Readers. Each comment states the type of the value. */
pp_option_reader pp_options_read_text; /* const char *, not empty; a string of argv, not
                                        * owned */
pp_option_reader pp_options_read_input; /* const char *, a file to be read; a string of
                                         * argv, not owned */
pp_option_reader
    pp_options_read_output; /* const char *, a file to be written; "-": standard
                             * output */
pp_option_reader
    pp_options_read_updated; /* const char *, a file to be read and written again; not
                              * "-" */
pp_option_reader pp_options_read_count;   /* long, 1 to 1e15 */
pp_option_reader pp_options_read_threads; /* int, 1 to 1024 */
pp_option_reader pp_options_read_seed;    /* uint64_t, any */
pp_option_reader
    pp_options_read_per_cent; /* double, fraction above 0, at most 1; "1%" or "1" */
pp_option_reader pp_options_read_lux;    /* double, 1 to 200000; "5000" or "5000 lx" */
pp_option_reader pp_options_read_metres; /* double, 0.1 to 10; "1.6" or "1.6 m" */
pp_option_reader
    pp_options_read_seconds; /* double, above 0, s; "10s", "2m", "500ms", "1h", "10" */

#endif
