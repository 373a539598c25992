/* epw.h - a weather file in EnergyPlus format: place, times and diffuse light.
 *
 * A file has header lines (LOCATION, ..., DATA PERIODS), followed by one record per
 * line in order of time, one or more per hour [EPW]. A record covers the time before
 * the end of its hour: hour 1 is 0:00 to 1:00, in local standard time without summer
 * time. A record has 35 fields. The reader uses time, dew point, irradiance, diffuse
 * illuminance and total sky cover; fields after the 19th may be missing.
 *
 * Lines may end with LF, CR LF or CR. A byte order mark, blank lines, and white space
 * and quotes around fields are ignored.
 */
#ifndef PP_FORMATS_EPW_EPW_H
#define PP_FORMATS_EPW_EPW_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/epw/month_day.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

enum { PP_WEEKDAY_UNKNOWN = -1 };

/* One record; NAN if the file marks a value as missing or leaves it empty. */
struct pp_epw_record {
    int year; /* in a typical year: the year of measurement */
    struct pp_month_day date;
    int weekday;         /* 0 Monday to 6 Sunday, or PP_WEEKDAY_UNKNOWN */
    double start_h;      /* start of the record, hours of local standard time, 0 to
                          * 24 */
    double dew_point_c;  /* degrees Celsius */
    double global_w_m2;  /* irradiance on a horizontal plane */
    double direct_w_m2;  /* irradiance on a plane normal to the sun, sun only */
    double diffuse_w_m2; /* irradiance on a horizontal plane, sky only */
    double diffuse_lx;   /* illuminance on a horizontal plane, sky only */
    double cloud_cover;  /* share of the sky covered by clouds */
};

struct pp_epw {
    char *place;                        /* "Tokyo, JPN", UTF-8; owned */
    double latitude_rad, longitude_rad; /* north and east positive */
    double time_zone_h;                 /* ahead of UTC */
    double record_h;                    /* duration of a record: 1 h, 0.5 h, ... */
    struct pp_month_day summer_from, summer_to; /* first and last day of summer time */
    char summer_words[160]; /* summer time as in the file if it could not be read as two
                             * dates; else empty */
    int summer_line;
    int record_count;
    struct pp_epw_record *records; /* in the file's order; owned */
};

/* Reads a file; path "-" is standard input. PP_BAD_INPUT if the contents are invalid:
 * mistakes receives the first twenty errors, with their lines. If the file cannot be
 * read at all, only err has the reason. The caller owns *epw; it is NULL on failure. */
enum pp_status pp_epw_read(struct pp_epw **epw, const char *path,
                           struct pp_mistakes *mistakes, struct pp_error *err);

/* Reads the same format from memory; the bytes are not changed. */
enum pp_status pp_epw_parse(struct pp_epw **epw, const char *bytes, size_t length,
                            struct pp_mistakes *mistakes, struct pp_error *err);

void pp_epw_destroy(struct pp_epw *epw); /* NULL is allowed */

#endif
