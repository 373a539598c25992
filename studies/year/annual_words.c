/* annual_words.c - see annual_words.h. */
#include "studies/year/annual_words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/results/sheets/point_areas.h"
#include "model/room/build/device_states.h"
#include "model/room/outside/trees.h"

static enum pp_status fill_hours(struct pp_annual_sheet *sheet,
                                 const struct pp_weather_year *year,
                                 const struct pp_annual_options *options,
                                 struct pp_error *err)
{
    sheet->hour_count = year->count;
    sheet->sky_count = year->sky_count;
    sheet->hours = calloc((size_t)year->count + 1, sizeof *sheet->hours);
    if (!sheet->hours)
        return pp_fail_memory(err);
    for (int i = 0; i < year->count; i++) {
        const struct pp_weather_hour *from = &year->hours[i];
        struct pp_annual_hour *to = &sheet->hours[i];
        struct pp_diffuse_hour at = {.date = from->date,
                                     .weekday = from->weekday,
                                     .start_h = from->start_h,
                                     .length_h = from->length_h};
        *to = (struct pp_annual_hour){.month = from->date.month,
                                      .day = from->date.day,
                                      .start_h = from->start_h,
                                      .length_h = from->length_h,
                                      .known = from->known,
                                      .sky = from->sky,
                                      .sun_altitude_rad = NAN,
                                      .sun_bearing_rad = NAN};
        if (from->known)
            to->occupied_h =
                pp_working_hours_share_h(&options->hours, &options->summer, &at);
        if (from->sky < 0)
            continue;
        const struct pp_perez_sky *sky = &year->skies[from->sky];
        double bearing = atan2(sky->sun.x, sky->sun.y);
        if (!sky->sunless) {
            to->sun_altitude_rad = asin(fmax(-1.0, fmin(1.0, sky->sun.z)));
            to->sun_bearing_rad = bearing < 0.0 ? bearing + 2.0 * PP_PI : bearing;
        }
        to->diffuse_lx = sky->diffuse_lx;
        to->direct_lx = sky->sun.z > 0.0 ? sky->direct_lx : 0.0;
        sheet->daylit_h += from->length_h;
    }
    return PP_OK;
}

static void warn(struct pp_annual_sheet *sheet, const char *text)
{
    if (sheet->warning_count < PP_ANNUAL_WARNINGS_MOST)
        snprintf(sheet->warnings[sheet->warning_count++], PP_ANNUAL_WORDS, "%s", text);
}

static void say_weather(struct pp_annual_sheet *sheet,
                        const struct pp_weather_year *year)
{
    const struct pp_epw *epw = year->epw;
    if (!epw) {
        snprintf(sheet->weather, sizeof sheet->weather, "%s", year->words);
        return;
    }
    snprintf(sheet->weather, sizeof sheet->weather,
             "%.160s; latitude %.4g, longitude %.4g, clock %g h ahead of universal "
             "time; sun position at the middle of each record%s, in the year %d; "
             "illuminances from irradiances by Perez's luminous efficacy",
             epw->place, epw->latitude_rad / PP_RAD, epw->longitude_rad / PP_RAD,
             epw->time_zone_h,
             year->sun_shift_h != 0.0 ? ", moved by the sun shift" : "",
             year->sun_year);
    if (year->count > 1)
        pp_text_append(sheet->weather, sizeof sheet->weather, "; %d records of %g h",
                       year->count, epw->record_h);
    if (year->sun_shift_h != 0.0)
        pp_text_append(sheet->weather, sizeof sheet->weather, "; sun shift %g minutes",
                       sheet->sun_shift_min);
}

static void say_period(struct pp_annual_sheet *sheet,
                       const struct pp_annual_options *options,
                       const struct pp_year_clock *clock)
{
    char from[32], to[32];
    const struct pp_summer_time *summer = &options->summer;
    snprintf(sheet->period, sizeof sheet->period,
             "%g to %g h%s, %g hours including hours of darkness; ",
             options->hours.from_h, options->hours.to_h,
             options->hours.days == PP_ALL_DAYS ? " on all days"
                                                : " on the chosen days",
             clock->all_occupied_h);
    if (summer->from.month)
        pp_text_append(sheet->period, sizeof sheet->period,
                       "summer time (clock one hour ahead) from %s to %s",
                       pp_month_day_words(from, sizeof from, summer->from),
                       pp_month_day_words(to, sizeof to, summer->to));
    else
        pp_text_append(sheet->period, sizeof sheet->period,
                       "standard time all year (LM-83 uses clock time: --summer-time)");
}

static void say_blinds(struct pp_annual_sheet *sheet, const struct pp_world *world,
                       const struct pp_annual_options *options)
{
    char *text = sheet->blinds;
    size_t room = sizeof sheet->blinds;
    bool own = pp_device_states_exist(world);
    const char *none = "none, so the share of the plane that reaches 300 lx in half of "
                       "the hours is not sDA";
    switch (options->blinds) {
    case PP_BLINDS_AS_DRAWN:
        snprintf(text, room, "%s", none);
        break;
    case PP_BLINDS_NEVER:
        snprintf(text, room, "%s%s", none,
                 own ? ". The blinds, screens and curtains of the room are open" : "");
        break;
    case PP_BLINDS_LM83:
        snprintf(text, room,
                 "LM-83-12, open loop: the blinds of a window group (one wall, one "
                 "glass) close when more than 2 %% of the %s 1000 lx or more of direct "
                 "sun through it. ",
                 pp_point_areas_differ(sheet->receivers, sheet->receiver_count)
                     ? "plane gets"
                     : "points get");
        if (own)
            pp_text_append(text, room,
                           "Closed windows have their own blind, screen or curtain; "
                           "without one, they diffusely emit %g of the incident light, "
                           "times the diffuse transmittance of the panes. ",
                           PP_BLIND_GROUPS_TRANSMITTANCE);
        else
            pp_text_append(text, room,
                           "Closed blinds diffusely emit %g of the incident light, "
                           "times the diffuse transmittance of the panes. ",
                           PP_BLIND_GROUPS_TRANSMITTANCE);
        pp_text_append(text, room, "All other figures are for open blinds");
        break;
    case PP_BLINDS_ALWAYS:
    case PP_BLINDS_SCHEDULE:
        snprintf(text, room,
                 "the blinds, screens and curtains of the room are closed %s. This is "
                 "not the operation of LM-83, so there is no sDA. All other figures "
                 "are for open blinds",
                 options->blinds == PP_BLINDS_ALWAYS ? "in all hours"
                                                     : "in the hours of the schedule");
        break;
    }
}

/* Warns if blinds close together only because there are many kinds of windows. */
static void warn_of_grouping(struct pp_annual_sheet *sheet,
                             const struct pp_blind_groups *groups)
{
    char text[PP_ANNUAL_WORDS];
    if (!sheet->has_blinds || groups->grouping == PP_BLIND_GROUPS_BY_KIND)
        return;
    snprintf(text, sizeof text,
             "the room has more than %d kinds of windows, so the blinds of %s close "
             "together, except those of panes that scatter light by direction",
             PP_BLIND_GROUPS_MOST,
             groups->grouping == PP_BLIND_GROUPS_BY_FACE ? "each wall" : "all windows");
    warn(sheet, text);
}

static void name_groups(struct pp_annual_sheet *sheet, const struct pp_world *world,
                        const struct pp_blind_groups *groups)
{
    sheet->group_count = groups->count;
    for (int g = 0; g < groups->count; g++) {
        const struct pp_opening *opening = &world->openings[groups->first[g]];
        enum pp_device_kind device = opening->device.kind;
        sheet->groups[g].device =
            device != PP_DEVICE_NONE ? pp_window_device_word(device) : NULL;
        const struct pp_surface *face = &world->surfaces[opening->face];
        const char *wall = face->name                 ? face->name
                           : face->role == PP_CEILING ? "ceiling"
                           : face->role == PP_FLOOR   ? "floor"
                                                      : "wall";
        int count = 0;
        for (int i = 0; i < world->opening_count; i++) {
            if (groups->of_opening[i] != g)
                continue;
            count++;
            if (world->openings[i].face != opening->face)
                wall = "several walls";
        }
        if (count == 1 && opening->name)
            snprintf(sheet->groups[g].name, sizeof sheet->groups[g].name, "%s: %s",
                     wall, opening->name);
        else
            snprintf(sheet->groups[g].name, sizeof sheet->groups[g].name,
                     "%s: %d opening%s", wall, count, count == 1 ? "" : "s");
    }
}

/* Warns if the latitudes of the weather file and of the room differ by more than a
 * degree. */
static void compare_places(struct pp_annual_sheet *sheet, const struct pp_world *world,
                           const struct pp_epw *epw)
{
    char text[PP_ANNUAL_WORDS];
    if (!epw || isnan(world->latitude_rad)
        || !(fabs(world->latitude_rad - epw->latitude_rad) > 1.0 * PP_RAD))
        return;
    snprintf(text, sizeof text,
             "the room is at latitude %.4g, but the weather file is for %.4g; sun and "
             "sky are those of the file",
             world->latitude_rad / PP_RAD, epw->latitude_rad / PP_RAD);
    warn(sheet, text);
}

enum pp_status pp_annual_words_fill(struct pp_annual_sheet *sheet,
                                    const struct pp_world *world,
                                    const struct pp_weather_year *year,
                                    const struct pp_annual_options *options,
                                    const struct pp_year_clock *clock,
                                    const struct pp_blind_groups *groups,
                                    struct pp_error *err)
{
    char text[PP_ANNUAL_WORDS];
    enum pp_status status = fill_hours(sheet, year, options, err);
    if (status != PP_OK)
        return status;
    sheet->illuminance_count = options->illuminance_count;
    memcpy(sheet->illuminances_lx, options->illuminances_lx,
           sizeof sheet->illuminances_lx);
    sheet->has_blinds = options->blinds > PP_BLINDS_NEVER;
    sheet->blinds_of_lm83 = options->blinds == PP_BLINDS_LM83;
    sheet->standard_hours = options->hours.from_h == 8.0 && options->hours.to_h == 18.0
                            && options->hours.days == PP_ALL_DAYS;
    sheet->occupied_h = clock->all_occupied_h;
    sheet->diffuse_median_lx = clock->diffuse_median_lx;
    sheet->sun_shift_min = 60.0 * year->sun_shift_h;
    say_weather(sheet, year);
    pp_weather_year_notes(sheet->notes, sizeof sheet->notes, year);
    if (pp_weather_year_warning(text, sizeof text, year))
        warn(sheet, text);
    compare_places(sheet, world, year->epw);
    if (clock->diffuse_median_lx <= 0.0 && year->count > 1)
        warn(sheet, "at most a quarter of the year has daylight, so no room can reach "
                    "the levels of EN 17037 here");
    if (!pp_annual_sheet_has_sun(sheet) && year->count > 1)
        warn(sheet,
             "the weather has no direct sun, so ASE is not known and LEED is not "
             "assessed; other figures are for diffuse light alone");
    say_period(sheet, options, clock);
    say_blinds(sheet, world, options);
    name_groups(sheet, world, groups);
    warn_of_grouping(sheet, groups);
    return PP_OK;
}

void pp_annual_words_method(struct pp_annual_sheet *sheet,
                            const struct pp_annual_options *options, int samples,
                            int cells)
{
    if (options->exact_sky)
        snprintf(sheet->method, sizeof sheet->method,
                 "light paths, 16 x %d per point, with the Perez sky of each hour at "
                 "the end of each path; direct light at every surface from the sun in "
                 "its true position",
                 samples);
    else
        snprintf(sheet->method, sizeof sheet->method,
                 "direct sun in closed form, in its true position; direct sky in "
                 "closed form, %d patches. Reflected light by paths, 16 x %d per "
                 "point, through %d cells with the sun in its true position. Sunlight "
                 "reflected specularly by glass is ignored",
                 options->patches, samples, cells);
    if (pp_trees_change(sheet->world))
        pp_text_append(sheet->method, sizeof sheet->method,
                       ". Trees have no leaves in months %d to %d",
                       sheet->world->bare_from, sheet->world->bare_to);
}
