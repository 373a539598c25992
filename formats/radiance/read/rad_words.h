/* rad_words.h - splits a Radiance scene file into words.
 *
 * Words are separated by white space; a word in quotes may contain blanks. "#" begins a
 * comment to the end of the line; a line that begins with "!" is a command. Words point
 * into the text and are found on demand, so that only the text itself needs memory.
 */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_WORDS_H
#define PP_FORMATS_RADIANCE_READ_RAD_WORDS_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

struct pp_rad_words {
    const char *file; /* name in messages; not owned */
    const char *bytes;
    size_t length, at;
    int line; /* current line, from 1 */
};

struct pp_rad_word {
    const char *text; /* not NUL-terminated */
    size_t length;    /* 0 at the end of the file */
    int line;
};

enum { PP_RAD_WORD_MOST = 4096 };

/* Reads the next word. PP_BAD_INPUT for a word of more than PP_RAD_WORD_MOST
 * characters, or with control characters. */
enum pp_status pp_rad_words_next(struct pp_rad_words *words, struct pp_rad_word *word,
                                 struct pp_error *err);

/* If the next word begins with "!", *command is the rest of the line after it, freed by
 * the caller; else NULL. A line that ends in a backslash continues on the next one; a
 * blank replaces both characters. */
enum pp_status pp_rad_words_next_command(struct pp_rad_words *words, char **command,
                                         int *line, struct pp_error *err);

/* Fails with "FILE:LINE: " before the sentence. */
enum pp_status pp_rad_words_fail(const struct pp_rad_words *words, int line,
                                 struct pp_error *err, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds file and line of the primitive to the message of a PP_BAD_INPUT from another
 * part of the program; other statuses are unchanged. */
enum pp_status pp_rad_words_locate(const struct pp_rad_words *words, int line,
                                   enum pp_status status, const struct pp_error *said,
                                   struct pp_error *err);

/* Number of characters of the word shown in a message, for "%.*s". */
static inline int pp_rad_words_shown(struct pp_rad_word word)
{
    return (int)(word.length < 60 ? word.length : 60);
}

bool pp_rad_words_is(struct pp_rad_word word, const char *text);

/* Reads the whole word as a number; false for other text ("1,5", "nan", "0x1"). */
bool pp_rad_words_number(struct pp_rad_word word, double *value);

#endif
