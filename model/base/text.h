/* text.h - text put together piece by piece, in a place of fixed size. */
#ifndef PP_MODEL_SENTENCE_H
#define PP_MODEL_SENTENCE_H

#include <stdarg.h>
#include <stddef.h>

/* Adds to the end of `text`, of `room` bytes with its terminating NUL, as printf would;
 * what has no room is cut off. No argument may lie in `text`. */
void pp_append(char *text, size_t room, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void pp_append_v(char *text, size_t room, const char *format, va_list arguments)
    __attribute__((format(printf, 3, 0)));

/* Adds `count` names (count < 0: up to a NULL) as "a, b and c", where `last` is " and
 * ".
 */
void pp_append_list(char *text, size_t room, const char *const *names, int count,
                    const char *last);

#endif
