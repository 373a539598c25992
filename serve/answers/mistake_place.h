/* mistake_place.h - where on its line a mistake of a room file is. Inside serve/ only. */
#ifndef PP_SERVE_ANSWERS_MISTAKE_PLACE_H
#define PP_SERVE_ANSWERS_MISTAKE_PLACE_H

#include <stddef.h>

/* Lines and columns from 1, columns in characters; the end is behind the last one. */
struct pp_mistake_place {
    int line, column, end_line, end_column;
};

/* The attribute or element that the sentence of a mistake on `line` names, else the line.
 * The line is the attribute's, or where the element begins. text: of the room file, UTF-8. */
struct pp_mistake_place pp_mistake_place_find(const char *text, size_t length, int line,
                                              const char *sentence);

#endif
