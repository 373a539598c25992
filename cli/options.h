/* options.h - parses the arguments of a command by tables, from which the help is also
 * made.
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

/* Parses `text` and stores the value at `place`. On failure the message states the
 * expected value, as the end of the sentence "--error is "x"; expected ...". */
typedef enum pp_status pp_option_reader(const char *text, void *place,
                                        struct pp_error *err);

struct pp_option {
    const char *name;  /* "error" is typed as --error, "accuracy -aa" as --accuracy or
                        * -aa; NULL ends a list */
    char letter;       /* 'o' for -o; 0: none */
    const char *value; /* name of its value in the help; NULL: a switch */
    const char *help;
    pp_option_reader *read; /* NULL: a switch, which sets a bool to true */
    size_t offset;          /* offset of the value in the group's struct */
};

/* Options that write to the same struct. In the help, consecutive groups with the same
 * title are combined. */
struct pp_option_group {
    const char *title; /* NULL ends a list of groups */
    const struct pp_option *options;
    size_t offset; /* offset of the group's struct in the command's own */
};

struct pp_command_line {
    const char *command; /* "df" */
    const char *operands;
    const char *about; /* description of the command, one paragraph or more */
    const struct pp_option_group *groups;
    void (*more_help)(FILE *out); /* prints the end of the help; NULL: only options */
    void *values;                 /* the command's own struct */
};

/* Reads argv[1] to argv[argc - 1]. Moves the operands, in order, to the start of argv,
 * *operand_count of them. *help: --help or -h was found; nothing else is checked then.
 * PP_BAD_INPUT for an invalid argument. */
enum pp_status pp_options_read(const struct pp_command_line *line, int argc,
                               char **argv, int *operand_count, bool *help,
                               struct pp_error *err);

/* Prints the help of a command. */
void pp_options_help(const struct pp_command_line *line, FILE *out);

/* Prints a line of help for a word that is not an option, in the layout of options. */
void pp_options_help_word(const char *word, const char *text, FILE *out);

/* Reads up to `most` numbers separated by the character `between`; returns their count,
 * or -1 for any other text. */
int pp_options_numbers(const char *text, char between, double *list, int most);

/* Readers; each comment gives the type of the value. */
pp_option_reader pp_options_read_text; /* const char *, not empty; borrowed from argv */
pp_option_reader pp_options_read_input; /* const char *, a file that is read;
                                         * borrowed from argv */
pp_option_reader
    pp_options_read_output; /* for a file that is written; - is standard output */
pp_option_reader
    pp_options_read_updated; /* for a file that is read and written again; no - */
pp_option_reader pp_options_read_count;   /* long, 1 to 1e15 */
pp_option_reader pp_options_read_threads; /* int, 1 to 1024 */
pp_option_reader pp_options_read_seed;    /* uint64_t, any */
pp_option_reader
    pp_options_read_per_cent; /* double, a fraction, above 0, at most 1; "1%" or "1" */
pp_option_reader pp_options_read_lux;    /* double, 1 to 200000; "5000" or "5000 lx" */
pp_option_reader pp_options_read_metres; /* double, 0.1 to 10; "1.6" or "1.6 m" */
pp_option_reader
    pp_options_read_seconds; /* double, above 0; "10s", "2m", "500ms", "1h", "10" */

#endif
