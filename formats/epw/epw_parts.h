/* epw_parts.h - what the files of epw.h share. Inside formats/epw/ only. */
#ifndef PP_FORMATS_EPW_EPW_PARTS_H
#define PP_FORMATS_EPW_EPW_PARTS_H

#include "formats/epw/epw.h"

enum {
    PP_EPW_BYTES_MOST = 512 << 20,    /* a year by the minute has 100 MiB */
    PP_EPW_LINE_BYTES_MOST = 1 << 16, /* "DESIGN CONDITIONS" has 1,000 */
    PP_EPW_FIELDS_MOST = 512,         /* of which a line is split */
    PP_EPW_MISTAKES_MOST = 20,
    PP_EPW_PERIODS_MOST = 100,
};

/* The file's bytes, cut into lines on the way. */
struct pp_epw_lines {
    char *at, *end; /* *end is a NUL */
    int line;       /* of the one last given, from 1 */
    int next_line;  /* of the one at `at` */
};

/* What can be said of the bytes alone: false, with the first mistake noted, where they
 * are none of an EPW file (UTF-16, NUL bytes, lines without an end, nothing at all). */
bool pp_epw_lines_check_bytes(const char *bytes, size_t length,
                              struct pp_mistakes *mistakes);

/* The next line that is not blank, or NULL. */
char *pp_epw_lines_next(struct pp_epw_lines *lines);

/* Splits a line at its commas; the fields lie in it, without white space and quotes
 * round them. Returns how many there are; `most` are split at most. */
int pp_epw_lines_split(char *line, char *fields[], int most);

/* One of DATA PERIODS. */
struct pp_epw_period {
    struct pp_month_day from, to;
    int years;   /* how often `to` is passed before the end: 0 but of several years */
    int weekday; /* of its first day */
};

enum pp_epw_leap { PP_LEAP_UNSAID, PP_LEAP_NO, PP_LEAP_YES };

struct pp_epw_header {
    enum pp_epw_leap leap;
    int leap_line;
    int records_an_hour;
    int period_count, periods_line;
    struct pp_epw_period periods[PP_EPW_PERIODS_MOST];
};

/* Reads header lines into epw and header until the first record, which *record is
 * (NULL: the file ends first). False where there is a mistake. */
bool pp_epw_header_read(struct pp_epw *epw, struct pp_epw_header *header,
                        struct pp_epw_lines *lines, char **record,
                        struct pp_mistakes *mistakes, struct pp_error *err);

/* Reads the records into epw, from `record` on. PP_OK also where there are mistakes. */
enum pp_status pp_epw_records_read(struct pp_epw *epw,
                                   const struct pp_epw_header *header,
                                   struct pp_epw_lines *lines, char *record,
                                   struct pp_mistakes *mistakes, struct pp_error *err);

/* Appends text, Latin-1 where it is not UTF-8, to a UTF-8 string on the heap, with
 * `before` between them unless that is empty; false when memory is out. */
bool pp_epw_lines_append_text(char **whole, const char *before, const char *text);

#endif
