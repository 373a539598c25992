/* epw_header.h - the header lines of a weather file: its place, its data periods, leap
 * year and summer time. Inside formats/epw/ only. */
#ifndef PP_FORMATS_EPW_EPW_HEADER_H
#define PP_FORMATS_EPW_EPW_HEADER_H

#include "formats/epw/epw.h"
#include "formats/epw/epw_lines.h"

enum { PP_EPW_PERIODS_MOST = 100 };

/* One data period. */
struct pp_epw_period {
    struct pp_month_day from, to;
    int years;   /* number of times that the date `to` occurs before the last day: 0
                  * for a period of up to one year */
    int weekday; /* day of the week of `from` */
};

enum pp_epw_leap { PP_LEAP_UNSAID, PP_LEAP_NO, PP_LEAP_YES };

/* Settings for reading the records. */
struct pp_epw_header {
    enum pp_epw_leap leap;
    int leap_line;
    int records_an_hour;
    int period_count, periods_line;
    struct pp_epw_period periods[PP_EPW_PERIODS_MOST];
};

/* Reads header lines into epw and header up to the first record. *record is that
 * record, NULL if the file ends before it. Returns false after a mistake, or if memory
 * runs out (err is then set). */
bool pp_epw_header_read(struct pp_epw *epw, struct pp_epw_header *header,
                        struct pp_epw_lines *lines, char **record,
                        struct pp_mistakes *mistakes, struct pp_error *err);

#endif
