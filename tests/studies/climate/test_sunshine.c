/* test_sunshine.c - probability of sunshine from made-up weather files, and probable
 * sunlight hours. */
#include <math.h>
#include <stdlib.h>

#include "methods/exact/sunlit_hours.h"
#include "studies/climate/sunshine.h"
#include "tests/lib/room_of.h"

/* A year at 48.2 N, 16.4 E, an hour ahead of UT, with a direct irradiance (W/m2) for
 * each hour of the clock. */
static struct pp_sunshine sunshine_of(double (*direct)(int month, int day, int hour))
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    struct pp_epw epw = {.latitude_rad = 48.2 * PP_RAD,
                         .longitude_rad = 16.4 * PP_RAD,
                         .time_zone_h = 1.0,
                         .record_h = 1.0};
    epw.records = calloc(8760, sizeof *epw.records);
    assert_non_null(epw.records);
    for (int month = 1; month <= 12; month++)
        for (int day = 1; day <= days[month - 1]; day++)
            for (int hour = 0; hour < 24; hour++)
                epw.records[epw.record_count++] =
                    (struct pp_epw_record){.year = 2019,
                                           .date = {month, day},
                                           .start_h = hour,
                                           .direct_w_m2 = direct(month, day, hour)};
    struct pp_sunshine sunshine = pp_sunshine_of_epw(&epw);
    free(epw.records);
    return sunshine;
}

static double every_third_day(int month, int day, int hour)
{
    (void)month, (void)hour;
    return day % 3 == 0 ? 121.0 : 119.0;
}

static double mornings(int month, int day, int hour)
{
    (void)month, (void)day;
    return hour < 12 ? 700.0 : 0.0;
}

static double never_known(int month, int day, int hour)
{
    (void)month, (void)day, (void)hour;
    return NAN;
}

/* 10 of June's 30 days, 9 of February's 28, 10 of July's 31 have more than 120 W/m2. */
static void one_day_in_three_is_a_third(void **state)
{
    (void)state;
    struct pp_sunshine sunshine = sunshine_of(every_third_day);
    assert_true(sunshine.known);
    for (int hour = 9; hour < 15; hour++) {
        assert_near(sunshine.share[5][hour], 10.0 / 30.0, 1e-12);
        assert_near(sunshine.share[1][hour], 9.0 / 28.0, 1e-12);
        assert_near(sunshine.share[6][hour], 10.0 / 31.0, 1e-12);
    }
    assert_near(sunshine.share[11][2], 0.0, 0.0); /* at night */
    assert_false(sunshine_of(never_known).known);
}

/* 1.4 degrees east of its meridian the noon of the clock is solar noon, except for 5.6
 * minutes and the equation of time: the middle of an hour of the clock is in the same
 * solar hour. */
static void the_clocks_morning_is_the_suns(void **state)
{
    (void)state;
    struct pp_sunshine sunshine = sunshine_of(mornings);
    for (int month = 0; month < 12; month++)
        for (int hour = 9; hour < 15; hour++)
            assert_near(sunshine.share[month][hour], hour < 12 ? 1.0 : 0.0, 0.0);
}

static struct pp_sunlit_year year_of(const char *wall, const double (*share)[24])
{
    char text[1024];
    snprintf(text, sizeof text,
             "<room version=\"1\"><plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>"
             "<window wall=\"%s\" left=\"0.7\" sill=\"0.95\" width=\"1\" "
             "height=\"1.3\"/></room>",
             wall);
    struct pp_world *world = pp_test_world(text);
    struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
    struct pp_sunlit_place place = {48.2 * PP_RAD, 0.0, NAN};
    struct pp_hidden_cones cones;
    struct pp_sunlit_year year;
    assert_int_equal(pp_hidden_cones_init(&cones, world, &view, NULL), PP_OK);
    assert_int_equal(pp_sunlit_hours_of_year(&year, &cones, place, share, NULL), PP_OK);
    pp_hidden_cones_clear(&cones);
    pp_world_destroy(world);
    return year;
}

/* With equal probability in all hours, probable hours are possible hours times this
 * probability. With sun in the mornings only, an east wall has all its hours and a west
 * wall none. */
static void probable_hours_are_possible_ones_times_their_share(void **state)
{
    (void)state;
    double share[12][24];
    for (int i = 0; i < 12 * 24; i++)
        share[i / 24][i % 24] = 0.37;
    struct pp_sunlit_year possible = year_of("south", NULL);
    struct pp_sunlit_year probable = year_of("south", (const double(*)[24])share);
    assert_near(probable.all, 0.37 * possible.all, 1e-7);
    assert_near(probable.winter, 0.37 * possible.winter, 1e-7);
    for (int i = 0; i < 12 * 24; i++)
        share[i / 24][i % 24] = i % 24 < 12;
    assert_near(year_of("east", (const double(*)[24])share).all,
                year_of("east", NULL).all, 1e-7);
    assert_near(year_of("west", (const double(*)[24])share).all, 0.0, 1e-7);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_day_in_three_is_a_third),
        cmocka_unit_test(the_clocks_morning_is_the_suns),
        cmocka_unit_test(probable_hours_are_possible_ones_times_their_share),
    };
    add_tests(tests, NULL, NULL);
}
