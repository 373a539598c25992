/* epw_lines.h - splits the bytes of a weather file into lines, and lines into fields.
 * Inside formats/epw/ only. */
#ifndef PP_FORMATS_EPW_EPW_LINES_H
#define PP_FORMATS_EPW_EPW_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/mistakes.h"

enum {
    PP_EPW_BYTES_MOST = 512 << 20,    /* a year of one-minute records takes 100
                                       * MiB */
    PP_EPW_LINE_BYTES_MOST = 1 << 16, /* the DESIGN CONDITIONS line has 1,000 */
    PP_EPW_FIELDS_MOST = 512,         /* maximum number of fields of a line */
    PP_EPW_MISTAKES_MOST = 20,
};

/* The bytes of a file, split into lines one after the other. */
struct pp_epw_lines {
    char *at, *end; /* *end is NUL */
    int line;       /* number of the last line returned, from 1 */
    int next_line;  /* number of the line at `at` */
};

/* Checks the bytes before they are split. Returns false, and adds the first mistake, if
 * they cannot be a weather file: UTF-16, NUL bytes, a line of more than
 * PP_EPW_LINE_BYTES_MOST bytes, more than PP_EPW_BYTES_MOST bytes, or empty. */
bool pp_epw_lines_check_bytes(const char *bytes, size_t length,
                              struct pp_mistakes *mistakes);

/* The next line that is not blank, or NULL. */
char *pp_epw_lines_next(struct pp_epw_lines *lines);

/* Splits a line at its commas. The fields point into the line, without surrounding
 * white space and quotes. Returns the number of fields, of which at most `most` are
 * stored. */
int pp_epw_lines_split(char *line, char *fields[], int most);

/* Appends text to a UTF-8 string on the heap; text that is not UTF-8 is read as
 * Latin-1. `before` is a separator, used if neither string is empty. False: out of
 * memory. */
bool pp_epw_lines_append_text(char **whole, const char *before, const char *text);

#endif
