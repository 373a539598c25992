/* availability_options.c - reads working hours, days, summer time and illuminances,
 * and loads the weather file. */
#include "cli/availability/availability_options.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cli/message.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/geometry/vec.h"

/* ---- parsing ---- */

/* Reads a time such as "8" or "17:30" at *text, in hours, and advances *text past the
 * time. Returns false if the time is invalid. */
static bool read_clock(const char **text, double *hour)
{
    int hours = 0, minutes = 0, used = 0;
    if (!isdigit((unsigned char)**text) || sscanf(*text, "%2d%n", &hours, &used) != 1)
        return false;
    *text += used;
    if (**text == ':') {
        ++*text;
        if (!isdigit((unsigned char)(*text)[0]) || !isdigit((unsigned char)(*text)[1]))
            return false;
        minutes = 10 * ((*text)[0] - '0') + (*text)[1] - '0';
        *text += 2;
    }
    *hour = hours + minutes / 60.0;
    return minutes < 60 && *hour <= 24.0;
}

static enum pp_status read_hours(const char *text, void *place, struct pp_error *err)
{
    struct pp_clock_times times = {0};
    for (const char *p = text; times.count < PP_PERIODS_MOST; p++) {
        struct pp_working_hours *hours = &times.list[times.count++];
        hours->days = PP_ALL_DAYS;
        if (!read_clock(&p, &hours->from_h) || *p++ != '-'
            || !read_clock(&p, &hours->to_h) || !(hours->from_h < hours->to_h))
            break;
        if (*p == '\0') {
            *(struct pp_clock_times *)place = times;
            return PP_OK;
        }
        if (*p != ',')
            break;
    }
    return pp_fail(err, PP_BAD_INPUT,
                   "up to %d periods FROM-TO, separated by commas, each within one "
                   "day, such as 9-17 or 8-18,8:30-17",
                   PP_PERIODS_MOST);
}

static int read_day(const char *text, size_t length)
{
    for (int i = 0; i < 7; i++)
        if (length == 3 && strncasecmp(text, pp_year_light_day_names[i], 3) == 0)
            return i;
    return -1;
}

static enum pp_status read_days(const char *text, void *place, struct pp_error *err)
{
    unsigned days = 0;
    if (strcmp(text, "all") == 0) {
        *(unsigned *)place = PP_ALL_DAYS;
        return PP_OK;
    }
    for (const char *p = text;; p++) {
        size_t length = strcspn(p, ",-");
        int from = read_day(p, length), to = from;
        p += length;
        if (from >= 0 && *p == '-') {
            length = strcspn(++p, ",");
            to = read_day(p, length);
            p += length;
        }
        if (from < 0 || to < 0)
            break;
        for (int day = from; day != to; day = (day + 1) % 7)
            days |= 1u << day;
        days |= 1u << to;
        if (*p == '\0') {
            *(unsigned *)place = days;
            return PP_OK;
        }
        if (*p != ',')
            break;
    }
    return pp_fail(err, PP_BAD_INPUT,
                   "all, or days of the week such as mon-fri or mon,wed,sat");
}

static enum pp_status read_summer(const char *text, void *place, struct pp_error *err)
{
    struct pp_summer_choice choice = {0};
    char from[16];
    size_t length = strcspn(text, "-");
    bool good = strcmp(text, "no") == 0;
    if (strcmp(text, "file") == 0) {
        good = choice.of_file = true;
    } else if (text[length] == '-' && length < sizeof from) {
        memcpy(from, text, length);
        from[length] = '\0';
        good = pp_month_day_parse(from, &choice.time.from)
               && pp_month_day_parse(text + length + 1, &choice.time.to);
    }
    if (!good)
        return pp_fail(err, PP_BAD_INPUT,
                       "no, file, or the first and last day as MONTH/DAY-MONTH/DAY, "
                       "such as 3/30-10/26");
    *(struct pp_summer_choice *)place = choice;
    return PP_OK;
}

/* Reads an illuminance of `length` bytes: "300", "300lx" or "300 lx". */
static bool read_lux(const char *text, size_t length, double *lx)
{
    char copy[32];
    if (length >= sizeof copy)
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    if (length > 2 && strcmp(copy + length - 2, "lx") == 0)
        copy[length - 2] = '\0';
    return pp_text_parse_number(copy, lx) && *lx >= 0.1 && *lx <= 1e6;
}

static enum pp_status read_illuminances(const char *text, void *place,
                                        struct pp_error *err)
{
    struct pp_illuminances wanted = {0};
    for (const char *p = text; wanted.count < PP_ILLUMINANCES_MOST; p++) {
        size_t length = strcspn(p, ",");
        if (!read_lux(p, length, &wanted.lx[wanted.count++]))
            break;
        p += length;
        if (*p == '\0') {
            *(struct pp_illuminances *)place = wanted;
            return PP_OK;
        }
    }
    return pp_fail(err, PP_BAD_INPUT,
                   "up to %d illuminances from 0.1 to 1000000 lx, separated by "
                   "commas, such as 300,500",
                   PP_ILLUMINANCES_MOST);
}

static enum pp_status read_within(const char *text, double *place, double low,
                                  double high, const char *what, struct pp_error *err)
{
    double value;
    if (!pp_text_parse_number(text, &value) || value < low || value > high)
        return pp_fail(err, PP_BAD_INPUT, "%s from %g to %g", what, low, high);
    *place = value;
    return PP_OK;
}

static enum pp_status read_latitude(const char *text, void *place, struct pp_error *err)
{
    return read_within(text, place, -90.0, 90.0, "degrees north", err);
}

static enum pp_status read_longitude(const char *text, void *place,
                                     struct pp_error *err)
{
    return read_within(text, place, -180.0, 180.0, "degrees east", err);
}

static enum pp_status read_zone(const char *text, void *place, struct pp_error *err)
{
    return read_within(text, place, -12.0, 14.0, "hours ahead of universal time", err);
}

#define PLACE(member) offsetof(struct pp_year_options, member)

const struct pp_option pp_light_options[] = {
    {"weather", 'w', "FILE.epw",
     "Use the diffuse illuminance in this EnergyPlus weather file; - is standard "
     "input. The default is an overcast sky all year at the latitude of the room.",
     pp_options_read_input, PLACE(weather)},
    {"latitude", 0, "DEG",
     "Latitude for the overcast sky, north positive (default: from the room's site).",
     read_latitude, PLACE(latitude_deg)},
    {"longitude", 0, "DEG",
     "Longitude, east positive (default: from the site, or from the time zone).",
     read_longitude, PLACE(longitude_deg)},
    {"time-zone", 0, "H",
     "Time zone of the clock, in hours ahead of universal time (default: nearest to "
     "the longitude).",
     read_zone, PLACE(time_zone_h)},
    {0},
};

const struct pp_option pp_working_time_options[] = {
    {"hours", 0, "H-H,...",
     "Working hours by the clock, such as 8:30-17 (default 8-18). availability has a "
     "curve for each of several periods (default 8-18,9-17).",
     read_hours, PLACE(hours)},
    {"days", 0, "DAYS",
     "Working days: all (default), or days such as mon-fri or mon,wed,sat.", read_days,
     PLACE(days)},
    {"summer-time", 0, "M/D-M/D",
     "First and last day of summer time (clock one hour ahead); file: as in the "
     "weather file; or no (default).",
     read_summer, PLACE(summer)},
    {0},
};

const struct pp_option pp_illuminance_options[] = {
    {"illuminance", 'i', "LX,...",
     "Target illuminances on the working plane, separated by commas (default "
     "300,500).",
     read_illuminances, PLACE(illuminances)},
    {0},
};

enum pp_status pp_availability_options_check(const struct pp_year_options *options,
                                             struct pp_error *err)
{
    const char *of_sky = !isnan(options->latitude_deg)    ? "--latitude"
                         : !isnan(options->longitude_deg) ? "--longitude"
                         : !isnan(options->time_zone_h)   ? "--time-zone"
                                                          : NULL;
    if (options->weather && of_sky)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s cannot be combined with --weather, since a weather file "
                       "already gives the location; expected one of them",
                       of_sky);
    if (options->summer.of_file && !options->weather)
        return pp_fail(err, PP_BAD_INPUT,
                       "--summer-time file needs a weather file; expected --weather "
                       "FILE, or the days");
    return PP_OK;
}

const char *pp_availability_options_typed(const struct pp_year_options *options)
{
    const struct pp_year_options *usual = &pp_year_options_default;
    bool hours = options->hours.count > usual->hours.count;
    for (int i = 0; i < options->hours.count && !hours; i++)
        hours = options->hours.list[i].from_h != usual->hours.list[i].from_h
                || options->hours.list[i].to_h != usual->hours.list[i].to_h;
    bool lux = options->illuminances.count != usual->illuminances.count;
    for (int i = 0; i < options->illuminances.count && !lux; i++)
        lux = options->illuminances.lx[i] != usual->illuminances.lx[i];
    bool summer = options->summer.of_file || options->summer.time.from.month;
    return hours                          ? "--hours"
           : options->days != usual->days ? "--days"
           : summer                       ? "--summer-time"
           : lux                          ? "--illuminance"
                                          : NULL;
}

/* ---- the light ---- */

/* Warns if solar time at the longitude differs from the time zone by more than 3 h,
 * modulo a day. Longitude or time zone then probably has the wrong sign. */
static enum pp_exit check_zone(const struct pp_year_options *options, bool strict)
{
    const struct pp_epw *epw = options->epw;
    double sun_h = epw->longitude_rad / PP_RAD / 15.0;
    double off_h = fabs(remainder(sun_h - epw->time_zone_h, 24.0));
    struct pp_mistakes doubts;
    if (!(off_h > 3.0))
        return PP_EXIT_DONE;
    pp_mistakes_init(&doubts, pp_read_file_title(options->weather));
    pp_mistakes_add(&doubts, 1,
                    "the longitude of %.4g degrees is %.1f h ahead of UT, but the "
                    "time zone is %.4g h ahead; check the signs of both",
                    epw->longitude_rad / PP_RAD, sun_h, epw->time_zone_h);
    pp_message_warnings(&doubts, strict);
    pp_mistakes_clear(&doubts);
    return strict ? PP_EXIT_INPUT : PP_EXIT_DONE;
}

enum pp_exit pp_availability_options_load(struct pp_year_options *options, bool strict)
{
    if (!options->weather)
        return PP_EXIT_DONE;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, pp_read_file_title(options->weather));
    enum pp_status status =
        pp_epw_read(&options->epw, options->weather, &mistakes, &err);
    enum pp_exit result = PP_EXIT_DONE;
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        result = pp_message_mistakes(&mistakes);
    else if (status != PP_OK)
        result = pp_message_error(&err);
    else if (options->summer.of_file && options->epw->summer_words[0]) {
        pp_fail(&err, PP_BAD_INPUT,
                "%s:%d: the summer time is \"%s\"; expected days as MONTH/DAY, or "
                "--summer-time M/D-M/D",
                pp_read_file_title(options->weather), options->epw->summer_line,
                options->epw->summer_words);
        result = pp_message_error(&err);
    }
    pp_mistakes_clear(&mistakes);
    return result == PP_EXIT_DONE ? check_zone(options, strict) : result;
}

enum pp_exit pp_availability_options_median(const struct pp_year_options *options,
                                            double *median_lx,
                                            struct pp_sunshine *sunshine)
{
    const char *path = options->weather;
    struct pp_diffuse_light light;
    struct pp_error err = {0};
    enum pp_status status =
        pp_diffuse_light_of_epw(&light, options->epw, pp_read_file_title(path), &err);
    *median_lx = NAN;
    *sunshine = pp_sunshine_of_epw(options->epw);
    if (status == PP_OK)
        status = pp_diffuse_light_median(median_lx, &light, &err);
    if (status == PP_OK && !(*median_lx > 0.0))
        status = pp_fail(&err, PP_BAD_INPUT,
                         "%s: there is no usable median illuminance for the year, "
                         "because data are missing or too many hours are dark",
                         pp_read_file_title(path));
    pp_diffuse_light_clear(&light);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

void pp_availability_options_clear(struct pp_year_options *options)
{
    pp_epw_destroy(options->epw);
    options->epw = NULL;
}
