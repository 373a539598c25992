/* names.h - what somebody who mistyped a name may have meant. */
#ifndef PP_MODEL_NEAREST_H
#define PP_MODEL_NEAREST_H

#include <stdbool.h>
#include <stddef.h>

/* Letters to insert, leave out, change or swap with their neighbour to turn a into b,
 * capitals aside; names longer than 64 bytes are far from everything. */
int pp_edit_distance(const char *a, const char *b);

/* The nearest of `count` names (count < 0: up to a NULL) to what was typed, the first
 * of several as near: at most one letter differs, or a third of the longer's letters;
 * else the first that contains it ("oak": "oak-floor"). NULL where none is like it. */
const char *pp_nearest(const char *typed, const char *const *names, int count);

/* Writes the names as "a, b or c" to text, cut to its size. Returns text. */
const char *pp_name_list(char *text, size_t size, const char *const *names, int count);

/* Has the text no control characters (which a terminal would obey)? */
bool pp_is_plain(const char *text);

/* A copy of what a user wrote, fit for a message: control characters as '?', and cut
 * to some 40 letters with "..." behind. Returns text. */
const char *pp_excerpt(char *text, size_t size, const char *written);

#endif
