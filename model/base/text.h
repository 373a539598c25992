/* text.h - text put together piece by piece in an array of fixed size; names that
 * somebody mistyped; and numbers as people write them, whatever the locale. */
#ifndef PP_MODEL_BASE_TEXT_H
#define PP_MODEL_BASE_TEXT_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "model/base/error.h"

/* Adds to the end of `text`, an array of `room` bytes, as printf would; text that has
 * no room is cut off. No argument may lie in `text`. */
void pp_text_append(char *text, size_t room, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void pp_text_append_v(char *text, size_t room, const char *format, va_list arguments)
    __attribute__((format(printf, 3, 0)));

/* Adds `count` names (count < 0: up to a NULL) as "a, b and c", where `last` is
 * " and ". */
void pp_text_append_list(char *text, size_t room, const char *const *names, int count,
                         const char *last);

/* Letters to insert, leave out, change or swap with their neighbour to turn a into b,
 * capitals aside; names longer than 64 bytes are far from everything. */
int pp_text_edit_distance(const char *a, const char *b);

/* Nearest of `count` names (count < 0: up to a NULL) to the text typed; the first of
 * several equally near. At most one letter, or a third of the longer one's letters, may
 * differ; else it is the first name that contains the text ("oak": "oak-floor"). NULL
 * if none is similar. */
const char *pp_text_nearest(const char *typed, const char *const *names, int count);

/* "did you mean NAME?" with NAME between `before` and `after`, which may hold more than
 * quotes; empty where name is NULL. No other place of the program has these words. */
const char *pp_text_did_you_mean(char *text, size_t room, const char *before,
                                 const char *name, const char *after);

/* Appends `; did you mean "nearest"?` if a name is similar to the text typed, else
 * nothing. */
void pp_text_append_nearest(char *text, size_t room, const char *typed,
                            const char *const *names, int count);

/* Fails with PP_BAD_INPUT because `typed` is not one of the names. The message begins
 * with `format` and its arguments ("there is no chart \"paln\""). It continues with ";
 * did you mean plan?" if a name is similar, else with `otherwise`, or with "; expected
 * a, b or c" if otherwise is NULL. */
enum pp_status pp_text_unknown(struct pp_error *err, const char *typed,
                               const char *const *names, int count,
                               const char *otherwise, const char *format, ...)
    __attribute__((format(printf, 6, 7)));

/* Writes the names as "a, b or c" to text, cut to its size. Returns text. */
const char *pp_text_list_names(char *text, size_t size, const char *const *names,
                               int count);

/* strcmp, called only where the first letters are alike: for the inner loop of a search. */
static inline bool pp_text_is_same(const char *a, const char *b)
{
    return a[0] == b[0] && strcmp(a, b) == 0;
}

/* True if the `length` bytes at text (1 or more) are the word. */
static inline bool pp_text_is_word(const char *word, const char *text, size_t length)
{
    return word[0] == text[0] && strncmp(word, text, length) == 0 && !word[length];
}

/* A space, a tab, or an end of a line. */
static inline bool pp_text_is_white(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* The bytes, 1 to 4, of the UTF-8 letter that starts the `left` bytes at text (1 at
 * least), and its number in *letter, which may be NULL; 0 if they do not start a
 * letter: overlong forms, surrogates and numbers above U+10FFFF are not letters. Reads
 * no byte behind a NUL. */
int pp_text_letter(const char *text, size_t left, int32_t *letter);

/* True if the text has no control characters, which a terminal would obey. */
bool pp_text_is_plain(const char *text);

/* Copy of a user's text for a message: control characters become '?', and it is cut to
 * some 40 letters followed by "...". Returns text. */
const char *pp_text_excerpt(char *text, size_t size, const char *written);

/* Reads the whole of text as one decimal number with a point ("2.6", "-.5", "1e-3"),
 * white space around it allowed. False, and *value untouched, for anything else: an
 * empty text, a comma, a unit behind, hexadecimal, inf, nan, or too large for a
 * double. */
bool pp_text_parse_number(const char *text, double *value);

#endif
