/* program_words.h - converts the options of a request to command-line arguments. For
 * use inside serve/ only. */
#ifndef PP_SERVE_WORK_PROGRAM_WORDS_H
#define PP_SERVE_WORK_PROGRAM_WORDS_H

#include "serve/work/child.h"

struct pp_program_words {
    const char *list[PP_CHILD_WORDS_MOST + 1]; /* NULL-terminated */
    int count;
    char *owned[PP_CHILD_WORDS_MOST];
    int owned_count;
    const char *type; /* media type of the output */
};

/* Makes the arguments of the task's command, with the room on standard input. Only
 * options of the command that do not name files are accepted. Otherwise returns false
 * and sets the error answer. The caller clears *words, also after a failure. */
bool pp_program_words_make(struct pp_program_words *words, struct pp_task *task);

/* Adds an argument, which is not copied and must exist as long as *words. */
void pp_program_words_add(struct pp_program_words *words, const char *word);

/* Adds a copy of "--name=value", or of "--name" if the value is empty. */
void pp_program_words_add_option(struct pp_program_words *words, const char *name,
                                 const char *value);
void pp_program_words_clear(struct pp_program_words *words);

#endif
