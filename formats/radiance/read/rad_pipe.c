/* rad_pipe.c - see rad_pipe.h. */
#include "formats/radiance/read/rad_pipe.h"

#include <stdlib.h>
#include <string.h>

enum pp_status pp_rad_pipe_fail(const struct pp_rad_pipe *pipe, struct pp_error *err,
                                const char *what, const char *word)
{
    return pp_rad_words_fail(pipe->words, pipe->line, err, "%s%.60s", what, word);
}

/* Ends the command whose words start at index `begin`. */
static enum pp_status end_command(struct pp_rad_pipe *pipe, int begin, int count,
                                  struct pp_error *err)
{
    if (count == begin)
        return pp_rad_pipe_fail(
            pipe, err, "expected a command: gensky, gendaylit, genbox or xform", "");
    if (pipe->command_count == PP_RAD_PIPE_COMMANDS_MOST)
        return pp_rad_pipe_fail(pipe, err,
                                "there are more than 100 commands in one line", "");
    pipe->commands[pipe->command_count++] =
        (struct pp_rad_command){pipe->list + begin, count - begin};
    return PP_OK;
}

enum pp_status pp_rad_pipe_split(struct pp_rad_pipe *pipe, char *text,
                                 struct pp_error *err)
{
    int count = 0, begin = 0;
    for (char *at = text;;) {
        at += strspn(at, " ");
        bool ended = *at == '\0';
        if (ended || *at == '|') {
            enum pp_status status = end_command(pipe, begin, count, err);
            if (ended || status != PP_OK)
                return status;
            begin = count;
            *at++ = '\0'; /* also ends the word before it */
            continue;
        }
        if (count == PP_RAD_PIPE_WORDS_MOST)
            return pp_rad_pipe_fail(pipe, err, "a command has more than 1000 words",
                                    "");
        char quote = *at == '\'' || *at == '"' ? *at++ : '\0';
        pipe->list[count++] = at;
        at += quote ? strcspn(at, (char[]){quote, '\0'})
                    : strcspn(at, " |'\"`$;&<>()*?\\");
        if (quote && *at == '\0')
            return pp_rad_pipe_fail(
                pipe, err, "a quotation mark is not closed: ", pipe->list[count - 1]);
        if (quote)
            *at++ = '\0';
        if (!strchr(" |", *at)) /* strchr also matches the final NUL */
            return pp_rad_pipe_fail(
                pipe, err,
                "expected words separated by blanks, or in quotation marks, not ", at);
        if (*at == ' ')
            *at++ = '\0';
    }
}

void pp_rad_pipe_clear(struct pp_rad_pipe *pipe)
{
    for (int i = 0; i < pipe->command_count; i++)
        free(pipe->xforms[i]);
}
