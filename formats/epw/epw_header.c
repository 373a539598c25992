/* epw_header.c - see epw_header.h. */
#include "formats/epw/epw_header.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "model/base/text.h"
#include "model/geometry/vec.h"

/* State of the reader while it reads the header. */
struct header_reader {
    struct pp_epw *epw;
    struct pp_epw_header *header;
    struct pp_mistakes *mistakes;
    int line;
    int count; /* number of fields */
    char **fields;
    bool out_of_memory;
};

static const char *const weekdays[] = {"Monday", "Tuesday",  "Wednesday", "Thursday",
                                       "Friday", "Saturday", "Sunday"};
/* The field with that index; "" if there is none. */
static const char *field(const struct header_reader *r, int index)
{
    return index < r->count && index < PP_EPW_FIELDS_MOST ? r->fields[index] : "";
}

/* Reads a field as a number from low to high; for other text adds a mistake and returns
 * `low`. */
static double read_header_number(struct header_reader *r, int index, const char *name,
                                 double low, double high)
{
    double value;
    char shown[64];
    const char *text = field(r, index);
    if (pp_text_parse_number(text, &value) && value >= low && value <= high)
        return value;
    pp_mistakes_add(r->mistakes, r->line,
                    "%s is \"%s\"; expected a number from %g to %g", name,
                    pp_text_excerpt(shown, sizeof shown, text), low, high);
    return low;
}

static void read_location(struct header_reader *r)
{
    static const int names[] = {1, 2, 3}; /* city, state, country */
    struct pp_epw *epw = r->epw;
    if (epw->place) {
        pp_mistakes_add(r->mistakes, r->line,
                        "there is a second LOCATION line; expected only one");
        return;
    }
    r->out_of_memory |= !pp_epw_lines_append_text(&epw->place, "", "");
    for (int i = 0; i < 3; i++) {
        const char *name = field(r, names[i]);
        if (strcmp(name, "-") != 0)
            r->out_of_memory |= !pp_epw_lines_append_text(&epw->place, ", ", name);
    }
    epw->latitude_rad =
        PP_RAD * read_header_number(r, 6, "the latitude (field 7)", -90, 90);
    epw->longitude_rad =
        PP_RAD * read_header_number(r, 7, "the longitude (field 8)", -180, 180);
    epw->time_zone_h = read_header_number(r, 8, "the time zone (field 9)", -12, 14);
}

static bool is_leading_number(const char *text)
{
    text += *text == '"';
    return isdigit((unsigned char)text[0])
           || (text[0] == '-' && isdigit((unsigned char)text[1]));
}

/* Reads summer time and leap year; the holidays after them are ignored. */
static void read_holidays(struct header_reader *r)
{
    const char *leap = field(r, 1), *from = field(r, 2), *to = field(r, 3);
    char shown[64];
    r->header->leap_line = r->line;
    if (strcasecmp(leap, "yes") == 0)
        r->header->leap = PP_LEAP_YES;
    else if (strcasecmp(leap, "no") == 0)
        r->header->leap = PP_LEAP_NO;
    else if (*leap)
        pp_mistakes_add(
            r->mistakes, r->line,
            "the leap year entry (field 2) is \"%s\"; expected Yes, No or nothing",
            pp_text_excerpt(shown, sizeof shown, leap));

    struct pp_epw *epw = r->epw;
    bool none = (!*from || strcmp(from, "0") == 0) && (!*to || strcmp(to, "0") == 0);
    epw->summer_line = r->line;
    if (none)
        return;
    if (!pp_month_day_parse(from, &epw->summer_from)
        || !pp_month_day_parse(to, &epw->summer_to)) {
        char first[64];
        epw->summer_from = epw->summer_to = (struct pp_month_day){0, 0};
        snprintf(epw->summer_words, sizeof epw->summer_words, "%s to %s",
                 pp_text_excerpt(first, sizeof first, from),
                 pp_text_excerpt(shown, sizeof shown, to));
    }
}

static int read_weekday(struct header_reader *r, const char *text)
{
    char shown[64];
    for (int i = 0; i < 7; i++)
        if (strcasecmp(text, weekdays[i]) == 0
            || (strlen(text) == 3 && strncasecmp(text, weekdays[i], 3) == 0))
            return i;
    if (*text)
        pp_mistakes_add(r->mistakes, r->line,
                        "a data period starts on \"%s\"; expected a day of the week, "
                        "such as Monday, or nothing",
                        pp_text_excerpt(shown, sizeof shown, text));
    return PP_WEEKDAY_UNKNOWN;
}

static void read_period(struct header_reader *r, int index)
{
    struct pp_epw_period *period = &r->header->periods[index];
    const char *from = field(r, 5 + 4 * index), *to = field(r, 6 + 4 * index);
    char a[64], b[64];
    int first = 0, last = 0;
    period->weekday = read_weekday(r, field(r, 4 + 4 * index));
    if (!pp_month_day_parse_dated(from, &period->from, &first)
        || !pp_month_day_parse_dated(to, &period->to, &last)) {
        pp_mistakes_add(
            r->mistakes, r->line,
            "data period %d is from \"%s\" to \"%s\"; expected two dates as MONTH/DAY",
            index + 1, pp_text_excerpt(a, sizeof a, from),
            pp_text_excerpt(b, sizeof b, to));
        return;
    }
    if (first > 0 && last > 0)
        period->years = last - first - pp_month_day_is_before(period->to, period->from);
    if (period->years < 0 || period->years > 200)
        pp_mistakes_add(
            r->mistakes, r->line,
            "data period %d ends before it begins, or lasts more than 200 years",
            index + 1);
}

static void read_periods(struct header_reader *r)
{
    struct pp_epw_header *header = r->header;
    if (header->period_count > 0) {
        pp_mistakes_add(r->mistakes, r->line,
                        "there is a second DATA PERIODS line; expected only one");
        return;
    }
    header->periods_line = r->line;
    double periods = read_header_number(r, 1, "the number of data periods (field 2)", 1,
                                        PP_EPW_PERIODS_MOST);
    double an_hour =
        read_header_number(r, 2, "the number of records per hour (field 3)", 1, 60);
    header->period_count = (int)periods;
    header->records_an_hour = (int)an_hour;
    if (periods != header->period_count)
        pp_mistakes_add(r->mistakes, r->line,
                        "the number of data periods is %g; expected a whole number",
                        periods);
    if (60 % header->records_an_hour != 0 || an_hour != header->records_an_hour)
        pp_mistakes_add(
            r->mistakes, r->line,
            "there are %g records per hour; expected a whole number that divides 60",
            an_hour);
    if (r->count < 3 + 4 * header->period_count) {
        pp_mistakes_add(r->mistakes, r->line,
                        "DATA PERIODS has %d fields; expected %d (3, plus 4 per data "
                        "period; data periods: %d)",
                        r->count, 3 + 4 * header->period_count, header->period_count);
        return;
    }
    for (int i = 0; i < header->period_count; i++)
        read_period(r, i);
}

static void ignore(struct header_reader *r)
{
    (void)r;
}

/* Names of the header lines and the functions that read them. */
static const struct header_line {
    const char *name;
    void (*read)(struct header_reader *r);
} header_lines[] = {
    {"LOCATION", read_location},
    {"DESIGN CONDITIONS", ignore},
    {"TYPICAL/EXTREME PERIODS", ignore},
    {"GROUND TEMPERATURES", ignore},
    {"HOLIDAYS/DAYLIGHT SAVINGS", read_holidays},
    {"HOLIDAYS/DAYLIGHT SAVING", read_holidays},
    {"COMMENTS 1", ignore},
    {"COMMENTS 2", ignore},
    {"DATA PERIODS", read_periods},
};
enum { HEADER_LINES = sizeof header_lines / sizeof header_lines[0] };

static void read_header_line(struct header_reader *r)
{
    char shown[64];
    for (int i = 0; i < HEADER_LINES; i++)
        if (strcasecmp(r->fields[0], header_lines[i].name) == 0) {
            header_lines[i].read(r);
            return;
        }
    pp_mistakes_add(r->mistakes, r->line,
                    "the line starts with \"%s\"; expected a header line of an EPW "
                    "file or a record",
                    pp_text_excerpt(shown, sizeof shown, r->fields[0]));
}

/* True if the line begins like the first line of a weather file. */
static bool is_location(const char *line)
{
    return strncasecmp(line + (*line == '"'), "LOCATION", 8) == 0;
}

bool pp_epw_header_read(struct pp_epw *epw, struct pp_epw_header *header,
                        struct pp_epw_lines *lines, char **record,
                        struct pp_mistakes *mistakes, struct pp_error *err)
{
    char *fields[PP_EPW_FIELDS_MOST];
    struct header_reader r = {
        .epw = epw, .header = header, .mistakes = mistakes, .fields = fields};
    int before = mistakes->count;
    bool first = true;
    while ((*record = pp_epw_lines_next(lines)) && !is_leading_number(*record)) {
        r.line = lines->line;
        if (first && !is_location(*record)) {
            pp_mistakes_add(mistakes, r.line,
                            "this is not a weather file in EnergyPlus format (EPW); "
                            "expected LOCATION at the start of its first line");
            return false;
        }
        first = false;
        r.count = pp_epw_lines_split(*record, fields, PP_EPW_FIELDS_MOST);
        read_header_line(&r);
        if (mistakes->count - before >= PP_EPW_MISTAKES_MOST) {
            mistakes->truncated = true;
            return false;
        }
    }
    if (r.out_of_memory) {
        pp_fail_memory(err);
        return false;
    }
    if (!epw->place) {
        pp_mistakes_add(mistakes, lines->line,
                        "this is not a weather file in EnergyPlus format (EPW); "
                        "expected LOCATION at the start of its first line");
        return false;
    }
    if (header->period_count == 0)
        pp_mistakes_add(
            mistakes, lines->line,
            *record ? "the records begin here; expected a DATA PERIODS line before them"
                    : "the file ends here; expected a DATA PERIODS line");
    return mistakes->count == before;
}
