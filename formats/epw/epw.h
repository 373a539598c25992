/* epw.h - a weather file in EnergyPlus format: where, when, and how much diffuse light.
 *
 * A file has header lines (LOCATION, ..., DATA PERIODS) and then a record a line, in
 * order of time, one or more an hour [EPW]. A record is of the time before its hour's
 * end: hour 1 is from 0:00 to 1:00, in local standard time without summer time. Of its
 * 35 fields those about time, dew point, irradiance and diffuse illuminance are read,
 * up to the 19th; further ones may be missing.
 *
 * Lines may end with LF, CR LF or CR; a byte order mark, blank lines, and white space
 * and quotes round fields are passed over.
 */
#ifndef PP_FORMATS_EPW_EPW_H
#define PP_FORMATS_EPW_EPW_H

#include <stdbool.h>
#include <stddef.h>

#include "formats/epw/month_day.h"
#include "model/base/error.h"
#include "model/base/mistakes.h"

enum { PP_WEEKDAY_UNKNOWN = -1 };

/* One record; NAN stands where the file marks a value as missing or leaves it empty. */
struct pp_epw_record {
    int year; /* of a typical year: that in which it was measured */
    struct pp_month_day date;
    int weekday;         /* 0 Monday to 6 Sunday, or PP_WEEKDAY_UNKNOWN */
    double start_h;      /* when it begins, local standard time, 0 to 24 */
    double dew_point_c;  /* degrees Celsius */
    double global_w_m2;  /* irradiance of a level plane */
    double direct_w_m2;  /* irradiance of a plane square to the sun, by the sun only */
    double diffuse_w_m2; /* irradiance of a level plane, by the sky only */
    double diffuse_lx;   /* illuminance of a level plane, by the sky only */
};

struct pp_epw {
    char *place;                                /* "Tokyo, JPN", UTF-8; owned */
    double latitude_rad, longitude_rad;         /* north and east positive */
    double time_zone_h;                         /* ahead of UT */
    double record_h;                            /* duration of a record: 1, 0.5, ... */
    struct pp_month_day summer_from, summer_to; /* first and last day of summer time */
    char summer_words[160]; /* the file's own words for it, where they are no dates */
    int summer_line;
    int record_count;
    struct pp_epw_record *records; /* in the file's order; owned */
};

/* Reads a file; path "-" is standard input. What is wrong in it goes to mistakes, the
 * first twenty of them (PP_BAD_INPUT), with their lines; a file that can't be read at
 * all has its reason in err only. *epw is the caller's, NULL where this fails. */
enum pp_status pp_epw_read(struct pp_epw **epw, const char *path,
                           struct pp_mistakes *mistakes, struct pp_error *err);

/* The same from memory; the bytes are not changed. */
enum pp_status pp_epw_parse(struct pp_epw **epw, const char *bytes, size_t length,
                            struct pp_mistakes *mistakes, struct pp_error *err);

void pp_epw_destroy(struct pp_epw *epw); /* NULL is allowed */

#endif
