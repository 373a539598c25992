/* text.h - text assembled in an array of fixed size; suggestions for mistyped names;
 * numbers with a decimal point in any locale. */
#ifndef PP_MODEL_BASE_TEXT_H
#define PP_MODEL_BASE_TEXT_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "model/base/error.h"

/* Appends to `text`, an array of `room` bytes, like printf; excess text is cut off.
 * Arguments must not be part of `text`. */
void pp_text_append(char *text, size_t room, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void pp_text_append_v(char *text, size_t room, const char *format, va_list arguments)
    __attribute__((format(printf, 3, 0)));

/* Appends `count` names (count < 0: up to a NULL) as "a, b and c"; `last` is " and
 * ". */
void pp_text_append_list(char *text, size_t room, const char *const *names, int count,
                         const char *last);

/* Number of letters to insert, delete, replace or swap with a neighbour to turn a into
 * b, ignoring case. Names longer than 64 bytes have a large distance from all
 * others. */
int pp_text_edit_distance(const char *a, const char *b);

/* Nearest of `count` names (count < 0: up to a NULL) to the typed text; the first of
 * several equally near. At most one letter, or a third of the letters of the longer
 * one, may differ. If no name is near, the first name that contains a text of three
 * letters or more ("oak": "oak-floor"). NULL if none is similar. */
const char *pp_text_nearest(const char *typed, const char *const *names, int count);

/* Writes "did you mean NAME?" with NAME between `before` and `after` (quotation marks,
 * or longer texts); empty if name is NULL. All suggestions of the program use this
 * function. */
const char *pp_text_did_you_mean(char *text, size_t room, const char *before,
                                 const char *name, const char *after);

/* Appends `; did you mean "nearest"?` if a name is similar to the typed text. */
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

/* True if the strings are equal. Calls strcmp only if the first characters are equal,
 * for the inner loop of a search. */
static inline bool pp_text_is_same(const char *a, const char *b)
{
    return a[0] == b[0] && strcmp(a, b) == 0;
}

/* True if the `length` bytes at text (1 or more) are the word. */
static inline bool pp_text_is_word(const char *word, const char *text, size_t length)
{
    return word[0] == text[0] && strncmp(word, text, length) == 0 && !word[length];
}

/* True for a space, a tab, or a line end. */
static inline bool pp_text_is_white(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* Decodes the UTF-8 character that begins the `left` bytes (1 or more) at text. Returns
 * its length, 1 to 4 bytes, and its code point in *letter, which may be NULL. Returns 0
 * for invalid UTF-8: overlong forms, surrogates and code points above U+10FFFF. Reads
 * no byte after a NUL. */
int pp_text_letter(const char *text, size_t left, int32_t *letter);

/* True if the text has no control characters, which a terminal would interpret. */
bool pp_text_is_plain(const char *text);

/* Copies a user's text for a message: control characters become '?', and it is cut to
 * about 40 letters followed by "...". Returns text. */
const char *pp_text_excerpt(char *text, size_t size, const char *written);

/* Reads the whole text as one decimal number with a point ("2.6", "-.5", "1e-3");
 * surrounding white space is allowed. False, with *value unchanged, for other text:
 * empty, with a comma, with a unit, hexadecimal, inf, nan, or too large for a
 * double. */
bool pp_text_parse_number(const char *text, double *value);

#endif
