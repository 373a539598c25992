/* rad_pipe.h - a line of a Radiance scene that begins with "!", split into commands.
 *
 * A line is one command or several piped together: "!genbox ... | xform ...". It is
 * only split here; rad_read.c evaluates the commands.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_PIPE_H
#define PP_FORMATS_RADIANCE_READ_RAD_PIPE_H

#include "formats/radiance/read/rad_words.h"

enum { PP_RAD_PIPE_WORDS_MOST = 1000, PP_RAD_PIPE_COMMANDS_MOST = 100 };

struct pp_rad_command {
    char **words; /* words[0] is the command name */
    int count;
};

struct pp_rad_pipe {
    const struct pp_rad_words *words; /* source position of the line; not owned */
    int line;
    char *list[PP_RAD_PIPE_WORDS_MOST];
    struct pp_rad_command commands[PP_RAD_PIPE_COMMANDS_MOST];
    int command_count;
    /* Parsed xforms by command; NULL: not yet parsed, or no xform. Freed by
     * pp_rad_pipe_clear. */
    struct pp_rad_xform *xforms[PP_RAD_PIPE_COMMANDS_MOST];
};

/* Splits text at blanks and pipes; words may be quoted. Other shell syntax is
 * PP_BAD_INPUT. The text is changed, and the pipe's words point into it. Before the
 * call all members of the pipe but `words` and `line` must be zero. */
enum pp_status pp_rad_pipe_split(struct pp_rad_pipe *pipe, char *text,
                                 struct pp_error *err);

void pp_rad_pipe_clear(struct pp_rad_pipe *pipe);

/* Fails with file and line, followed by `what` and up to 60 characters of `word`. */
enum pp_status pp_rad_pipe_fail(const struct pp_rad_pipe *pipe, struct pp_error *err,
                                const char *what, const char *word);

#endif
