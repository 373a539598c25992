/* moment.c - see moment.h. */
#include "studies/year/moment.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/light/sun.h"
#include "model/room/build/device_states.h"
#include "model/room/outside/trees.h"

enum pp_status pp_moment_of_weather(struct pp_moment *moment,
                                    const struct pp_weather_year *year,
                                    struct pp_month_day date, double clock_h,
                                    struct pp_error *err)
{
    *moment = (struct pp_moment){
        .date = date, .clock_h = clock_h, .year = year, .sky_name = "perez"};
    return pp_weather_year_moment(&moment->sky, year, date, clock_h, err);
}

/* ---- irradiances ---- */

/* Finds the sun at that time and place. */
static enum pp_status sun_of_time(const struct pp_moment_irradiances *of,
                                  double *zone_h, struct pp_sun *sun,
                                  struct pp_error *err)
{
    if (of->date.month == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky has no position of the sun; expected "
                       "perez,DNI,DHI,ALTITUDE,BEARING, or --when 'YYYY-MM-DD HH:MM'");
    if (isnan(of->latitude_rad) || isnan(of->longitude_rad))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the room has no location, which --when needs; expected a site with "
            "latitude and longitude, or perez,DNI,DHI,ALTITUDE,BEARING");
    *zone_h = of->zone_h;
    if (isnan(*zone_h)) /* 0.0 avoids -0 */
        *zone_h = 0.0 + round(of->longitude_rad / (15.0 * PP_RAD));
    double n = pp_sun_days_since_2000(of->year, of->date.month, of->date.day,
                                      of->clock_h - *zone_h);
    *sun = pp_sun_at(n, of->latitude_rad, of->longitude_rad);
    return PP_OK;
}

static const struct {
    unsigned limit;
    const char *words;
} limits[] = {
    {PP_PEREZ_NO_DIFFUSE, "there is direct light but no diffuse light, so the sky is "
                          "black"},
    {PP_PEREZ_B_POSITIVE, "Perez's coefficient b is above 0 and was set to 0"},
    {PP_PEREZ_BRIGHTNESS,
     "the brightness is beyond Perez's limit and was set to the limit"},
    {PP_PEREZ_CLEARNESS,
     "the clearness is beyond Perez's limit and was set to the limit"},
};

enum pp_status pp_moment_of_irradiances(struct pp_moment *moment,
                                        const struct pp_moment_irradiances *of,
                                        struct pp_error *err)
{
    /* Dew point of 2 cm of precipitable water. */
    static const double DEW_POINT_C = 10.97;
    bool by_time = isnan(of->sun_altitude_rad);
    struct pp_sun sun = {.altitude_rad = of->sun_altitude_rad,
                         .bearing_rad = of->sun_bearing_rad,
                         .distance_au = 1.0};
    double zone_h = 0.0;
    *moment = (struct pp_moment){
        .date = of->date, .clock_h = of->clock_h, .sky_name = "perez"};
    enum pp_status status = by_time ? sun_of_time(of, &zone_h, &sun, err) : PP_OK;
    if (status != PP_OK)
        return status;
    if (of->direct_w_m2 > 0.0 && !(sun.altitude_rad > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sun is %.1f degrees below the horizon; expected a direct "
                       "irradiance of 0, or another time",
                       -sun.altitude_rad / PP_RAD);
    moment->sky = pp_perez_sky_of(&(struct pp_perez_conditions){
        .direct_w_m2 = of->direct_w_m2,
        .diffuse_w_m2 = of->diffuse_w_m2,
        .sun = pp_vec_at_bearing(sun.bearing_rad, sun.altitude_rad),
        .sun_distance_au = sun.distance_au,
        .dew_point_c = DEW_POINT_C});
    if (!(moment->sky.diffuse_lx > 0.0) && !(moment->sky.direct_lx > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky gives no light; expected an irradiance above 0");
    snprintf(
        moment->words, sizeof moment->words,
        "Perez sky for %g W/m2 direct normal and %g W/m2 diffuse horizontal "
        "irradiance, with Perez's luminous efficacy at 2 cm of precipitable water; ",
        of->direct_w_m2, of->diffuse_w_m2);
    if (by_time)
        pp_text_append(moment->words, sizeof moment->words,
                       "sun at that time at latitude %.4g, longitude %.4g, with the "
                       "clock %g h ahead of universal time%s",
                       of->latitude_rad / PP_RAD, of->longitude_rad / PP_RAD, zone_h,
                       isnan(of->zone_h) ? ", from the longitude" : "");
    else
        pp_text_append(moment->words, sizeof moment->words, "sun as given");
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++)
        if (moment->sky.limits & limits[i].limit)
            pp_text_append(moment->words, sizeof moment->words, "; %s",
                           limits[i].words);
    return PP_OK;
}

/* ---- standard skies ---- */

enum pp_status pp_moment_of_standard(struct pp_moment *moment,
                                     const struct pp_moment_standard *of,
                                     struct pp_error *err)
{
    *moment = (struct pp_moment){.sky_name = of->name};
    struct pp_vec3 sun = pp_vec_at_bearing(of->sun_bearing_rad, of->sun_altitude_rad);
    if (!(of->diffuse_lx > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky gives no light; expected a diffuse illuminance above "
                       "0");
    if (of->direct_lx > 0.0 && !(sun.z > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sun is at the horizon; expected a direct illuminance of 0, "
                       "or an altitude above 0");
    struct pp_sky standard =
        strcmp(of->name, "uniform") == 0 ? pp_sky_uniform() : pp_sky_overcast();
    enum pp_status status =
        of->iso > 0 ? pp_sky_iso(&standard, of->iso, sun, err) : PP_OK;
    if (status != PP_OK)
        return status;
    moment->sky =
        pp_perez_sky_of_standard(&standard, sun, of->direct_lx, of->diffuse_lx);
    moment->sky.sunless = of->iso == 0 && !(of->direct_lx > 0.0);
    snprintf(moment->words, sizeof moment->words,
             "Sky %s with the given diffuse horizontal%s illuminance%s", of->name,
             of->direct_lx > 0.0 ? " and direct normal" : "",
             of->direct_lx > 0.0 ? "; sun as given" : "");
    return PP_OK;
}

/* ---- a room ---- */

enum pp_status pp_moment_at(struct pp_moment *moment,
                            const struct pp_moment_source *source,
                            const struct pp_world *world, struct pp_error *err)
{
    struct pp_moment_irradiances of = source->of;
    if (source->year)
        return pp_moment_of_weather(moment, source->year, of.date, of.clock_h, err);
    if (source->standard.name)
        return pp_moment_of_standard(moment, &source->standard, err);
    of.latitude_rad = world->latitude_rad;
    of.longitude_rad = world->longitude_rad;
    return pp_moment_of_irradiances(moment, &of, err);
}

enum pp_status pp_moment_turn_slats(struct pp_world *world,
                                    const struct pp_moment *moment,
                                    struct pp_error *err)
{
    struct pp_perez_sky sky = pp_weather_year_turned(&moment->sky, world->north_rad);
    if (moment->date.month > 0)
        world->trees_are_bare = pp_trees_are_bare(world, moment->date.month);
    return pp_device_states_turn(world, sky.direct_lx > 0.0, sky.sun, err);
}

enum pp_status pp_moment_light(struct pp_outside_light *light,
                               const struct pp_moment *moment, double north_rad,
                               struct pp_error *err)
{
    struct pp_perez_sky sky = pp_weather_year_turned(&moment->sky, north_rad);
    if (!(sky.diffuse_lx > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "there is direct light without diffuse light, which gives a "
                       "black sky; expected diffuse light");
    light->sky = pp_perez_sky_relative(&sky);
    light->sun = (struct pp_outside_sun){
        sky.sun, sky.sun.z > 0.0 ? sky.direct_lx / sky.diffuse_lx : 0.0};
    return PP_OK;
}

enum pp_status pp_moment_of_room(struct pp_annual_sheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_receiver *receivers,
                                 int receiver_count, const struct pp_moment *moment,
                                 const struct pp_annual_options *options,
                                 struct pp_error *err)
{
    struct pp_perez_sky sky = moment->sky;
    struct pp_weather_hour hour = {.date = moment->date,
                                   .weekday = PP_WEEKDAY_UNKNOWN,
                                   .start_h = floor(moment->clock_h),
                                   .length_h = 1.0,
                                   .known = true,
                                   .lit = true,
                                   .sky = 0};
    struct pp_weather_year one = {.words = moment->words};
    if (moment->year)
        one = *moment->year;
    one.hours = &hour;
    one.skies = &sky;
    one.count = one.sky_count = 1;
    struct pp_annual_options whole = *options;
    whole.hours = (struct pp_working_hours){0.0, 24.0, PP_ALL_DAYS};
    whole.summer = (struct pp_summer_time){{0, 0}, {0, 0}};
    whole.illuminance_count = 1;
    whole.illuminances_lx[0] = 300.0;
    whole.patches = 2305;
    whole.blinds = PP_BLINDS_AS_DRAWN;
    enum pp_status status = pp_annual_of_room(sheet, world, light, receivers,
                                              receiver_count, false, &one, &whole, err);
    sheet->sky_name = moment->sky_name;
    return status;
}
