/* made_epw.h - builds weather files for tests, record by record. */
#ifndef PP_TESTS_LIB_MADE_EPW_H
#define PP_TESTS_LIB_MADE_EPW_H

#include <stdio.h>
#include <stdlib.h>

#include "formats/epw/epw.h"

/* A weather file under construction; `end` is written after each line. */
struct made_epw {
    char *text;
    size_t length;
    FILE *out;
    const char *end;
};

static inline void epw_begin(struct made_epw *made)
{
    *made = (struct made_epw){.end = "\n"};
    made->out = open_memstream(&made->text, &made->length);
}

static inline void epw_line(struct made_epw *made, const char *line)
{
    fprintf(made->out, "%s%s", line, made->end);
}

#define EPW_LOCATION "LOCATION,Brussels,-,BEL,made up,064510,50.90,4.53,1.0,58.0"

/* Writes the header lines; periods: text after "DATA PERIODS,". */
static inline void epw_header(struct made_epw *made, const char *leap,
                              const char *periods)
{
    epw_line(made, EPW_LOCATION);
    epw_line(made, "DESIGN CONDITIONS,0");
    epw_line(made, "TYPICAL/EXTREME PERIODS,0");
    epw_line(made, "GROUND TEMPERATURES,0");
    fprintf(made->out, "HOLIDAYS/DAYLIGHT SAVINGS,%s,3/26,10/28,0%s", leap, made->end);
    epw_line(made, "COMMENTS 1,\"an odd quotation mark");
    epw_line(made, "COMMENTS 2,");
    fprintf(made->out, "DATA PERIODS,%s%s", periods, made->end);
}

/* Writes one record with 35 fields; irradiances and illuminance are texts. */
static inline void epw_record(struct made_epw *made, int year, int month, int day,
                              int hour, int minute, const char *global,
                              const char *direct, const char *diffuse,
                              const char *diffuse_lx)
{
    fprintf(made->out,
            "%d,%d,%d,%d,%d,?9?9,10.0,7.5,84,101000,0,0,315,%s,%s,%s,999999,999999,%s,"
            "9999,240,3.1,8,8,20.0,77777,9,999999999,110,0.1,0,88,0.2,0,1%s",
            year, month, day, hour, minute, global, direct, diffuse, diffuse_lx,
            made->end);
}

/* Writes a day of equal hours. */
static inline void epw_day(struct made_epw *made, int year, int month, int day,
                           const char *diffuse_lx)
{
    for (int hour = 1; hour <= 24; hour++)
        epw_record(made, year, month, day, hour, 0, "9999", "9999", "9999", diffuse_lx);
}

/* Bytes of the file so far; epw_end frees them. */
static inline const char *epw_bytes(struct made_epw *made)
{
    fflush(made->out);
    return made->text;
}

static inline void epw_end(struct made_epw *made)
{
    fclose(made->out);
    free(made->text);
}

/* Reads the bytes as a weather file; said: the first mistake as "LINE: text", or "". */
static inline struct pp_epw *epw_parsed(const char *bytes, size_t length, char *said,
                                        size_t room)
{
    struct pp_mistakes mistakes;
    struct pp_error err = {PP_OK, ""};
    struct pp_epw *epw;
    pp_mistakes_init(&mistakes, "made.epw");
    enum pp_status status = pp_epw_parse(&epw, bytes, length, &mistakes, &err);
    said[0] = '\0';
    if (mistakes.count > 0)
        snprintf(said, room, "%d: %s", mistakes.list[0].line, mistakes.list[0].text);
    if ((status == PP_OK) != (epw != NULL)
        || (status == PP_BAD_INPUT) != (said[0] != 0))
        abort();
    pp_mistakes_clear(&mistakes);
    return epw;
}

static inline struct pp_epw *epw_made(struct made_epw *made, char *said, size_t room)
{
    const char *bytes = epw_bytes(made);
    return epw_parsed(bytes, made->length, said, room);
}

#endif
