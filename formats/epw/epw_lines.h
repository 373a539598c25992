/* epw_lines.h - from a weather file's bytes to lines, and from a line to fields. Inside
 * formats/epw/ only. */
#ifndef PP_FORMATS_EPW_EPW_LINES_H
#define PP_FORMATS_EPW_EPW_LINES_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/mistakes.h"

enum {
    PP_EPW_BYTES_MOST = 512 << 20,    /* a year by the minute has 100 MiB */
    PP_EPW_LINE_BYTES_MOST = 1 << 16, /* "DESIGN CONDITIONS" has 1,000 */
    PP_EPW_FIELDS_MOST = 512,         /* that a line is split into */
    PP_EPW_MISTAKES_MOST = 20,
};

/* The file's bytes, which are cut into lines one after the other. */
struct pp_epw_lines {
    char *at, *end; /* *end is a NUL */
    int line;       /* number of the line given last, from 1 */
    int next_line;  /* number of the line at `at` */
};

/* Checks the bytes by themselves: false, with the first mistake noted, where they can't
 * be a weather file (UTF-16, NUL bytes, lines without an end, nothing at all). */
bool pp_epw_lines_check_bytes(const char *bytes, size_t length,
                              struct pp_mistakes *mistakes);

/* The next line that is not blank, or NULL. */
char *pp_epw_lines_next(struct pp_epw_lines *lines);

/* Splits a line at its commas; the fields lie in it, without the white space and quotes
 * round them. Returns how many fields the line has, of which `most` are stored. */
int pp_epw_lines_split(char *line, char *fields[], int most);

/* Appends text, Latin-1 where it is not UTF-8, to a UTF-8 string on the heap, with
 * `before` between the two where neither is empty; false when memory is out. */
bool pp_epw_lines_append_text(char **whole, const char *before, const char *text);

#endif
