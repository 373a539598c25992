/* message.c - prints messages to standard error, each after the program's name. */
#include "cli/message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "reports/parts/format.h"

static void put_line(const char *before, const char *message)
{
    fputs(before, stderr);
    pp_format_utf8_put(stderr, message);
    fputc('\n', stderr);
}

/* Prints the indented lines below a message, which show the position of an error in the
 * typed text. */
static void put_lines(const char *message)
{
    char line[sizeof((struct pp_error *)0)->message];
    for (const char *next; (next = strstr(message, "\n  ")); message = next + 1) {
        snprintf(line, sizeof line, "%.*s", (int)(next - message), message);
        put_line("", line);
    }
    put_line("", message);
}

enum pp_exit pp_message_error(const struct pp_error *err)
{
    put_line("pepperpot: ", err->message);
    return pp_exit_status_of(err->status);
}

enum pp_exit pp_message_usage(const char *command, const struct pp_error *err)
{
    fprintf(stderr, "pepperpot %s: ", command);
    put_lines(err->message);
    fprintf(stderr, "Try: pepperpot %s --help\n", command);
    return PP_EXIT_USAGE;
}

void pp_message(const char *format, ...)
{
    char message[sizeof((struct pp_error *)0)->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    put_line("pepperpot: ", message);
}

/* Prints all messages, each after its file and line. word: printed before the text of
 * each message. */
static void put_mistakes(struct pp_mistakes *mistakes, const char *word)
{
    pp_mistakes_sort(mistakes);
    for (int i = 0; i < mistakes->count; i++) {
        pp_format_utf8_put(stderr, mistakes->file);
        if (mistakes->list[i].line > 0)
            fprintf(stderr, ":%d", mistakes->list[i].line);
        put_line(word, mistakes->list[i].text);
    }
}

enum pp_exit pp_message_mistakes(struct pp_mistakes *mistakes)
{
    put_mistakes(mistakes, ": ");
    if (mistakes->truncated) {
        pp_format_utf8_put(stderr, mistakes->file);
        fputs(": there are more errors than can be shown\n", stderr);
    }
    return PP_EXIT_INPUT;
}

void pp_message_warnings(struct pp_mistakes *warnings, bool strict)
{
    put_mistakes(warnings, strict ? ": " : ": warning: ");
}

enum pp_exit pp_message_unfinished(void)
{
    pp_message("interrupted; unfinished results are marked");
    return PP_EXIT_INTERRUPTED;
}
