/* rad_pipe.h - a line of a Radiance scene that begins with "!", as commands.
 *
 * A line is one command or several piped together: "!genbox ... | xform ...". It is
 * only split here; rad_read.c evaluates the commands.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_PIPE_H
#define PP_FORMATS_RADIANCE_READ_RAD_PIPE_H

#include "formats/radiance/read/rad_words.h"

enum { PP_RAD_PIPE_WORDS_MOST = 1000, PP_RAD_PIPE_COMMANDS_MOST = 100 };

struct pp_rad_command {
    char **words; /* the first is its name */
    int count;
};

struct pp_rad_pipe {
    const struct pp_rad_words *words; /* where the line stands; not owned */
    int line;
    char *list[PP_RAD_PIPE_WORDS_MOST];
    struct pp_rad_command commands[PP_RAD_PIPE_COMMANDS_MOST];
    int command_count;
    /* The xforms among them, as they are first run; NULL: not yet. Freed by
     * pp_rad_pipe_clear. */
    struct pp_rad_xform *xforms[PP_RAD_PIPE_COMMANDS_MOST];
};

/* Splits text, which is changed and which the pipe's words then lie in, at blanks and
 * pipes; words may stand in quotes. Whatever else a shell would do is refused. The pipe
 * is zero at first, but for where it stands. */
enum pp_status pp_rad_pipe_split(struct pp_rad_pipe *pipe, char *text,
                                 struct pp_error *err);

void pp_rad_pipe_clear(struct pp_rad_pipe *pipe);

/* Fails with the file and line before `what` and, up to 60 characters of it, `word`. */
enum pp_status pp_rad_pipe_fail(const struct pp_rad_pipe *pipe, struct pp_error *err,
                                const char *what, const char *word);

#endif
