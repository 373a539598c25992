/* program_words.h - the options of a request as words of a command line. Inside serve/
 * only. */
#ifndef PP_SERVE_WORK_PROGRAM_WORDS_H
#define PP_SERVE_WORK_PROGRAM_WORDS_H

#include "serve/work/child.h"

struct pp_program_words {
    const char *list[PP_CHILD_WORDS_MOST + 1]; /* NULL behind the last */
    int count;
    char *owned[PP_CHILD_WORDS_MOST];
    int owned_count;
    const char *type; /* media type of the output */
};

/* The words of the task's command with its options, for a room on standard input. Only
 * options that name no files are taken, each only of the commands that have it. False: the
 * answer is set. Cleared in any case by pp_program_words_clear. */
bool pp_program_words_make(struct pp_program_words *words, struct pp_task *task);

/* Adds a word that lives as long as the words do. */
void pp_program_words_add(struct pp_program_words *words, const char *word);

/* Adds "--name=value", copied. */
void pp_program_words_add_option(struct pp_program_words *words, const char *name,
                                 const char *value);
void pp_program_words_clear(struct pp_program_words *words);

#endif
