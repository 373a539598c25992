/* epw.c - see epw.h. */
#include "formats/epw/epw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/epw/epw_header.h"
#include "model/base/array.h"
#include "model/base/read_file.h"
#include "model/base/text.h"

/* ---- records, in time order ---- */

/* State of the reader: position in the data periods, and date and hour of the next
 * expected record. */
struct record_reader {
    struct pp_epw *epw;
    const struct pp_epw_header *header;
    struct pp_mistakes *mistakes;
    int line;
    char *fields[PP_EPW_FIELDS_MOST];

    int period; /* index of the data period; period_count after the last */
    bool begun; /* true once a record of the period has been read */
    int years_left;
    struct pp_month_day date; /* expected date of the next record */
    int weekday;
    int hour;          /* 1 to 24 */
    int sub;           /* index of the record within the hour, from 0 */
    int minute;        /* minute of the previous record in this hour; -1: none */
    int space;         /* allocated length of epw->records */
    bool out_of_order; /* later records cannot be checked; reading stops */
};

static void start_period(struct record_reader *r)
{
    r->begun = false;
    r->hour = 1;
    r->sub = 0;
    r->minute = -1;
    if (r->period == r->header->period_count)
        return;
    const struct pp_epw_period *period = &r->header->periods[r->period];
    r->years_left = period->years;
    r->date = period->from;
    r->weekday = period->weekday;
}

/* Returns the day after `date`; 28 February is always followed by 29 February. */
static struct pp_month_day day_after(struct pp_month_day date)
{
    if (date.day < pp_month_day_days_of_month(date.month))
        return (struct pp_month_day){date.month, date.day + 1};
    return (struct pp_month_day){date.month % 12 + 1, 1};
}

/* Advances to the next expected record. */
static void step_on(struct record_reader *r)
{
    r->begun = true;
    if (++r->sub < r->header->records_an_hour)
        return;
    r->sub = 0;
    r->minute = -1;
    if (++r->hour <= 24)
        return;
    r->hour = 1;
    bool ends = pp_month_day_same(r->date, r->header->periods[r->period].to);
    if (ends && r->years_left-- == 0) {
        r->period++;
        start_period(r);
        return;
    }
    r->date = day_after(r->date);
    if (r->weekday != PP_WEEKDAY_UNKNOWN)
        r->weekday = (r->weekday + 1) % 7;
}

/* Reads a whole number from `low` to `high`; for other text adds a mistake and returns
 * false. */
static bool read_whole(struct record_reader *r, int index, const char *name, int low,
                       int high, int *whole)
{
    double value;
    char shown[64];
    if (pp_text_parse_number(r->fields[index], &value) && value == floor(value)
        && value >= low && value <= high) {
        *whole = (int)value;
        return true;
    }
    pp_mistakes_add(r->mistakes, r->line, "%s (field %d) is \"%s\"; expected %d to %d",
                    name, index + 1,
                    pp_text_excerpt(shown, sizeof shown, r->fields[index]), low, high);
    return false;
}

/* Adds a mistake that names the found and the expected record; stops reading. */
static bool fail_order(struct record_reader *r, struct pp_month_day date, int hour)
{
    char found[32], wanted[32];
    r->out_of_order = true;
    pp_mistakes_add(r->mistakes, r->line,
                    "this is a record of %s, hour %d, but %s, hour %d was expected: "
                    "records are missing or out of order",
                    pp_month_day_words(found, sizeof found, date), hour,
                    pp_month_day_words(wanted, sizeof wanted, r->date), r->hour);
    return false;
}

/* Returns true, adds a mistake and stops reading if the record is after the last data
 * period. */
static bool is_after_last(struct record_reader *r)
{
    if (r->period < r->header->period_count)
        return false;
    pp_mistakes_add(r->mistakes, r->line,
                    "this record is after the end of the last data period on line %d",
                    r->header->periods_line);
    r->out_of_order = true;
    return true;
}

/* If 29 February is the next expected day but the file continues with another day, 1
 * March becomes the expected day. Returns false, with a mistake, if 29 February is
 * missing although the header declares a leap year, or is present although the header
 * declares a common year and the record's year is not a leap year, or if the record is
 * after the last data period. */
static bool settle_leap_day(struct record_reader *r, struct pp_month_day found,
                            int year)
{
    enum pp_epw_leap leap = r->header->leap;
    bool due = pp_month_day_same(r->date, (struct pp_month_day){2, 29});
    bool there = pp_month_day_same(found, (struct pp_month_day){2, 29});
    if (!due || r->hour != 1 || r->sub != 0)
        return true;
    if (there && leap == PP_LEAP_NO && !pp_month_day_is_leap(year)) {
        pp_mistakes_add(r->mistakes, r->line,
                        "there is a record for 29 February %d, but %d is not a leap "
                        "year according to line %d",
                        year, year, r->header->leap_line);
        r->out_of_order = true;
        return false;
    }
    if (!there && leap == PP_LEAP_YES) {
        pp_mistakes_add(r->mistakes, r->line,
                        "the record for 29 February is missing before this one, "
                        "although line %d says that the year is a leap year",
                        r->header->leap_line);
        r->out_of_order = true;
        return false;
    }
    if (there)
        return true;
    r->date = (struct pp_month_day){3, 1};
    bool ends = r->begun && r->years_left == 0
                && pp_month_day_same(r->header->periods[r->period].to,
                                     (struct pp_month_day){2, 29});
    if (!ends)
        return true;
    r->period++;
    start_period(r);
    return !is_after_last(r);
}

/* Checks that minutes increase within an hour; 0 in the last record stands for 60. */
static bool check_minute(struct record_reader *r, int minute)
{
    bool last = r->sub == r->header->records_an_hour - 1;
    if (minute == 0 && last && r->sub > 0)
        minute = 60;
    if (minute > r->minute) {
        r->minute = minute;
        return true;
    }
    pp_mistakes_add(r->mistakes, r->line,
                    "minute %d (field 5) follows minute %d of the same hour; expected "
                    "%d records per hour, in order",
                    minute, r->minute, r->header->records_an_hour);
    r->out_of_order = true;
    return false;
}

/* Reads the record's time and checks that it is the expected one. */
static bool read_time(struct record_reader *r, struct pp_epw_record *record)
{
    int month, day, hour, minute;
    if (!read_whole(r, 0, "the year", 1800, 2200, &record->year)
        || !read_whole(r, 1, "the month", 1, 12, &month)
        || !read_whole(r, 2, "the day", 1, pp_month_day_days_of_month(month), &day)
        || !read_whole(r, 3, "the hour", 1, 24, &hour)
        || !read_whole(r, 4, "the minute", 0, 60, &minute)) {
        r->out_of_order = true;
        return false;
    }
    record->date = (struct pp_month_day){month, day};
    if (!settle_leap_day(r, record->date, record->year))
        return false;
    if (!pp_month_day_same(record->date, r->date) || hour != r->hour)
        return fail_order(r, record->date, hour);
    record->weekday = r->weekday;
    record->start_h = r->hour - 1 + r->sub * r->epw->record_h;
    return check_minute(r, minute);
}

/* Data loggers write these numbers for a missing value. */
static bool is_mark_of_loggers(double value)
{
    return value == -999.0 || value == -9999.0;
}

/* Reads a measured value from low to high; NAN if it is missing. */
static double read_value(struct record_reader *r, int index, const char *name,
                         double low, double high, double missing)
{
    double value;
    char shown[64];
    const char *text = r->fields[index];
    if (!*text)
        return NAN;
    if (pp_text_parse_number(text, &value)) {
        if (value >= missing || is_mark_of_loggers(value))
            return NAN;
        if (value >= low && value <= high)
            return value;
    }
    pp_mistakes_add(
        r->mistakes, r->line,
        "%s (field %d) is \"%s\"; expected %g to %g, or %g for a missing value", name,
        index + 1, pp_text_excerpt(shown, sizeof shown, text), low, high, missing);
    return NAN;
}

static void read_values(struct record_reader *r, struct pp_epw_record *record)
{
    record->dew_point_c = read_value(r, 7, "the dew point", -90.0, 70.0, 99.9);
    record->global_w_m2 =
        read_value(r, 13, "global horizontal irradiance", 0.0, 2000.0, 9999.0);
    record->direct_w_m2 =
        read_value(r, 14, "direct normal irradiance", 0.0, 2000.0, 9999.0);
    record->diffuse_w_m2 =
        read_value(r, 15, "diffuse horizontal irradiance", 0.0, 2000.0, 9999.0);
    record->diffuse_lx =
        read_value(r, 18, "diffuse horizontal illuminance", 0.0, 250000.0, 999900.0);
}

/* Returns the total sky cover as a fraction (the file has tenths). NAN if the field is
 * missing or invalid. */
static double read_cloud_cover(const struct record_reader *r, int count)
{
    enum { TOTAL_SKY_COVER = 22 };
    double tenths;
    if (count <= TOTAL_SKY_COVER
        || !pp_text_parse_number(r->fields[TOTAL_SKY_COVER], &tenths)
        || !(tenths >= 0.0 && tenths <= 10.0))
        return NAN;
    return tenths / 10.0;
}

/* Adds the record of a line. False: out of memory. */
static bool read_record(struct record_reader *r, char *text)
{
    enum { FIELDS_NEEDED = 19 };
    int count = pp_epw_lines_split(text, r->fields, PP_EPW_FIELDS_MOST);
    if (count < FIELDS_NEEDED) {
        pp_mistakes_add(r->mistakes, r->line,
                        "the record has %d field%s; expected 35, or at least the "
                        "first %d, up to diffuse illuminance",
                        count, count == 1 ? "" : "s", FIELDS_NEEDED);
        r->out_of_order = true;
        return true;
    }
    if (is_after_last(r))
        return true;
    struct pp_epw *epw = r->epw;
    if (pp_array_reserve(&epw->records, &r->space, epw->record_count + 1,
                         sizeof *epw->records, NULL)
        != PP_OK)
        return false;
    struct pp_epw_record *record = &epw->records[epw->record_count];
    if (!read_time(r, record))
        return true;
    read_values(r, record);
    record->cloud_cover = read_cloud_cover(r, count);
    epw->record_count++;
    step_on(r);
    return true;
}

/* Adds a mistake if the file ends before its last data period does. */
static void check_end(struct record_reader *r)
{
    char wanted[32];
    struct pp_month_day leap_day = {2, 29};
    if (r->period == r->header->period_count)
        return;
    /* A period that ends on 29 February may lack that day in a common year. */
    bool leap_end = pp_month_day_same(r->date, leap_day) && r->hour == 1 && r->sub == 0
                    && pp_month_day_same(r->header->periods[r->period].to, leap_day)
                    && r->header->leap != PP_LEAP_YES;
    if (leap_end && r->begun && r->period == r->header->period_count - 1
        && r->years_left == 0)
        return;
    pp_mistakes_add(
        r->mistakes, r->line,
        "the file ends here, but a record of %s, hour %d was expected: the file is "
        "incomplete, or data period %d is shorter than line %d says",
        pp_month_day_words(wanted, sizeof wanted, r->date), r->hour, r->period + 1,
        r->header->periods_line);
}

/* Removes illuminances of 9999 lx that mean "missing"; the format defines 999999, but
 * some converters write 9999. The value is treated as missing in the whole file if any
 * record without irradiance has it. */
static void drop_marks(struct pp_epw *epw)
{
    const double mark = 9999.0;
    bool marked = false;
    for (int i = 0; i < epw->record_count && !marked; i++) {
        const struct pp_epw_record *record = &epw->records[i];
        marked = record->diffuse_lx == mark && record->global_w_m2 == 0.0
                 && record->diffuse_w_m2 == 0.0;
    }
    for (int i = 0; i < epw->record_count && marked; i++)
        if (epw->records[i].diffuse_lx == mark)
            epw->records[i].diffuse_lx = NAN;
}

/* Replaces summer time given in words, "Last Sunday in April", by dates in the year of
 * the first record. */
static void settle_summer(struct pp_epw *epw)
{
    char *to = strstr(epw->summer_words, " to ");
    struct pp_month_day first, last;
    if (!to || epw->record_count == 0)
        return;
    *to = '\0';
    bool found =
        pp_month_day_parse_words(epw->summer_words, epw->records[0].year, &first)
        && pp_month_day_parse_words(to + 4, epw->records[0].year, &last);
    *to = ' ';
    if (!found)
        return;
    epw->summer_from = first;
    epw->summer_to = last;
    epw->summer_words[0] = '\0';
}

/* Reads the records into epw, beginning with `record`. Returns PP_OK even if there are
 * mistakes. */
static enum pp_status read_epw_records(struct pp_epw *epw,
                                       const struct pp_epw_header *header,
                                       struct pp_epw_lines *lines, char *record,
                                       struct pp_mistakes *mistakes,
                                       struct pp_error *err)
{
    struct record_reader r = {.epw = epw, .header = header, .mistakes = mistakes};
    int before = mistakes->count;
    epw->record_h = 1.0 / header->records_an_hour;
    start_period(&r);
    for (; record; record = pp_epw_lines_next(lines)) {
        r.line = lines->line;
        if (!read_record(&r, record))
            return pp_fail_memory(err);
        mistakes->truncated |= mistakes->count - before >= PP_EPW_MISTAKES_MOST;
        if (r.out_of_order || mistakes->truncated)
            return PP_OK;
    }
    r.line = lines->line;
    if (mistakes->count == before)
        check_end(&r);
    drop_marks(epw);
    settle_summer(epw);
    return PP_OK;
}

/* ---- a file ---- */

/* Reads header and records from a writable, NUL-terminated copy of the file's bytes. */
static enum pp_status read_epw_copy(struct pp_epw *epw, char *bytes, size_t length,
                                    struct pp_mistakes *mistakes, struct pp_error *err)
{
    struct pp_epw_header *header = calloc(1, sizeof *header);
    if (!header)
        return pp_fail_memory(err);
    struct pp_epw_lines lines = {.at = bytes, .end = bytes + length, .next_line = 1};
    if (strncmp(bytes, "\xEF\xBB\xBF", 3) == 0)
        lines.at += 3;
    char *record;
    struct pp_error memory = {PP_OK, ""};
    enum pp_status status = PP_OK;
    if (pp_epw_header_read(epw, header, &lines, &record, mistakes, &memory))
        status = read_epw_records(epw, header, &lines, record, mistakes, err);
    else if (memory.status != PP_OK)
        status = pp_fail_memory(err);
    free(header);
    return status;
}

enum pp_status pp_epw_parse(struct pp_epw **epw, const char *bytes, size_t length,
                            struct pp_mistakes *mistakes, struct pp_error *err)
{
    int before = mistakes->count;
    enum pp_status status = PP_OK;
    *epw = NULL;
    struct pp_epw *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    if (pp_epw_lines_check_bytes(bytes, length, mistakes)) {
        char *copy = malloc(length + 1);
        if (copy) {
            memcpy(copy, bytes, length);
            copy[length] = '\0';
            status = read_epw_copy(made, copy, length, mistakes, err);
        } else {
            status = pp_fail_memory(err);
        }
        free(copy);
    }
    if (status == PP_OK && (mistakes->count > before || mistakes->truncated))
        status =
            pp_fail(err, PP_BAD_INPUT, "%s: the file cannot be read as a weather file",
                    mistakes->file ? mistakes->file : "weather file");
    if (status == PP_OK)
        *epw = made;
    else
        pp_epw_destroy(made);
    return status;
}

enum pp_status pp_epw_read(struct pp_epw **epw, const char *path,
                           struct pp_mistakes *mistakes, struct pp_error *err)
{
    char *bytes;
    size_t length;
    *epw = NULL;
    enum pp_status status = pp_read_file(&bytes, &length, path, PP_EPW_BYTES_MOST, err);
    if (status == PP_OK)
        status = pp_epw_parse(epw, bytes, length, mistakes, err);
    free(bytes);
    return status;
}

void pp_epw_destroy(struct pp_epw *epw)
{
    if (!epw)
        return;
    free(epw->place);
    free(epw->records);
    free(epw);
}
