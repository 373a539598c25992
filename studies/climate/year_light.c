/* year_light.c - reads the light outside from a weather file or computes it for a
 * latitude, and describes light and hours in sentences. */
#include "studies/climate/year_light.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"

const struct pp_year_options pp_year_options_default = {
    .latitude_deg = NAN,
    .longitude_deg = NAN,
    .time_zone_h = NAN,
    .hours = {2, {{8.0, 18.0, PP_ALL_DAYS}, {9.0, 17.0, PP_ALL_DAYS}}},
    .days = PP_ALL_DAYS,
    .illuminances = {2, {300.0, 500.0}},
};

const char *const pp_year_light_day_names[] = {"Mon", "Tue", "Wed", "Thu",
                                               "Fri", "Sat", "Sun"};

static enum pp_status light_of_file(struct pp_year_light *outside,
                                    const struct pp_year_options *options,
                                    struct pp_error *err)
{
    const struct pp_epw *epw = options->epw;
    const char *file = pp_read_file_title(options->weather);
    struct pp_diffuse_light *light = &outside->light;
    enum pp_status status = pp_diffuse_light_of_epw(light, epw, file, err);
    if (status != PP_OK)
        return status;
    const char *slash = strrchr(file, '/');
    char gaps[160] = "";
    if (light->filled)
        snprintf(gaps, sizeof gaps, ", calculated from irradiance in %d records",
                 light->filled);
    if (light->missing)
        pp_text_append(gaps, sizeof gaps, "; %d records without values are ignored",
                       light->missing);
    outside->latitude_deg = epw->latitude_rad / PP_RAD;
    snprintf(outside->words, sizeof outside->words,
             "%.120s (%.120s): %s%s; %d records of %g h", epw->place,
             slash ? slash + 1 : file,
             light->origin == PP_LIGHT_ILLUMINANCE
                 ? "diffuse horizontal illuminance from the file"
                 : "diffuse horizontal irradiance from the file times Perez's luminous "
                   "efficacy, because the file has no illuminances",
             gaps, epw->record_count, epw->record_h);
    return PP_OK;
}

/* Writes an angle with one of two letters, such as "51.5 N". */
static const char *say_degrees(char *text, size_t room, double degrees,
                               const char letters[2])
{
    snprintf(text, room, "%.4g %c", fabs(degrees), letters[degrees < 0.0]);
    return text;
}

static enum pp_status light_of_sky(struct pp_year_light *outside,
                                   const struct pp_year_options *options,
                                   const struct pp_world *world, struct pp_error *err)
{
    double latitude = options->latitude_deg, longitude = options->longitude_deg;
    double zone = options->time_zone_h;
    if (isnan(latitude) && world)
        latitude = world->latitude_rad / PP_RAD;
    if (isnan(longitude) && isnan(options->latitude_deg) && world)
        longitude = world->longitude_rad / PP_RAD;
    if (isnan(latitude))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s has no latitude; expected --weather FILE.epw, --latitude "
                       "DEG, or <site latitude=\"DEG\"/> in the room file",
                       world && world->name ? world->name : "the room");
    char clock[120], north[24], east[24];
    if (isnan(longitude)) {
        zone = isnan(zone) ? 0.0 : zone;
        longitude = 15.0 * zone;
        snprintf(clock, sizeof clock, "local mean time");
    } else {
        zone = isnan(zone) ? round(longitude / 15.0) : zone;
        snprintf(clock, sizeof clock, "%s, clock %g h %s universal time",
                 say_degrees(east, sizeof east, longitude, "EW"), fabs(zone),
                 zone < 0.0 ? "behind" : "ahead of");
    }
    outside->latitude_deg = latitude;
    snprintf(outside->words, sizeof outside->words,
             "overcast sky all year at %s (%s), E = 300 + 21000 sin(altitude of the "
             "sun) lx; real skies give more light",
             say_degrees(north, sizeof north, latitude, "NS"), clock);
    return pp_diffuse_light_overcast(&outside->light, latitude * PP_RAD,
                                     fmax(-180.0, fmin(180.0, longitude)) * PP_RAD,
                                     zone, err);
}

/* Writes a set of days: "all days", a range such as "Mon to Fri", or a list such as
 * "Mon, Wed". */
static void say_days(char *text, size_t room, unsigned days)
{
    int first = 0, last = 6;
    while (first < 7 && !(days >> first & 1))
        first++;
    while (last > first && !(days >> last & 1))
        last--;
    unsigned run = (2u << last) - (1u << first);
    if (days == PP_ALL_DAYS) {
        snprintf(text, room, "all days");
    } else if (days == run && last > first) {
        snprintf(text, room, "%s to %s", pp_year_light_day_names[first],
                 pp_year_light_day_names[last]);
    } else {
        text[0] = '\0';
        for (int i = 0; i < 7; i++)
            if (days >> i & 1)
                pp_text_append(text, room, "%s%s", text[0] ? ", " : "",
                               pp_year_light_day_names[i]);
    }
}

static struct pp_summer_time summer_of(const struct pp_year_options *options)
{
    if (options->summer.of_file)
        return (struct pp_summer_time){options->epw->summer_from,
                                       options->epw->summer_to};
    return options->summer.time;
}

static void say_calendar(struct pp_year_light *outside,
                         const struct pp_year_options *options)
{
    struct pp_summer_time summer = summer_of(options);
    char days[48], from[24], to[24];
    say_days(days, sizeof days, options->days);
    if (summer.from.month)
        snprintf(outside->calendar, sizeof outside->calendar,
                 "%s; standard time, and summer time (one hour ahead) from %s to %s",
                 days, pp_month_day_words(from, sizeof from, summer.from),
                 pp_month_day_words(to, sizeof to, summer.to));
    else
        snprintf(outside->calendar, sizeof outside->calendar,
                 "%s; standard time all year", days);
}

enum pp_status pp_year_light_of_room(struct pp_year_light *outside,
                                     const struct pp_year_options *options,
                                     const struct pp_world *world, struct pp_error *err)
{
    *outside = (struct pp_year_light){.latitude_deg = NAN};
    for (int i = 0; i < options->hours.count; i++) {
        outside->periods[i] = options->hours.list[i];
        outside->periods[i].days = options->days;
    }
    say_calendar(outside, options);
    if (!options->epw)
        return light_of_sky(outside, options, world, err);
    if (options->days != PP_ALL_DAYS
        && options->epw->records[0].weekday == PP_WEEKDAY_UNKNOWN)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the DATA PERIODS line does not give a day of the week, so "
                       "--days cannot be used; expected --days all",
                       pp_read_file_title(options->weather));
    return light_of_file(outside, options, err);
}

void pp_year_light_clear(struct pp_year_light *outside)
{
    pp_diffuse_light_clear(&outside->light);
}

struct pp_availability_question pp_year_light_question(
    const struct pp_year_options *options, const struct pp_year_light *outside)
{
    return (struct pp_availability_question){
        .light = &outside->light,
        .light_words = outside->words,
        .calendar_words = outside->calendar,
        .period_count = options->hours.count,
        .periods = outside->periods,
        .summer = summer_of(options),
        .illuminance_count = options->illuminances.count,
        .illuminances_lx = options->illuminances.lx,
    };
}
