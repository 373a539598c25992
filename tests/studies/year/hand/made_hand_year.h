/* made_hand_year.h - a made-up year and a room, for tests of hand methods for the year. */
#ifndef PP_TESTS_STUDIES_YEAR_HAND_MADE_HAND_YEAR_H
#define PP_TESTS_STUDIES_YEAR_HAND_MADE_HAND_YEAR_H

#include "studies/year/hand/hand_year.h"
#include "tests/lib/room_of.h"

enum { MADE_HOURS_MOST = 48 };

struct made_hand_year {
    struct pp_epw epw;
    struct pp_weather_year year;
    struct pp_weather_hour hours[MADE_HOURS_MOST];
    struct pp_perez_sky skies[MADE_HOURS_MOST];
};

static inline void made_hand_year_init(struct made_hand_year *made)
{
    static char nowhere[] = "Nowhere";
    memset(made, 0, sizeof *made);
    made->epw.place = nowhere;
    made->epw.latitude_rad = 0.9;
    made->epw.record_h = 1.0;
    made->year.epw = &made->epw;
    made->year.hours = made->hours;
    made->year.skies = made->skies;
}

/* Adds one hour of that sky, with direct light of direct_lx, on the first of a month. */
static inline void made_hand_year_add(struct made_hand_year *made, int month,
                                      double start_h, struct pp_perez_sky sky,
                                      double diffuse_lx, double direct_lx,
                                      double cloud_cover)
{
    int i = made->year.count++;
    pp_perez_sky_set_diffuse(&sky, diffuse_lx);
    sky.direct_lx = direct_lx;
    made->skies[made->year.sky_count++] = sky;
    made->hours[i] = (struct pp_weather_hour){.date = {month, 1},
                                              .weekday = 0,
                                              .start_h = start_h,
                                              .length_h = 1.0,
                                              .known = true,
                                              .lit = true,
                                              .sky = i,
                                              .direct_w_m2 = direct_lx / 100.0,
                                              .cloud_cover = cloud_cover};
}

static inline struct pp_vec3 made_hand_year_sun(double altitude_deg, double bearing_deg)
{
    double h = altitude_deg * PP_RAD, az = bearing_deg * PP_RAD;
    return pp_vec(cos(h) * sin(az), cos(h) * cos(az), sin(h));
}

static const char made_hand_room[] =
    "<room version='1' north='%d'><plan width='3.7' depth='5.3' height='2.9'/>"
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
    "<window wall='south' left='0.6' sill='0.9' width='2.3' height='1.7' "
    "transmittance='0.7'/><working-plane height='0.85'/>"
    "<point x='1.1' y='0.9'/><point x='1.9' y='4.6'/></room>";

/* The room, and its options: all hours, 300 lx, 16 x 64 paths. */
struct made_hand_room {
    char text[640];
    struct pp_study_room room;
    struct pp_annual_options annual;
    struct pp_hand_year_options options;
};

static inline void made_hand_room_init(struct made_hand_room *made, int north_deg,
                                       const char *methods)
{
    memset(made, 0, sizeof *made);
    snprintf(made->text, sizeof made->text, made_hand_room, north_deg);
    made->room.world = pp_test_lit_world(&made->room.light, made->text);
    made->room.receivers = made->room.world->receivers;
    made->room.receiver_count = made->room.world->receiver_count;
    made->annual = (struct pp_annual_options){.hours = {0.0, 24.0, PP_ALL_DAYS},
                                              .illuminance_count = 1,
                                              .illuminances_lx = {300.0},
                                              .patches = 145,
                                              .samples = 64,
                                              .seed = 3};
    assert_int_equal(pp_year_method_choose(&made->options.methods, methods, NULL),
                     PP_OK);
}

static inline void made_hand_room_clear(struct made_hand_room *made)
{
    pp_world_destroy(made->room.world);
}

#endif
