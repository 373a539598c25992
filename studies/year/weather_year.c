/* weather_year.c - converts records to skies: the position of the sun, and the Perez
 * sky for it. */
#include "studies/year/weather_year.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/base/text.h"
#include "model/light/sun.h"

/* ---- the sun of a record ---- */

static struct pp_vec3 direction(const struct pp_sun *sun)
{
    double h = sun->altitude_rad, az = sun->bearing_rad;
    return pp_vec(cos(h) * sin(az), cos(h) * cos(az), sin(h));
}

static struct pp_sun sun_at(const struct pp_weather_year *year,
                            const struct pp_epw_record *record, double hour)
{
    const struct pp_epw *epw = year->epw;
    double n = pp_sun_days_since_2000(year->sun_year, record->date.month,
                                      record->date.day, hour - epw->time_zone_h);
    return pp_sun_at(n, epw->latitude_rad, epw->longitude_rad);
}

/* Mean direction of the sun over the part of the record in which the sun is up, from
 * minute to minute. Returns false if the sun is down throughout. */
static bool mean_risen_sun(const struct pp_weather_year *year,
                           const struct pp_epw_record *record, double middle_h,
                           struct pp_vec3 *mean)
{
    double length_h = year->epw->record_h;
    int steps = (int)ceil(60.0 * length_h);
    *mean = pp_vec(0.0, 0.0, 0.0);
    for (int i = 0; i < steps; i++) {
        double hour = middle_h + length_h * ((i + 0.5) / steps - 0.5);
        struct pp_sun sun = sun_at(year, record, hour);
        if (sun.altitude_rad > 0.0)
            *mean = pp_vec_add(*mean, direction(&sun));
    }
    if (!(mean->z > 0.0))
        return false;
    *mean = pp_vec_unit(*mean);
    return true;
}

/* ---- the sky of a record ---- */

/* Dew point of 2 cm of precipitable water, where a record has none. */
static const double DEW_POINT_C = 10.97;

static void count_limits(struct pp_weather_year *year, unsigned limits)
{
    year->positive_b += (limits & PP_PEREZ_B_POSITIVE) != 0;
    year->brightness += (limits & PP_PEREZ_BRIGHTNESS) != 0;
    year->clearness += (limits & PP_PEREZ_CLEARNESS) != 0;
    if (limits & PP_PEREZ_NO_DIFFUSE && year->no_diffuse++ == 0)
        year->first_no_diffuse = year->hours[year->count - 1];
}

static void add_sky(struct pp_weather_year *year, const struct pp_epw_record *record,
                    struct pp_weather_hour *hour)
{
    double middle_h = record->start_h + 0.5 * year->epw->record_h + year->sun_shift_h;
    struct pp_sun sun = sun_at(year, record, middle_h);
    struct pp_perez_conditions conditions = {.direct_w_m2 = record->direct_w_m2,
                                             .diffuse_w_m2 = record->diffuse_w_m2,
                                             .sun = direction(&sun),
                                             .sun_distance_au = sun.distance_au,
                                             .dew_point_c = record->dew_point_c};
    if (isnan(conditions.dew_point_c)) {
        conditions.dew_point_c = DEW_POINT_C;
        year->no_dew_point++;
    }
    if (record->direct_w_m2 > 0.0 && !(sun.altitude_rad > 0.0)) {
        struct pp_vec3 risen;
        bool is_up = mean_risen_sun(year, record, middle_h, &risen);
        if (is_up)
            conditions.sun = risen;
        else
            conditions.direct_w_m2 = 0.0;
        year->moved_suns += is_up;
        year->sunless_beams += !is_up;
    }
    struct pp_perez_sky sky = pp_perez_sky_of(&conditions);
    if (!(sky.diffuse_lx > 0.0) && !(sky.direct_lx > 0.0))
        return;
    count_limits(year, sky.limits);
    hour->lit = true;
    hour->sky = year->sky_count;
    year->skies[year->sky_count++] = sky;
}

static void add_hour(struct pp_weather_year *year, const struct pp_epw_record *record,
                     const struct pp_weather_options *options)
{
    if (record->date.month == 2 && record->date.day == 29 && !options->leap_day) {
        year->leap_records++;
        return;
    }
    struct pp_weather_hour *hour = &year->hours[year->count++];
    *hour = (struct pp_weather_hour){.date = record->date,
                                     .weekday = record->weekday,
                                     .start_h = record->start_h,
                                     .length_h = year->epw->record_h,
                                     .sky = -1,
                                     .direct_w_m2 = record->direct_w_m2,
                                     .cloud_cover = record->cloud_cover};
    hour->known = !isnan(record->direct_w_m2) && !isnan(record->diffuse_w_m2);
    if (hour->known)
        add_sky(year, record, hour);
    year->missing += !hour->known;
}

enum pp_status pp_weather_year_of_epw(struct pp_weather_year *year,
                                      const struct pp_epw *epw,
                                      const struct pp_weather_options *options,
                                      const char *file, struct pp_error *err)
{
    *year = (struct pp_weather_year){.epw = epw,
                                     .closure = pp_sun_closure_of_epw(epw),
                                     .sun_year = pp_sun_closure_year(epw)};
    bool shifted = year->closure.finding == PP_CLOSURE_SHIFTED;
    year->sun_shift_h = !isnan(options->sun_shift_h) ? options->sun_shift_h
                        : shifted                    ? year->closure.best_h
                                                     : 0.0;
    double hours = epw->record_count * epw->record_h;
    if (hours < 8760.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the file has %g hours; expected the 8760 hours of a year",
                       file, hours);
    year->hours = calloc((size_t)epw->record_count, sizeof *year->hours);
    year->skies = calloc((size_t)epw->record_count, sizeof *year->skies);
    if (!year->hours || !year->skies) {
        pp_weather_year_clear(year);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < epw->record_count; i++)
        add_hour(year, &epw->records[i], options);
    if (year->sky_count > 0)
        return PP_OK;
    pp_weather_year_clear(year);
    return pp_fail(
        err, PP_BAD_INPUT,
        "%s: the file gives neither direct nor diffuse irradiance (fields 15 and 16)",
        file);
}

void pp_weather_year_clear(struct pp_weather_year *year)
{
    free(year->hours);
    free(year->skies);
    year->hours = NULL;
    year->skies = NULL;
    year->count = year->sky_count = 0;
}

enum pp_status pp_weather_year_moment(struct pp_perez_sky *sky,
                                      const struct pp_weather_year *year,
                                      struct pp_month_day date, double clock_h,
                                      struct pp_error *err)
{
    char words[32];
    pp_month_day_words(words, sizeof words, date);
    for (int i = 0; i < year->count; i++) {
        const struct pp_weather_hour *hour = &year->hours[i];
        if (!pp_month_day_same(hour->date, date) || clock_h < hour->start_h
            || clock_h >= hour->start_h + hour->length_h)
            continue;
        if (!hour->lit)
            return pp_fail(err, PP_BAD_INPUT,
                           "%s, %02d:%02d: the weather file has no daylight at that "
                           "time",
                           words, (int)clock_h, (int)(60.0 * fmod(clock_h, 1.0)));
        *sky = year->skies[hour->sky];
        return PP_OK;
    }
    return pp_fail(err, PP_BAD_INPUT, "%s: the weather file does not have that day",
                   words);
}

struct pp_perez_sky pp_weather_year_turned(const struct pp_perez_sky *sky,
                                           double north_rad)
{
    /* The y axis has the bearing north_rad, the x axis north_rad plus 90 degrees. */
    struct pp_perez_sky turned = *sky;
    double c = cos(north_rad), s = sin(north_rad);
    turned.sun.x = sky->sun.x * c - sky->sun.y * s;
    turned.sun.y = sky->sun.x * s + sky->sun.y * c;
    return turned;
}

/* ---- sentences ---- */

/* A noun in the singular and in the plural. */
static const char *const record_nouns[2] = {"record", "records"};
static const char *const sky_nouns[2] = {"sky", "skies"};

static void append_count(char *text, size_t room, int count, const char *const nouns[2],
                         const char *words)
{
    if (count > 0)
        pp_text_append(text, room, "%s%d %s %s", text[0] ? "; " : "", count,
                       nouns[count > 1], words);
}

const char *pp_weather_year_notes(char *text, size_t room,
                                  const struct pp_weather_year *year)
{
    text[0] = '\0';
    append_count(text, room, year->leap_records, record_nouns,
                 "of 29 February ignored");
    append_count(text, room, year->missing, record_nouns, "without irradiance ignored");
    append_count(text, room, year->moved_suns, record_nouns,
                 "at sunrise or sunset, with the mean position of the sun "
                 "above the horizon");
    append_count(text, room, year->sunless_beams, record_nouns,
                 "with direct light while the sun is below the horizon (direct light "
                 "ignored)");
    if (year->no_diffuse > 0) {
        const struct pp_weather_hour *first = &year->first_no_diffuse;
        char date[32], words[120];
        snprintf(words, sizeof words,
                 "with direct light but no diffuse light (black sky), the first "
                 "on %s at %g h",
                 pp_month_day_words(date, sizeof date, first->date), first->start_h);
        append_count(text, room, year->no_diffuse, record_nouns, words);
    }
    append_count(text, room, year->no_dew_point, record_nouns,
                 "without a dew point (10.97 degrees C used)");
    append_count(text, room, year->positive_b, sky_nouns,
                 "with a Perez coefficient b above 0 (0 used)");
    append_count(text, room, year->brightness, sky_nouns,
                 "beyond Perez's limits of brightness");
    append_count(text, room, year->clearness, sky_nouns,
                 "beyond Perez's limits of clearness");
    return text;
}

const char *pp_weather_year_warning(char *text, size_t room,
                                    const struct pp_weather_year *year)
{
    const struct pp_sun_closure *c = &year->closure;
    double minutes = 60.0 * c->best_h;
    switch (c->finding) {
    case PP_CLOSURE_SHIFTED:
        snprintf(text, room,
                 "the radiation in the weather file fits a sun position %g minutes %s "
                 "than the middle of its records (rms error %.1f instead of %.1f "
                 "W/m2); sun shift in use: %g minutes",
                 fabs(minutes), minutes > 0.0 ? "later" : "earlier", c->rms_best,
                 c->rms_0, 60.0 * year->sun_shift_h);
        return text;
    case PP_CLOSURE_SEASONAL:
        snprintf(text, room,
                 "the radiation in the weather file fits a sun shift of %g minutes "
                 "from April to September and of %g minutes in the other months. The "
                 "file may use summer time; sun shift in use: %g minutes",
                 60.0 * c->summer_h, 60.0 * c->winter_h, 60.0 * year->sun_shift_h);
        return text;
    case PP_CLOSURE_SWAPPED:
        snprintf(
            text, room,
            "the radiation in the weather file is consistent only if direct normal and "
            "diffuse horizontal irradiance (fields 15 and 16) are swapped");
        return text;
    case PP_CLOSURE_NONE:
        snprintf(
            text, room,
            "the radiation in the weather file is not consistent for any sun shift "
            "within an hour (rms error %.0f W/m2). Possible causes: measured or "
            "damaged data, a wrong time zone or longitude, or direct horizontal "
            "instead of direct normal irradiance. Sun shift in use: %g minutes",
            c->rms_best, 60.0 * year->sun_shift_h);
        return text;
    case PP_CLOSURE_AT_MIDDLE:
    case PP_CLOSURE_UNKNOWN:
        break;
    }
    return NULL;
}
