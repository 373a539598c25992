/* moment_choice.c - see moment_choice.h. */
#include "cli/moment_choice.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/availability/availability_options.h"
#include "cli/message.h"
#include "model/base/read_file.h"
#include "model/base/text.h"

/* ---- the options ---- */

/* Reads a time zone, "", "Z", "+HH:MM" or "-HH:MM", as hours ahead of universal
 * time; NAN for "". False for other text. */
static bool read_zone(const char *text, double *zone_h)
{
    int hours, minutes, used = 0;
    *zone_h = *text ? 0.0 : NAN;
    if (!*text || strcmp(text, "Z") == 0)
        return true;
    if ((*text != '+' && *text != '-')
        || sscanf(text + 1, "%2d:%2d%n", &hours, &minutes, &used) != 2
        || text[1 + used] != '\0' || hours < 0 || hours > 14 || minutes < 0
        || minutes > 59)
        return false;
    *zone_h = (*text == '-' ? -1.0 : 1.0) * (hours + minutes / 60.0);
    return true;
}

enum pp_status pp_moment_choice_read_when(const char *text, void *place,
                                          struct pp_error *err)
{
    struct pp_moment_choice *choice = place;
    struct pp_moment_irradiances *of = &choice->of;
    int year, month, day, hour, minute, used = 0;
    double zone_h;
    if (sscanf(text, "%4d-%2d-%2d %2d:%2d%n", &year, &month, &day, &hour, &minute,
               &used)
            != 5
        || month < 1 || month > 12 || day < 1 || day > pp_month_day_days_of_month(month)
        || hour < 0 || hour > 23 || minute < 0 || minute > 59
        || !read_zone(text + used, &zone_h))
        return pp_fail(err, PP_BAD_INPUT,
                       "a time as 'YYYY-MM-DD HH:MM', in standard time");
    choice->when = text;
    of->year = year;
    of->date = (struct pp_month_day){month, day};
    of->clock_h = hour + minute / 60.0;
    of->zone_h = zone_h;
    return PP_OK;
}

const struct pp_option pp_moment_when_option[] = {
    {"when", 0, "'YYYY-MM-DD HH:MM'",
     "Show illuminances in lux at this standard time, including direct sunlight, "
     "instead of daylight factors. Sky and sun are taken from --weather or from --sky "
     "perez,DNI,DHI. After the time, +HH:MM, -HH:MM or Z sets the time zone, in hours "
     "ahead of universal time. Without --when, the same is shown for --sky "
     "perez,DNI,DHI,ALTITUDE,BEARING, for iso-N,ALTITUDE,BEARING,DIRECT,DIFFUSE and "
     "for overcast,DIFFUSE, with illuminances in lux.",
     pp_moment_choice_read_when, 0},
    {0},
};

const struct pp_option pp_moment_weather_option[] = {
    {"weather", 'w', "FILE.epw", "Weather file for --when.", pp_options_read_input,
     offsetof(struct pp_moment_choice, weather)},
    {0},
};

/* ---- sky given by irradiances ---- */

enum { PEREZ_NUMBERS = 4 };

/* True if the date exists and the year is in the range for which the formulae of the
 * sun's position are valid. */
static bool is_in_calendar(const struct pp_moment_irradiances *of)
{
    return of->year >= 1800 && of->year <= 2200
           && (pp_month_day_is_leap(of->year) || of->date.month != 2
               || of->date.day != 29);
}

static enum pp_status read_perez(struct pp_moment_choice *choice, struct pp_error *err)
{
    static const double MOST_W_M2 = 1500.0; /* greater than the solar constant */
    const char *numbers = choice->sky + strlen("perez");
    double v[PEREZ_NUMBERS] = {NAN, NAN, NAN, NAN};
    int count =
        *numbers == ',' ? pp_options_numbers(numbers + 1, ',', v, PEREZ_NUMBERS) : 0;
    if ((count != 2 && count != 4) || !(v[0] >= 0.0 && v[0] <= MOST_W_M2)
        || !(v[1] >= 0.0 && v[1] <= MOST_W_M2)
        || (count == 4
            && !(v[2] >= 0.0 && v[2] <= 90.0 && v[3] >= -360.0 && v[3] <= 360.0)))
        return pp_fail(err, PP_BAD_INPUT,
                       "--sky is \"%.100s\"; expected perez,DNI,DHI (direct normal and "
                       "diffuse horizontal irradiance from 0 to 1500 W/m2), or "
                       "perez,DNI,DHI,ALTITUDE,BEARING with the sun at 0 to 90 and "
                       "-360 to 360 degrees",
                       choice->sky);
    choice->of.direct_w_m2 = v[0];
    choice->of.diffuse_w_m2 = v[1];
    choice->of.sun_altitude_rad = v[2] * PP_RAD;
    choice->of.sun_bearing_rad = v[3] * PP_RAD;
    if (choice->weather)
        return pp_fail(err, PP_BAD_INPUT,
                       "--weather and --sky perez both determine the sky; expected "
                       "only one of them");
    if (count == 4 && choice->when)
        return pp_fail(err, PP_BAD_INPUT,
                       "--when and --sky perez,DNI,DHI,ALTITUDE,BEARING both determine "
                       "the sun; expected only one of them");
    if (choice->when && !is_in_calendar(&choice->of))
        return pp_fail(err, PP_BAD_INPUT,
                       "--when is %s; expected a date in the years 1800 to 2200",
                       choice->when);
    if (count == 2 && !choice->when)
        return pp_fail(err, PP_BAD_INPUT,
                       "--sky %s has no position of the sun; expected "
                       "perez,DNI,DHI,ALTITUDE,BEARING, or --when 'YYYY-MM-DD HH:MM'",
                       choice->sky);
    return PP_OK;
}

static bool is_perez(const char *sky)
{
    size_t length = strlen("perez");
    return sky && strncmp(sky, "perez", length) == 0
           && (sky[length] == '\0' || sky[length] == ',');
}

/* ---- standard sky given by illuminances ---- */

/* True for the skies overcast,DIFFUSE and uniform,DIFFUSE, and for iso-N with more
 * numbers than the position of the sun. Without illuminances these skies are for
 * daylight factors. */
static bool is_standard_moment(const char *sky)
{
    int commas = 0;
    for (const char *c = sky; c && *c; c++)
        commas += *c == ',';
    return sky
           && (strncmp(sky, "overcast,", 9) == 0 || strncmp(sky, "uniform,", 8) == 0
               || (strncmp(sky, "iso-", 4) == 0 && commas > 2));
}

static enum pp_status read_standard(struct pp_moment_choice *choice,
                                    struct pp_error *err)
{
    static const double MOST_LX = 200000.0; /* greater than sunlight outside the
                                             * atmosphere */
    struct pp_moment_standard *standard = &choice->standard;
    double v[4] = {0.0};
    double type = 0.0;
    int length = (int)strcspn(choice->sky, ",");
    int count = pp_options_numbers(choice->sky + length + 1, ',', v, 4);
    bool is_iso = strncmp(choice->sky, "iso-", 4) == 0;
    snprintf(choice->standard_name, sizeof choice->standard_name, "%.*s", length,
             choice->sky);
    bool good = count == (is_iso ? 4 : 1);
    if (is_iso)
        good = good && pp_text_parse_number(choice->standard_name + 4, &type)
               && type == floor(type) && type >= 1.0 && type <= 15.0 && v[0] >= 0.0
               && v[0] <= 90.0 && v[1] >= -360.0 && v[1] <= 360.0 && v[2] >= 0.0
               && v[2] <= MOST_LX;
    double diffuse_lx = is_iso ? v[3] : v[0];
    if (!good || !(diffuse_lx > 0.0 && diffuse_lx <= MOST_LX))
        return pp_fail(err, PP_BAD_INPUT,
                       is_iso ? "--sky is \"%.100s\"; expected iso-1 to iso-15 as "
                                "iso-N,ALTITUDE,BEARING,DIRECT,DIFFUSE, in degrees and "
                                "lux up to 200000"
                              : "--sky is \"%.100s\"; expected overcast,DIFFUSE or "
                                "uniform,DIFFUSE, in lux up to 200000",
                       choice->sky);
    *standard = (struct pp_moment_standard){.name = choice->standard_name,
                                            .iso = (int)type,
                                            .sun_altitude_rad = v[0] * PP_RAD,
                                            .sun_bearing_rad = v[1] * PP_RAD,
                                            .direct_lx = v[2],
                                            .diffuse_lx = diffuse_lx};
    if (!is_iso) {
        standard->sun_altitude_rad = PP_PI / 2.0;
        standard->sun_bearing_rad = standard->direct_lx = 0.0;
    }
    if (choice->weather || choice->when)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s and --sky %s both determine the sky; expected only one of "
                       "them",
                       choice->weather ? "--weather" : "--when", choice->sky);
    return PP_OK;
}

enum pp_status pp_moment_choice_settle(struct pp_moment_choice *choice,
                                       struct pp_room_options *room,
                                       struct pp_error *err)
{
    struct pp_study_options *study = &room->study;
    bool perez = is_perez(study->sky);
    if (perez || is_standard_moment(study->sky)) {
        choice->sky = study->sky;
        study->sky = NULL;
        enum pp_status status =
            perez ? read_perez(choice, err) : read_standard(choice, err);
        if (status != PP_OK)
            return status;
    } else if (!choice->when && !choice->weather) {
        return PP_OK;
    } else if (!choice->when || !choice->weather) {
        return pp_fail(err, PP_BAD_INPUT, "%s needs %s",
                       choice->when ? "--when" : "--weather",
                       choice->when ? "--weather FILE.epw, or --sky perez,DNI,DHI"
                                    : "--when 'YYYY-MM-DD HH:MM'");
    } else if (!isnan(choice->of.zone_h)) {
        return pp_fail(err, PP_BAD_INPUT,
                       "--when %s: the time is in the weather file's standard time; "
                       "expected no time zone",
                       choice->when);
    }
    const char *of_factors = study->methods              ? "--methods"
                             : study->explain            ? "--explain"
                             : study->sky                ? "--sky"
                             : study->external_lux > 0.0 ? "--external"
                                                         : NULL;
    if (of_factors)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: a calculation for one moment has its own sky and is "
                       "simulated; expected no %s",
                       perez         ? "--sky perez"
                       : choice->sky ? choice->sky
                                     : "--when",
                       of_factors);
    return PP_OK;
}

bool pp_moment_choice_said(const struct pp_moment_choice *choice)
{
    return choice->sky || choice->when;
}

enum pp_status pp_moment_choice_check_paths(const struct pp_room_options *room,
                                            struct pp_error *err)
{
    long samples = room->study.samples;
    if (samples > 0 && (samples > 65536 || (samples & (samples - 1)) != 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--samples is %ld; expected a power of two up to 65536",
                       samples);
    return PP_OK;
}

/* ---- the moment ---- */

enum pp_exit pp_moment_choice_load(struct pp_moment_choice *choice, bool strict)
{
    choice->light = pp_year_options_default;
    if (!choice->weather)
        return PP_EXIT_DONE;
    const struct pp_weather_options weather = {.sun_shift_h = NAN};
    struct pp_error err = {0};
    choice->light.weather = choice->weather;
    enum pp_exit result = pp_availability_options_load(&choice->light, strict);
    if (result != PP_EXIT_DONE)
        return result;
    enum pp_status status =
        pp_weather_year_of_epw(&choice->year, choice->light.epw, &weather,
                               pp_read_file_title(choice->weather), &err);
    char doubt[PP_ANNUAL_WORDS];
    if (status == PP_OK && strict
        && pp_weather_year_warning(doubt, sizeof doubt, &choice->year))
        status = pp_fail(&err, PP_BAD_INPUT, "%s: %s",
                         pp_read_file_title(choice->weather), doubt);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

void pp_moment_choice_clear(struct pp_moment_choice *choice)
{
    pp_weather_year_clear(&choice->year);
    pp_availability_options_clear(&choice->light);
}

struct pp_moment_source pp_moment_choice_source(const struct pp_moment_choice *choice)
{
    return (struct pp_moment_source){choice->when, choice->sky ? NULL : &choice->year,
                                     choice->of, choice->standard};
}

enum pp_status pp_moment_choice_find(struct pp_moment *moment,
                                     const struct pp_moment_choice *choice,
                                     const struct pp_world *world, struct pp_error *err)
{
    const struct pp_moment_source source = pp_moment_choice_source(choice);
    return pp_moment_at(moment, &source, world, err);
}
