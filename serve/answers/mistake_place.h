/* mistake_place.h - finds the position of an error in the text of a room file. For use
 * inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_MISTAKE_PLACE_H
#define PP_SERVE_ANSWERS_MISTAKE_PLACE_H

#include <stddef.h>

/* Lines and columns are counted from 1; columns are characters. The end is
 * exclusive. */
struct pp_mistake_place {
    int line, column, end_line, end_column;
};

/* Finds the attribute or element named by the message `sentence`, for an error on
 * `line`. If it is not found, returns the whole line. An element may begin on an
 * earlier line. text: the room file in UTF-8. */
struct pp_mistake_place pp_mistake_place_find(const char *text, size_t length, int line,
                                              const char *sentence);

#endif
