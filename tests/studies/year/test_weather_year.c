/* test_weather_year.c - sky and sun of the hours of a weather file, and the sun's
 * position within each record, from its radiation. */
#include "tests/lib/made_epw.h"
#include "tests/lib/near.h"

#include <stdlib.h>

#include "model/light/sun.h"
#include "studies/year/weather_year.h"

/* A weather file of clear days at Brussels. The sun of its global irradiance is that of
 * the middle of the hour plus shift_h; from April to September plus summer_h as
 * well. */
struct made_sky {
    double shift_h, summer_h;
    bool swapped, leap;
};

static double sun_height(int month, int day, double hour)
{
    double n = pp_sun_days_since_2000(2001, month, day, hour - 1.0);
    return fmax(0.0, sin(pp_sun_at(n, 50.90 * PP_RAD, 4.53 * PP_RAD).altitude_rad));
}

static struct pp_epw *made_file(struct made_sky sky)
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    struct made_epw made;
    char said[200];
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Sunday,1/1,12/31");
    for (int month = 1; month <= 12; month++)
        for (int day = 1; day <= days[month - 1] + (sky.leap && month == 2); day++)
            for (int hour = 1; hour <= 24; hour++) {
                bool summer = month >= 4 && month <= 9;
                double shift_h = sky.shift_h + (summer ? sky.summer_h : 0.0);
                double s = sun_height(month, day, hour - 0.5 + shift_h);
                double direct = s > 0.0 ? 800.0 * s / (s + 0.1) : 0.0;
                double diffuse = s > 0.0 ? 20.0 + 90.0 * s : 0.0;
                char global[20], a[20], b[20];
                snprintf(global, sizeof global, "%.0f", direct * s + diffuse);
                snprintf(a, sizeof a, "%.0f", sky.swapped ? diffuse : direct);
                snprintf(b, sizeof b, "%.0f", sky.swapped ? direct : diffuse);
                epw_record(&made,
                           sky.leap    ? 2024
                           : month % 2 ? 1999
                                       : 2003,
                           month, day, hour, 0, global, a, b, "999999");
            }
    struct pp_epw *epw = epw_made(&made, said, sizeof said);
    assert_string_equal(said, "");
    epw_end(&made);
    return epw;
}

static void radiation_of_a_weather_file_shows_its_sun_position(void **state)
{
    (void)state;
    static const struct {
        struct made_sky sky;
        enum pp_sun_closure_finding finding;
        double best_h;
    } files[] = {
        {{.shift_h = 0.0}, PP_CLOSURE_AT_MIDDLE, 0.0},
        {{.shift_h = 0.5}, PP_CLOSURE_SHIFTED, 0.5},
        {{.shift_h = -0.5}, PP_CLOSURE_SHIFTED, -0.5},
        {{.summer_h = 1.0}, PP_CLOSURE_SEASONAL, NAN},
        {{.swapped = true}, PP_CLOSURE_SWAPPED, NAN},
    };
    for (int i = 0; i < 5; i++) {
        struct pp_epw *epw = made_file(files[i].sky);
        struct pp_sun_closure closure = pp_sun_closure_of_epw(epw);
        assert_int_equal(closure.finding, files[i].finding);
        if (!isnan(files[i].best_h)) {
            assert_near(closure.best_h, files[i].best_h, 0.03);
            assert_true(closure.rms_best < 2.0);
        }
        pp_epw_destroy(epw);
    }
}

static struct pp_weather_year year_of(const struct pp_epw *epw, double shift_h,
                                      bool leap_day)
{
    struct pp_weather_year year;
    struct pp_weather_options options = {.sun_shift_h = shift_h, .leap_day = leap_day};
    assert_int_equal(pp_weather_year_of_epw(&year, epw, &options, "made.epw", NULL),
                     PP_OK);
    return year;
}

static void the_shift_found_is_used_unless_another_is_chosen(void **state)
{
    (void)state;
    struct pp_epw *epw = made_file((struct made_sky){.shift_h = 0.5});
    char text[400];
    struct pp_weather_year own = year_of(epw, NAN, false),
                           none = year_of(epw, 0.0, false);
    assert_near(own.sun_shift_h, 0.5, 0.03);
    assert_near(none.sun_shift_h, 0.0, 0.0);
    assert_non_null(pp_weather_year_warning(text, sizeof text, &own));
    assert_non_null(strstr(text, "30 minutes later"));
    /* 21 March, 15:00 to 16:00, hour angle 43.7 degrees between the two: the altitude
     * decreases by cos(latitude) sin(azimuth) times 7.5 degrees in half an hour. */
    struct pp_perez_sky a, b;
    struct pp_month_day equinox = {3, 21};
    assert_int_equal(pp_weather_year_moment(&a, &own, equinox, 15.5, NULL), PP_OK);
    assert_int_equal(pp_weather_year_moment(&b, &none, equinox, 15.5, NULL), PP_OK);
    assert_near(asin(b.sun.z) - asin(a.sun.z), 3.67 * PP_RAD, 0.1 * PP_RAD);
    assert_int_equal(pp_weather_year_moment(&a, &own, equinox, 1.0, NULL),
                     PP_BAD_INPUT);
    pp_weather_year_clear(&own);
    pp_weather_year_clear(&none);
    pp_epw_destroy(epw);
}

/* Annual direct irradiation on vertical planes that face east, west and south,
 * kWh/m2. */
struct facades {
    double east, west, south;
};

static struct facades facades_of(const struct pp_epw *epw, double shift_h)
{
    struct pp_weather_year year = year_of(epw, shift_h, false);
    struct facades sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < year.count; i++) {
        const struct pp_weather_hour *hour = &year.hours[i];
        if (hour->sky < 0 || !(year.skies[hour->sky].sun.z > 0.0))
            continue;
        struct pp_vec3 sun = year.skies[hour->sky].sun;
        sum.east += 1e-3 * hour->direct_w_m2 * fmax(0.0, sun.x);
        sum.west += 1e-3 * hour->direct_w_m2 * fmax(0.0, -sun.x);
        sum.south += 1e-3 * hour->direct_w_m2 * fmax(0.0, -sun.y);
    }
    pp_weather_year_clear(&year);
    return sum;
}

/* The direct light of the made file depends on the height of the sun alone, so that
 * east and west facades receive the same. With a sun half an hour early the east facade
 * receives too much. */
static void clear_days_light_east_and_west_alike(void **state)
{
    (void)state;
    struct pp_epw *epw = made_file((struct made_sky){.shift_h = 0.5});
    struct facades found = facades_of(epw, NAN), early = facades_of(epw, 0.0);
    assert_relative(found.east, found.west, 0.01);
    assert_true(early.east > 1.2 * early.west);
    assert_relative(found.south, early.south, 0.03);
    pp_epw_destroy(epw);
}

/* Tokyo's file, if available: by the usual rule its east facade would receive 300 and
 * its west facade 205 kWh/m2 (own calculation of the closure, without parts of hours at
 * sunrise, which add up to 6 in the east). */
static void sun_of_tokyo_is_half_an_hour_later(void **state)
{
    (void)state;
    const char *folder = getenv("EPW_FILES");
    char path[1024];
    struct pp_epw *epw;
    struct pp_mistakes mistakes;
    if (!folder)
        skip();
    snprintf(path, sizeof path, "%s/tokyo.epw", folder);
    pp_mistakes_init(&mistakes, path);
    assert_int_equal(pp_epw_read(&epw, path, &mistakes, NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    struct facades found = facades_of(epw, NAN), usual = facades_of(epw, 0.0);
    assert_near(found.east, 255.0, 1.0);
    assert_near(found.west, 253.0, 1.0);
    assert_near(found.south, 475.0, 1.0);
    assert_near(usual.east, 300.0, 6.0);
    assert_near(usual.west, 205.0, 1.0);
    assert_near(usual.south, 472.0, 1.0);
    pp_epw_destroy(epw);
}

static void every_record_has_its_place(void **state)
{
    (void)state;
    struct pp_epw *epw = made_file((struct made_sky){.leap = true});
    struct pp_weather_year year = year_of(epw, 0.0, false);
    assert_int_equal(year.count, 8760);
    assert_int_equal(year.leap_records, 24);
    assert_int_equal(year.sun_year, 2024); /* of all records */
    assert_int_equal(year.hours[59 * 24].date.month, 3);
    pp_weather_year_clear(&year);
    year = year_of(epw, 0.0, true);
    assert_int_equal(year.count, 8784);
    pp_weather_year_clear(&year);
    pp_epw_destroy(epw);
    epw = made_file((struct made_sky){.leap = false});
    year = year_of(epw, 0.0, false);
    assert_int_equal(year.sun_year, 2001); /* a typical year: of several years */
    pp_weather_year_clear(&year);
    pp_epw_destroy(epw);
}

/* In a room whose y axis points east (bearing 90), a sun in the east is along y. */
static void skies_turn_with_the_room(void **state)
{
    (void)state;
    struct pp_perez_sky sky = {.sun = {0.8, 0.0, 0.6}};
    struct pp_perez_sky turned = pp_weather_year_turned(&sky, PP_PI / 2.0);
    assert_near(turned.sun.y, 0.8, 1e-12);
    assert_near(turned.sun.x, 0.0, 1e-12);
    sky.sun = pp_vec(0.0, 0.8, 0.6); /* north is to the left of it: -x */
    assert_near(pp_weather_year_turned(&sky, PP_PI / 2.0).sun.x, -0.8, 1e-12);
}

/* A year without light, except for one record of an hour. */
struct one_hour {
    struct pp_epw epw;
    struct pp_epw_record records[8760];
};

static struct pp_weather_year lit_hour(struct one_hour *made, double latitude_deg,
                                       double longitude_deg, double time_zone_h,
                                       const struct pp_epw_record *lit)
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    static char place[] = "made up";
    made->epw = (struct pp_epw){.place = place,
                                .latitude_rad = latitude_deg * PP_RAD,
                                .longitude_rad = longitude_deg * PP_RAD,
                                .time_zone_h = time_zone_h,
                                .record_h = 1.0,
                                .records = made->records};
    for (int month = 1; month <= 12; month++)
        for (int day = 1; day <= days[month - 1]; day++)
            for (int hour = 0; hour < 24; hour++) {
                struct pp_epw_record *record = &made->records[made->epw.record_count++];
                *record = (struct pp_epw_record){.year = 2001,
                                                 .date = {month, day},
                                                 .weekday = PP_WEEKDAY_UNKNOWN,
                                                 .start_h = hour,
                                                 .global_w_m2 = NAN,
                                                 .diffuse_lx = NAN};
                if (pp_month_day_same(record->date, lit->date)
                    && record->start_h == lit->start_h)
                    *record = *lit;
            }
    return year_of(&made->epw, 0.0, false);
}

/* At Oslo on 31 January the sun is 0.57 degrees high at 16:15 and sets at 16:21, before
 * the middle of the record from 16 to 17 h. The direct light of this record is assigned
 * to its sunlit part, in the middle of which the sun is about 1.1 degrees high. */
static void the_hour_of_sunset_has_the_sun_of_its_sunlit_part(void **state)
{
    (void)state;
    static struct one_hour made;
    struct pp_epw_record lit = {.year = 2001,
                                .date = {1, 31},
                                .weekday = PP_WEEKDAY_UNKNOWN,
                                .start_h = 16.0,
                                .direct_w_m2 = 60.0,
                                .diffuse_w_m2 = 9.0,
                                .global_w_m2 = NAN,
                                .diffuse_lx = NAN};
    struct pp_weather_year year = lit_hour(&made, 59.9, 10.62, 1.0, &lit);
    assert_int_equal(year.sky_count, 1);
    assert_int_equal(year.moved_suns, 1);
    assert_near(asin(year.skies[0].sun.z), 1.1 * PP_RAD, 0.2 * PP_RAD);
    assert_true(year.skies[0].direct_lx > 0.0 && year.skies[0].diffuse_lx > 0.0);
    pp_weather_year_clear(&year);
    lit.start_h = 18.0; /* the sun is down throughout: the sky remains */
    year = lit_hour(&made, 59.9, 10.62, 1.0, &lit);
    assert_int_equal(year.sky_count, 1);
    assert_int_equal(year.sunless_beams, 1);
    assert_near(year.skies[0].direct_lx, 0.0, 0.0);
    assert_true(year.skies[0].diffuse_lx > 0.0);
    pp_weather_year_clear(&year);
}

/* Between the hours of a weather file nothing is interpolated: direct light of an hour
 * stays in it, so that the sum over the year is kept and no sun shines after sunset. In
 * records of ten minutes with the same irradiance each has the sun of its own middle,
 * and six of them have the horizontal direct light of the hour, to 0.5 %, as luminous
 * efficacy and the sine of the altitude are nearly linear within an hour. */
static void ten_minute_records_have_their_own_suns_and_the_light_of_their_hour(
    void **state)
{
    (void)state;
    static struct one_hour made;
    const struct pp_epw_record lit = {.year = 2001,
                                      .date = {4, 11},
                                      .weekday = PP_WEEKDAY_UNKNOWN,
                                      .start_h = 8.0,
                                      .direct_w_m2 = 510.0,
                                      .diffuse_w_m2 = 90.0,
                                      .global_w_m2 = NAN,
                                      .diffuse_lx = NAN};
    struct pp_weather_year hourly = lit_hour(&made, 41.98, -87.92, -6.0, &lit);
    assert_int_equal(hourly.sky_count, 1); /* none in the hours beside it */
    const struct pp_perez_sky hour = hourly.skies[0];
    pp_weather_year_clear(&hourly);
    static struct pp_epw_record parts[6 * 8760];
    for (int i = 0; i < 6 * 8760; i++) {
        parts[i] = made.records[i / 6];
        parts[i].start_h += i % 6 / 6.0;
    }
    struct pp_epw fine = made.epw;
    fine.records = parts;
    fine.record_count = 6 * 8760;
    fine.record_h = 1.0 / 6.0;
    struct pp_weather_year year = year_of(&fine, 0.0, false);
    assert_int_equal(year.sky_count, 6);
    double sum = 0.0;
    for (int i = 0; i < 6; i++) {
        sum += year.skies[i].direct_lx * year.skies[i].sun.z / 6.0;
        if (i > 0) /* the sun climbs by about 1.8 degrees in ten minutes */
            assert_near(asin(year.skies[i].sun.z) - asin(year.skies[i - 1].sun.z),
                        1.8 * PP_RAD, 0.3 * PP_RAD);
    }
    assert_relative(sum, hour.direct_lx * hour.sun.z, 0.005);
    pp_weather_year_clear(&year);
}

/* As in a weather file of New Delhi: the ratio in the formula for clearness is
 * infinite. */
static void direct_light_alone_is_counted_and_dated(void **state)
{
    (void)state;
    static struct one_hour made;
    char text[600];
    const struct pp_epw_record lit = {.year = 2001,
                                      .date = {5, 5},
                                      .weekday = PP_WEEKDAY_UNKNOWN,
                                      .start_h = 10.0,
                                      .direct_w_m2 = 640.0,
                                      .diffuse_w_m2 = 0.0,
                                      .global_w_m2 = NAN,
                                      .diffuse_lx = NAN};
    struct pp_weather_year year = lit_hour(&made, 28.58, 77.2, 5.5, &lit);
    assert_int_equal(year.no_diffuse, 1);
    assert_int_equal(year.skies[0].bin, 8);
    assert_true(isfinite(year.skies[0].clearness));
    assert_true(year.skies[0].direct_lx > 4e4 && year.skies[0].direct_lx < 9e4);
    pp_weather_year_notes(text, sizeof text, &year);
    assert_non_null(strstr(text, "the first on 5 May at 10 h"));
    pp_weather_year_clear(&year);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(radiation_of_a_weather_file_shows_its_sun_position),
        cmocka_unit_test(the_shift_found_is_used_unless_another_is_chosen),
        cmocka_unit_test(clear_days_light_east_and_west_alike),
        cmocka_unit_test(sun_of_tokyo_is_half_an_hour_later),
        cmocka_unit_test(every_record_has_its_place),
        cmocka_unit_test(skies_turn_with_the_room),
        cmocka_unit_test(the_hour_of_sunset_has_the_sun_of_its_sunlit_part),
        cmocka_unit_test(
            ten_minute_records_have_their_own_suns_and_the_light_of_their_hour),
        cmocka_unit_test(direct_light_alone_is_counted_and_dated),
    };
    add_tests(tests, NULL, NULL);
}
