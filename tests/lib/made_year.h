/* made_year.h - a made-up year of some hours, for tests of a year's daylight. */
#ifndef PP_TESTS_LIB_MADE_YEAR_H
#define PP_TESTS_LIB_MADE_YEAR_H

#include <math.h>
#include <string.h>

#include "studies/year/annual.h"
#include "tests/lib/near.h"

/* A made-up year: at most 240 hours, the 20 hours from midnight on the first day of each
 * month, with the given skies. */
struct pp_test_year {
    struct pp_epw epw;
    struct pp_weather_year year;
    struct pp_weather_hour hours[240];
    struct pp_perez_sky skies[240];
};

static inline struct pp_vec3 pp_test_toward(double altitude_deg, double bearing_deg)
{
    double h = altitude_deg * PP_RAD, az = bearing_deg * PP_RAD;
    return pp_vec(cos(h) * sin(az), cos(h) * cos(az), sin(h));
}

static inline void pp_test_add_hour(struct pp_test_year *made,
                                    const struct pp_perez_sky *sky)
{
    int i = made->year.count++;
    made->hours[i] = (struct pp_weather_hour){.date = {1 + i / 20, 1},
                                              .weekday = 0,
                                              .start_h = i % 20,
                                              .length_h = 1.0,
                                              .known = true,
                                              .lit = sky != NULL,
                                              .sky = sky ? made->year.sky_count : -1};
    if (sky)
        made->skies[made->year.sky_count++] = *sky;
}

static inline void pp_test_make_year(struct pp_test_year *made)
{
    memset(made, 0, sizeof *made);
    static char nowhere[] = "Nowhere";
    made->epw.place = nowhere;
    made->epw.record_h = 1.0;
    made->year.epw = &made->epw;
    made->year.hours = made->hours;
    made->year.skies = made->skies;
}

/* Clear, half-clear and overcast hours, with suns in the east, south and west. */
static inline void pp_test_make_mixed_year(struct pp_test_year *made)
{
    static const double bearings[] = {97.0, 131.0, 163.0, 179.0, 208.0, 247.0};
    pp_test_make_year(made);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 4; k++) {
            struct pp_perez_conditions conditions = {
                .direct_w_m2 = 260.0 * k,
                .diffuse_w_m2 = 190.0 - 35.0 * k,
                .sun = pp_test_toward(13.0 + 11.0 * k - fabs(i - 2.5), bearings[i]),
                .sun_distance_au = 1.0,
                .dew_point_c = 9.0};
            struct pp_perez_sky sky = pp_perez_sky_of(&conditions);
            pp_test_add_hour(made, &sky);
        }
}

static inline struct pp_annual_options pp_test_whole_day(int samples)
{
    return (struct pp_annual_options){.hours = {0.0, 24.0, PP_ALL_DAYS},
                                      .illuminance_count = 1,
                                      .illuminances_lx = {300.0},
                                      .patches = 577,
                                      .samples = samples,
                                      .blinds = PP_BLINDS_LM83,
                                      .seed = 3};
}

static inline void pp_test_year_of(struct pp_annual_sheet *sheet,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_test_year *made,
                                   const struct pp_annual_options *options)
{
    assert_int_equal(pp_annual_of_room(sheet, world, light, world->receivers,
                                       world->receiver_count, false, &made->year,
                                       options, NULL),
                     PP_OK);
    assert_true(sheet->finished);
}

#endif
