/* options.c - finds options in their tables, reads their values, and prints the
 * help. */
#include "cli/options.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/format.h"
#include "model/base/text.h"

enum { HELP_WIDTH = 80, HELP_INDENT = 24, MOST_OPTIONS = 64 };

static const struct pp_option help_option = {
    .name = "help", .letter = 'h', .help = "Print this help and stop."};

/* Option found on the command line, and the address of its value. */
struct found {
    const struct pp_option *option;
    void *place;
};

/* Length of an option's name, without a short form that may follow it. */
static size_t name_length(const struct pp_option *option)
{
    return strcspn(option->name, " ");
}

/* Short form of an option, with its hyphen; NULL: none. */
static const char *short_of(const struct pp_option *option)
{
    const char *space = strchr(option->name, ' ');
    return space ? space + 1 : NULL;
}

static bool is_named(const struct pp_option *option, const char *name, size_t length)
{
    return name_length(option) == length && memcmp(option->name, name, length) == 0;
}

/* Finds the option with that name or, if name is NULL, with that letter. */
static struct found find_option(const struct pp_command_line *line, const char *name,
                                size_t length, char letter)
{
    for (const struct pp_option_group *group = line->groups; group->title; group++)
        for (const struct pp_option *option = group->options; option->name; option++)
            if (name ? is_named(option, name, length) : option->letter == letter)
                return (struct found){option, (char *)line->values + group->offset
                                                  + option->offset};
    if (name ? is_named(&help_option, name, length) : letter == help_option.letter)
        return (struct found){&help_option, NULL};
    return (struct found){NULL, NULL};
}

/* Finds the option with that short name, such as -aa. */
static struct found find_short(const struct pp_command_line *line, const char *word)
{
    for (const struct pp_option_group *group = line->groups; group->title; group++)
        for (const struct pp_option *option = group->options; option->name; option++)
            if (short_of(option) && strcmp(short_of(option), word) == 0)
                return (struct found){option, (char *)line->values + group->offset
                                                  + option->offset};
    return (struct found){NULL, NULL};
}

/* Short form with which a word begins, such as -aa in -aa.2; NULL: none. */
static const char *nearest_short(const struct pp_command_line *line, const char *word)
{
    for (const struct pp_option_group *group = line->groups; group->title; group++)
        for (const struct pp_option *option = group->options; option->name; option++)
            if (short_of(option)
                && strncmp(word, short_of(option), strlen(short_of(option))) == 0)
                return short_of(option);
    return NULL;
}

static enum pp_status fail_unknown(const struct pp_command_line *line, const char *word,
                                   size_t length, struct pp_error *err)
{
    enum { LONGEST = 32 };
    char trimmed[MOST_OPTIONS][LONGEST];
    const char *names[MOST_OPTIONS];
    int count = 0;
    for (const struct pp_option_group *group = line->groups; group->title; group++)
        for (const struct pp_option *option = group->options; option->name; option++) {
            if (count == MOST_OPTIONS)
                continue;
            snprintf(trimmed[count], LONGEST, "%.*s", (int)name_length(option),
                     option->name);
            names[count] = trimmed[count];
            count++;
        }

    char typed[64];
    snprintf(typed, sizeof typed, "%.*s", (int)length, word);
    char question[128];
    pp_text_did_you_mean(question, sizeof question, "--",
                         pp_text_nearest(typed, names, count), "");
    return pp_fail(err, PP_BAD_INPUT, "there is no option --%s%s%s", typed,
                   question[0] ? "; " : "", question);
}

static enum pp_status set(struct found found, const char *shown, const char *value,
                          struct pp_error *err)
{
    if (!found.option->value) {
        *(bool *)found.place = true;
        return PP_OK;
    }
    struct pp_error expected = {0};
    enum pp_status status = found.option->read(value, found.place, &expected);
    if (status == PP_BAD_INPUT)
        return pp_fail(err, status, "%s is \"%.200s\"; expected %s", shown, value,
                       expected.message);
    if (status != PP_OK && err)
        *err = expected;
    return status;
}

/* Reads one option, and its value if the value is the next word. *taken: number of
 * words read. */
static enum pp_status read_option(const struct pp_command_line *line, char **words,
                                  int count, int *taken, bool *help,
                                  struct pp_error *err)
{
    const char *word = words[0];
    bool is_long = word[1] == '-';
    const char *name = word + 2;
    size_t length = is_long ? strcspn(name, "=") : 0;
    struct found found = find_short(line, word);
    bool is_short = found.option != NULL;
    if (!is_short)
        found = find_option(line, is_long ? name : NULL, length, word[1]);
    const char *value = is_long ? (name[length] ? name + length + 1 : NULL)
                        : word[2] && !is_short ? word + 2
                                               : NULL;
    *taken = 1;

    if (!found.option && is_long)
        return fail_unknown(line, name, length, err);
    const char *short_word = nearest_short(line, word);
    char question[128];
    if (!found.option && short_word)
        return pp_fail(
            err, PP_BAD_INPUT, "there is no option %.40s; %s", word,
            pp_text_did_you_mean(question, sizeof question, "", short_word,
                                 ", followed by its value as a separate argument"));
    if (!found.option)
        return pp_fail(err, PP_BAD_INPUT, "there is no option %.*s",
                       1 + pp_format_utf8_length(word + 1), word);

    char shown[64];
    if (is_short || is_long)
        snprintf(shown, sizeof shown, "%.*s", is_short ? 40 : (int)length + 2, word);
    else
        snprintf(shown, sizeof shown, "-%.1s", &found.option->letter);
    if (!found.option->value && value)
        return pp_fail(err, PP_BAD_INPUT, "%s takes no value, but has \"%.200s\"",
                       shown, value);
    if (found.option == &help_option) {
        *help = true;
        return PP_OK;
    }
    if (found.option->value && !value) {
        if (count < 2)
            return pp_fail(err, PP_BAD_INPUT, "%s needs a value: %s %s", shown, shown,
                           found.option->value);
        value = words[1];
        *taken = 2;
    }
    return set(found, shown, value, err);
}

enum pp_status pp_options_read(const struct pp_command_line *line, int argc,
                               char **argv, int *operand_count, bool *help,
                               struct pp_error *err)
{
    *operand_count = 0;
    *help = false;
    bool options_over = false;
    for (int i = 1; i < argc;) {
        char *word = argv[i];
        if (options_over || word[0] != '-' || word[1] == '\0') {
            argv[(*operand_count)++] = word;
            i++;
        } else if (strcmp(word, "--") == 0) {
            options_over = true;
            i++;
        } else {
            int taken;
            enum pp_status status =
                read_option(line, argv + i, argc - i, &taken, help, err);
            if (status != PP_OK || *help)
                return status;
            i += taken;
        }
    }
    return PP_OK;
}

/* Prints wrapped text, starting at column `column`. Further lines are indented. */
static void wrap(FILE *out, const char *text, int column, int indent)
{
    while (*text) {
        int length = (int)strcspn(text, " \n");
        if (column > indent && column + 1 + length > HELP_WIDTH) {
            fprintf(out, "\n%*s", indent, "");
            column = indent;
        } else if (column > indent) {
            fputc(' ', out);
            column++;
        }
        fwrite(text, 1, (size_t)length, out);
        column += length;
        text += length;
        if (*text == '\n') {
            fprintf(out, "\n%*s", indent, "");
            column = indent;
        }
        text += *text != '\0';
    }
    fputc('\n', out);
}

static void help_on_option(const struct pp_option *option, FILE *out)
{
    char typed[80];
    int length = 2;
    if (short_of(option))
        length += snprintf(typed, sizeof typed, "%s, ", short_of(option));
    else
        length += snprintf(typed, sizeof typed, option->letter ? "-%.1s, " : "    ",
                           &option->letter);
    length += snprintf(typed + length - 2, sizeof typed - 8, "--%.*s%s%s",
                       (int)name_length(option), option->name, option->value ? " " : "",
                       option->value ? option->value : "");
    fprintf(out, "  %s", typed);
    if (length + 2 > HELP_INDENT) {
        fputc('\n', out);
        length = 0;
    }
    fprintf(out, "%*s", HELP_INDENT - length, "");
    wrap(out, option->help, HELP_INDENT, HELP_INDENT);
}

void pp_options_help_word(const char *word, const char *text, FILE *out)
{
    fprintf(out, "  %-*s", HELP_INDENT - 2, word);
    wrap(out, text, HELP_INDENT, HELP_INDENT);
}

void pp_options_help(const struct pp_command_line *line, FILE *out)
{
    fprintf(out, "Usage: pepperpot %s [OPTIONS]%s%s\n\n", line->command,
            *line->operands ? " " : "", line->operands);
    wrap(out, line->about, 0, 0);
    const char *title = "";
    for (const struct pp_option_group *group = line->groups; group->title; group++) {
        if (strcmp(group->title, title) != 0)
            fprintf(out, "\n%s:\n", group->title);
        title = group->title;
        for (const struct pp_option *option = group->options; option->name; option++)
            help_on_option(option, out);
    }
    fputc('\n', out);
    help_on_option(&help_option, out);
    if (line->more_help)
        line->more_help(out);
}

/* Reads a whole number, 0 or more. */
static bool read_whole(const char *text, uint64_t *number)
{
    if (!*text || strspn(text, "0123456789") != strlen(text))
        return false;
    errno = 0;
    unsigned long long whole = strtoull(text, NULL, 10);
    *number = whole;
    return errno == 0 && whole <= UINT64_MAX;
}

enum pp_status pp_options_read_text(const char *text, void *place, struct pp_error *err)
{
    if (!*text)
        return pp_fail(err, PP_BAD_INPUT, "text that is not empty");
    *(const char **)place = text;
    return PP_OK;
}

enum pp_status pp_options_read_input(const char *text, void *place,
                                     struct pp_error *err)
{
    return pp_options_read_text(text, place, err);
}

enum pp_status pp_options_read_output(const char *text, void *place,
                                      struct pp_error *err)
{
    return pp_options_read_text(text, place, err);
}

enum pp_status pp_options_read_updated(const char *text, void *place,
                                       struct pp_error *err)
{
    if (strcmp(text, "-") == 0)
        return pp_fail(err, PP_BAD_INPUT, "the name of a file");
    return pp_options_read_text(text, place, err);
}

enum pp_status pp_options_read_count(const char *text, void *place,
                                     struct pp_error *err)
{
    uint64_t count;
    if (!read_whole(text, &count) || count < 1 || count > 1000000000000000)
        return pp_fail(err, PP_BAD_INPUT, "a whole number from 1 to 1000000000000000");
    *(long *)place = (long)count;
    return PP_OK;
}

enum pp_status pp_options_read_threads(const char *text, void *place,
                                       struct pp_error *err)
{
    uint64_t count;
    if (!read_whole(text, &count) || count < 1 || count > 1024)
        return pp_fail(err, PP_BAD_INPUT, "a whole number from 1 to 1024");
    *(int *)place = (int)count;
    return PP_OK;
}

enum pp_status pp_options_read_seed(const char *text, void *place, struct pp_error *err)
{
    if (!read_whole(text, (uint64_t *)place))
        return pp_fail(err, PP_BAD_INPUT,
                       "a whole number from 0 to 18446744073709551615");
    return PP_OK;
}

/* Reads a number followed by one of the units in `units`, and nothing else. *which is
 * set to the index of the unit. */
static bool read_with_unit(const char *text, const char *const units[], double *number,
                           int *which)
{
    char digits[64];
    size_t length = strlen(text);
    for (int i = 0; units[i]; i++) {
        size_t end = strlen(units[i]);
        if (length < end || strcmp(text + length - end, units[i]) != 0
            || length - end >= sizeof digits)
            continue;
        memcpy(digits, text, length - end);
        digits[length - end] = '\0';
        *which = i;
        if (pp_text_parse_number(digits, number))
            return true;
    }
    return false;
}

enum pp_status pp_options_read_per_cent(const char *text, void *place,
                                        struct pp_error *err)
{
    static const char *const units[] = {"%", "", NULL};
    double per_cent;
    int which;
    if (!read_with_unit(text, units, &per_cent, &which) || !(per_cent > 0.0)
        || per_cent > 100.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "a percentage above 0 and up to 100, such as 1%%");
    *(double *)place = per_cent / 100.0;
    return PP_OK;
}

enum pp_status pp_options_read_lux(const char *text, void *place, struct pp_error *err)
{
    static const char *const units[] = {" lx", "lx", "", NULL};
    double lux;
    int which;
    if (!read_with_unit(text, units, &lux, &which) || !(lux >= 1.0 && lux <= 2e5))
        return pp_fail(err, PP_BAD_INPUT,
                       "an illuminance from 1 to 200000 lx, such as 5000");
    *(double *)place = lux;
    return PP_OK;
}

int pp_options_numbers(const char *text, char between, double *list, int most)
{
    int count = 0;
    for (;; count++) {
        size_t length = strcspn(text, (const char[]){between, '\0'});
        char copy[64];
        if (count == most || length >= sizeof copy)
            return -1;
        memcpy(copy, text, length);
        copy[length] = '\0';
        if (!pp_text_parse_number(copy, &list[count]))
            return -1;
        if (!text[length])
            return count + 1;
        text += length + 1;
    }
}

enum pp_status pp_options_read_metres(const char *text, void *place,
                                      struct pp_error *err)
{
    static const char *const units[] = {" m", "m", "", NULL};
    double metres;
    int which;
    if (!read_with_unit(text, units, &metres, &which)
        || !(metres >= 0.1 && metres <= 10.0))
        return pp_fail(err, PP_BAD_INPUT, "a height from 0.1 to 10 m, such as 1.6");
    *(double *)place = metres;
    return PP_OK;
}

enum pp_status pp_options_read_seconds(const char *text, void *place,
                                       struct pp_error *err)
{
    static const char *const units[] = {"ms", "s", "m", "h", "", NULL};
    static const double seconds[] = {1e-3, 1.0, 60.0, 3600.0, 1.0};
    double number;
    int which;
    if (!read_with_unit(text, units, &number, &which) || !(number > 0.0)
        || number * seconds[which] > 1e9)
        return pp_fail(err, PP_BAD_INPUT,
                       "a time above 0, such as 10s, 500ms, 2m or 1h");
    *(double *)place = number * seconds[which];
    return PP_OK;
}
