/* mistake_place.h - position of a mistake in the text of a room file. Inside serve/
 * only. */
#ifndef PP_SERVE_ANSWERS_MISTAKE_PLACE_H
#define PP_SERVE_ANSWERS_MISTAKE_PLACE_H

#include <stddef.h>

/* Lines and columns from 1, columns in characters; the end is exclusive. */
struct pp_mistake_place {
    int line, column, end_line, end_column;
};

/* Finds the attribute or element that the message `sentence` names, for a mistake on
 * `line`; the whole line if it is not found. An element may begin on an earlier line.
 * text: the room file, UTF-8. */
struct pp_mistake_place pp_mistake_place_find(const char *text, size_t length, int line,
                                              const char *sentence);

#endif
