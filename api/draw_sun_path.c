/* draw_sun_path.c - chart of sun paths over the obstructions in front of a window, as a
 * stereographic diagram. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "api/chart_kind.h"
#include "api/choose_window.h"
#include "charts/sheet/page.h"
#include "charts/sky/overlay_chart.h"
#include "methods/exact/hidden_outline.h"
#include "methods/exact/sunlit_hours.h"
#include "model/base/read_file.h"
#include "studies/climate/sunshine.h"
#include "studies/criteria/pair_rooms.h"
#include "studies/criteria/windows/opening_words.h"
#include "studies/year/weather_year.h"

/* Visible sky and sunlit hours of a window, in the present or the former state. */
struct window_sun {
    struct pp_hidden_cones cones;
    struct pp_sky_mask mask;
    struct pp_sunlit_year hours;
    struct pp_sunlit_day march; /* sunlit times on 21 March */
};

static enum pp_status find_sun(struct window_sun *sun, const struct pp_world *world,
                               int window, struct pp_error *err)
{
    const struct pp_hidden_view view =
        pp_hidden_cones_outside(&world->openings[window]);
    const struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                          world->longitude_rad};
    enum pp_status status = pp_hidden_cones_init(&sun->cones, world, &view, err);
    if (status == PP_OK)
        status = pp_hidden_outline_add(&sun->mask, &sun->cones, world->north_rad, err);
    if (status == PP_OK)
        status = pp_sunlit_hours_of_year(&sun->hours, &sun->cones, place, NULL, err);
    if (status == PP_OK)
        status = pp_sunlit_hours_of_day(&sun->march, &sun->cones, place, 3, 21, err);
    return status;
}

static void clear_sun(struct window_sun *sun)
{
    pp_hidden_cones_clear(&sun->cones);
    pp_sky_mask_clear(&sun->mask);
    pp_sunlit_hours_clear(&sun->march);
}

/* Positions of the sun in the sunshine hours of a weather file. visible_h: hours in
 * which the window can see the sun; all_h: all sunshine hours. */
struct weather_sun {
    struct pp_overlay_sun *suns; /* owned */
    int count;
    double visible_h, all_h;
    double latitude_rad; /* latitude of the weather file */
};

/* Smallest difference in latitude that is visible on the diagram. */
static const double far_latitude_rad = 1.0 * PP_RAD;

static enum pp_status find_weather_sun(struct weather_sun *found,
                                       const struct pp_year_options *light,
                                       const struct pp_hidden_cones *cones,
                                       double north_rad, struct pp_error *err)
{
    const struct pp_weather_options options = {.sun_shift_h = NAN};
    struct pp_weather_year year;
    enum pp_status status = pp_weather_year_of_epw(
        &year, light->epw, &options, pp_read_file_title(light->weather), err);
    if (status != PP_OK)
        return status;
    found->latitude_rad = light->epw->latitude_rad;
    found->suns = calloc((size_t)year.count + 1, sizeof *found->suns);
    if (!found->suns)
        status = pp_fail_memory(err);
    for (int i = 0; i < year.count && status == PP_OK; i++) {
        const struct pp_weather_hour *hour = &year.hours[i];
        if (hour->sky < 0)
            continue;
        const struct pp_perez_sky *sky = &year.skies[hour->sky];
        if (!(hour->direct_w_m2 > PP_SUNSHINE_W_M2) || sky->sun.z <= 0.0)
            continue;
        struct pp_perez_sky turned = pp_weather_year_turned(sky, north_rad);
        bool visible = !pp_hidden_cones_hide(cones, turned.sun);
        found->suns[found->count++] = (struct pp_overlay_sun){
            asin(fmin(sky->sun.z, 1.0)), atan2(sky->sun.x, sky->sun.y), visible};
        found->all_h += hour->length_h;
        found->visible_h += visible ? hour->length_h : 0.0;
    }
    pp_weather_year_clear(&year);
    return status;
}

static void say_sun(char *foot, size_t room, const char *when,
                    const struct window_sun *sun, const struct pp_sunlit_year *open)
{
    pp_page_say(
        foot, room,
        "%s window receives %.1f\u00a0%% of the annual hours of sun on open ground "
        "(including %.1f\u00a0%% in winter), and %.1f\u00a0h of sun on 21 March.",
        when, 100.0 * sun->hours.all / open->all, 100.0 * sun->hours.winter / open->all,
        pp_sunlit_hours_sum(&sun->march));
}

static enum pp_status say_sun_path_foot(char *foot, size_t room,
                                        const struct pp_world *world,
                                        const struct window_sun *now,
                                        const struct window_sun *before,
                                        const struct weather_sun *weather,
                                        struct pp_error *err)
{
    const struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                          world->longitude_rad};
    struct pp_sunlit_year open;
    enum pp_status status = pp_sunlit_hours_of_year(&open, NULL, place, NULL, err);
    if (status != PP_OK)
        return status;
    pp_page_say(foot, room,
                "Grey areas are hidden from the centre of the window's outer face by "
                "its own wall or by obstructions%s.",
                before ? "; hatched areas were not hidden before the development" : "");
    if (before)
        say_sun(foot, room, "Existing: the", before, &open);
    say_sun(foot, room, before ? "Proposed: the" : "The", now, &open);
    if (weather)
        pp_page_say(foot, room,
                    "Dots are the hours of the weather file with a direct normal "
                    "irradiance above %g\u00a0W/m\u00b2; in those with a ring the "
                    "sun is hidden. The sun reaches the window in %.0f of these %.0f "
                    "hours.",
                    PP_SUNSHINE_W_M2, weather->visible_h, weather->all_h);
    if (weather && fabs(weather->latitude_rad - world->latitude_rad) > far_latitude_rad)
        pp_page_say(foot, room,
                    "The weather file is for latitude %.4g\u00b0; its hours do not lie "
                    "on the sun paths.",
                    weather->latitude_rad / PP_RAD);
    pp_page_say(foot, room,
                "Possible hours are all hours with the sun above the horizon. The "
                "projection is stereographic, seen from above. Paths are for the 21st "
                "of each month; hours are in solar time.");
    return PP_OK;
}

static enum pp_status draw_sun_path_sheet(struct pp_canvas *canvas,
                                          const struct pp_world *world, int window,
                                          const struct window_sun *now,
                                          const struct window_sun *before,
                                          const struct weather_sun *weather,
                                          struct pp_error *err)
{
    char words[PP_OPENING_WORDS], subtitle[160], foot[1024] = "";
    enum pp_status status =
        say_sun_path_foot(foot, sizeof foot, world, now, before, weather, err);
    if (status != PP_OK)
        return status;
    pp_opening_words(words, world, &world->openings[window]);
    snprintf(subtitle, sizeof subtitle,
             "Sun paths at %.4g\u00b0 %s, with the obstructions seen from window %s",
             fabs(world->latitude_rad) / PP_RAD, world->latitude_rad < 0.0 ? "S" : "N",
             words);
    const struct pp_overlay overlay = {.lens = PP_LENS_STEREOGRAPHIC,
                                       .sun = true,
                                       .latitude_rad = world->latitude_rad,
                                       .title = world->name ? world->name : "Room",
                                       .subtitle = subtitle,
                                       .foot = foot,
                                       .now = &now->mask,
                                       .before = before ? &before->mask : NULL,
                                       .suns = weather ? weather->suns : NULL,
                                       .sun_count = weather ? weather->count : 0};
    return pp_overlay_chart_draw(canvas, &overlay, err);
}

/* Finds the sun at the same window of the room in its former state. PP_BAD_INPUT if the
 * two rooms do not have the same geometry (pair_rooms.h). */
static enum pp_status find_before(struct window_sun *sun, const struct pp_world *world,
                                  const struct pp_world *before, int window,
                                  struct pp_error *err)
{
    int *pairs;
    enum pp_status status = pp_pair_rooms(&pairs, world, before, err);
    if (status == PP_OK)
        status = find_sun(sun, before, pairs[window], err);
    free(pairs);
    return status;
}

static enum pp_status draw_sun_path(struct pp_canvas *canvas,
                                    struct pp_study_room *room,
                                    const struct pp_study_options *study,
                                    const struct pp_chart_choice *choice,
                                    bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    const struct pp_world *world = room->world;
    const struct pp_study_room *former =
        choice->site.before ? choice->site.before[0] : NULL;
    struct window_sun now = {0}, before = {0};
    struct weather_sun weather = {0};
    bool has_weather = choice->availability.epw != NULL;
    int window;
    enum pp_status status =
        pp_choose_window(&window, world, choice->board.window, false, err);
    if (status == PP_OK && isnan(world->latitude_rad))
        return pp_fail(err, PP_BAD_INPUT,
                       "sun paths need a location; expected a site with a latitude in "
                       "the room file");
    if (status == PP_OK)
        status = find_sun(&now, world, window, err);
    if (status == PP_OK && former)
        status = find_before(&before, world, former->world, window, err);
    if (status == PP_OK && has_weather)
        status = find_weather_sun(&weather, &choice->availability, &now.cones,
                                  world->north_rad, err);
    if (status == PP_OK)
        status =
            draw_sun_path_sheet(canvas, world, window, &now, former ? &before : NULL,
                                has_weather ? &weather : NULL, err);
    free(weather.suns);
    clear_sun(&before);
    clear_sun(&now);
    return status;
}

const struct pp_chart_kind pp_draw_sun_path = {
    .name = "sun-path",
    .summary = "sun paths and obstructions seen from a window",
    .of_window = true,
    .of_weather = true,
    .compares = true,
    .draw = draw_sun_path,
};
