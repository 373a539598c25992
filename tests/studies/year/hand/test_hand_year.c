/* test_hand_year.c - hand methods for the year: each is exact for the weather that it
 * assumes. */
#include "studies/year/hand/hand_case.h"
#include "tests/studies/year/hand/made_hand_year.h"

static void compute_both(struct pp_hand_year_sheet *hand, struct pp_annual_sheet *sheet,
                         const struct made_hand_room *made,
                         const struct made_hand_year *year)
{
    assert_int_equal(pp_annual_of_room(sheet, made->room.world, &made->room.light,
                                       made->room.receivers, made->room.receiver_count,
                                       false, &year->year, &made->annual, NULL),
                     PP_OK);
    assert_int_equal(pp_hand_year_of_room(hand, &made->room, &year->year, &made->annual,
                                          &made->options, NULL),
                     PP_OK);
}

/* Asserts that the methods have the mean illuminance of the simulation. The paths are
 * the same, so only single precision causes differences. */
static void methods_are_exact(const struct made_hand_year *year, const char *methods,
                              int north_deg)
{
    struct made_hand_room made;
    struct pp_hand_year_sheet hand;
    struct pp_annual_sheet sheet;
    made_hand_room_init(&made, north_deg, methods);
    compute_both(&hand, &sheet, &made, year);
    for (int i = 0; i < hand.column_count; i++)
        for (int x = 0; x < sheet.receiver_count; x++) {
            const struct pp_hand_figures *by_hand = &hand.columns[i].points[x];
            assert_near(by_hand->mean_lx / sheet.points[x].mean_lx.value, 1.0, 1e-4);
            assert_near(by_hand->autonomy[0], sheet.points[x].autonomy[0].value, 1e-9);
            assert_near(by_hand->udi_good, sheet.points[x].udi_good.value, 1e-9);
            assert_near(by_hand->udi_below, sheet.points[x].udi_below.value, 1e-9);
        }
    pp_hand_year_sheet_clear(&hand);
    pp_annual_sheet_clear(&sheet);
    made_hand_room_clear(&made);
}

static void overcast_year_is_the_daylight_factor_times_outside(void **state)
{
    (void)state;
    struct made_hand_year year;
    made_hand_year_init(&year);
    struct pp_vec3 up = {0.0, 0.0, 1.0};
    for (int i = 0; i < 8; i++)
        made_hand_year_add(&year, 1 + i, 9.0 + i,
                           pp_standard_sky_of(PP_STANDARD_OVERCAST, up),
                           4000.0 + 3100.0 * i, 0.0, 1.0);
    methods_are_exact(
        &year, "df-diffuse,df-global,doe2,adeline,adeline-mean,classes-scaled", 0);
}

/* At one of the 20 positions without clouds doe2 does not interpolate: the azimuth is
 * 55 degrees west of south, and the altitude the highest of the year. */
static void clear_hours_at_a_node_are_those_of_doe2(void **state)
{
    (void)state;
    struct made_hand_year year;
    made_hand_year_init(&year);
    struct pp_vec3 sun = made_hand_year_sun(46.0, 180.0 + 55.0);
    for (int i = 0; i < 5; i++)
        made_hand_year_add(&year, 1 + i, 9.0 + i,
                           pp_standard_sky_of(PP_STANDARD_CLEAR, sun),
                           4000.0 + 1700.0 * i, 9000.0 * i, 0.0);
    methods_are_exact(&year, "doe2", 0);
    methods_are_exact(&year, "doe2", 70);
}

/* One hour in each month at each time of day: the mean sun is its sun, and the mean
 * weather its weather. EnergyPlus treats a clearness above 6 as entirely clear. */
static void single_clear_hours_are_those_of_monthly_methods(void **state)
{
    (void)state;
    struct made_hand_year year;
    made_hand_year_init(&year);
    for (int i = 0; i < 5; i++) {
        struct pp_perez_sky sky = pp_standard_sky_of(
            PP_STANDARD_CLEAR, made_hand_year_sun(17.0 + 8.0 * i, 121.0 + 31.0 * i));
        sky.clearness = 6.5;
        sky.bin = 8;
        made_hand_year_add(&year, 2 + i, 8.0 + i, sky, 5000.0 + 900.0 * i,
                           31000.0 + 9000.0 * i, 0.0);
    }
    methods_are_exact(&year, "adeline,adeline-mean,four-skies,classes,classes-scaled",
                      20);
}

static double figure_of(const struct made_hand_year *year, const char *method,
                        int north_deg, bool dark_df)
{
    struct made_hand_room made;
    struct pp_hand_year_sheet hand;
    made_hand_room_init(&made, north_deg, method);
    made.options.overcast = dark_df ? PP_STANDARD_ISO_1 : PP_STANDARD_OVERCAST;
    assert_int_equal(pp_hand_year_of_room(&hand, &made.room, &year->year, &made.annual,
                                          &made.options, NULL),
                     PP_OK);
    double mean = hand.columns[0].points[1].mean_lx;
    pp_hand_year_sheet_clear(&hand);
    made_hand_room_clear(&made);
    return mean;
}

static void fill_overcast(struct made_hand_year *year)
{
    struct pp_vec3 up = {0.0, 0.0, 1.0};
    made_hand_year_init(year);
    made_hand_year_add(year, 3, 12.0, pp_standard_sky_of(PP_STANDARD_OVERCAST, up),
                       11000.0, 0.0, 1.0);
}

/* 1.2 facing the equator, 1 facing east and west, 0.77 facing the pole; half-way between
 * two of these at 45 and 135 degrees. */
static void orientation_factor_follows_the_facade(void **state)
{
    (void)state;
    struct made_hand_year year;
    fill_overcast(&year);
    double plain = figure_of(&year, "df-diffuse", 0, false);
    assert_near(figure_of(&year, "df-orientation", 0, false) / plain, 1.2, 1e-5);
    assert_near(figure_of(&year, "df-orientation", 180, false) / plain, 0.77, 1e-5);
    assert_near(figure_of(&year, "df-orientation", 45, false) / plain, 1.1, 1e-5);
    assert_near(figure_of(&year, "df-orientation", 135, false) / plain, 0.885, 1e-5);
    /* South of the equator the wall named south faces the pole. */
    year.epw.latitude_rad = -0.6;
    assert_near(figure_of(&year, "df-orientation", 0, false) / plain, 0.77, 1e-5);
}

/* Without sun the rule is the daylight factor times k_d: 1.25 facing the equator, 1.05
 * east, 1.10 the pole, 1.35 west. The room's window faces south if north is 0. */
static void rule_scales_diffuse_light_by_orientation(void **state)
{
    (void)state;
    static const double expected[4] = {1.25, 1.35, 1.10, 1.05};
    struct made_hand_year year;
    fill_overcast(&year);
    double plain = figure_of(&year, "df-diffuse", 0, false);
    for (int i = 0; i < 4; i++)
        assert_near(figure_of(&year, "df-rule", 90 * i, false) / plain, expected[i],
                    1e-5);
}

/* Type 1 of ISO 15469 is darker near the horizon, which is the part seen from the back
 * of the room. */
static void type_1_gives_less_light_to_the_back_of_the_room(void **state)
{
    (void)state;
    struct made_hand_year year;
    fill_overcast(&year);
    double ratio = figure_of(&year, "df-diffuse", 0, true)
                   / figure_of(&year, "df-diffuse", 0, false);
    assert_true(ratio > 0.85 && ratio < 0.97);
}

/* EnergyPlus's overcast sky is that of Moon and Spencer, whatever the daylight factors
 * are for. At a clearness of 1 and a brightness of 0.05 the sky is entirely overcast,
 * and the method gives the daylight factor times diffuse light. */
static void overcast_sky_of_four_skies_is_that_of_moon_and_spencer(void **state)
{
    (void)state;
    struct made_hand_year year;
    fill_overcast(&year);
    year.skies[0].brightness = 0.05;
    double lx = figure_of(&year, "four-skies", 0, true);
    assert_near(lx, figure_of(&year, "four-skies", 0, false), 0.0);
    assert_relative(lx, figure_of(&year, "df-diffuse", 0, false), 1e-6);
    assert_true(lx > 1.03 * figure_of(&year, "df-diffuse", 0, true));
}

/* Equal windows facing south, north and west. A screen with an openness of a quarter is
 * in front of the north window, and dirt halves the light of the west window: shares 4
 * : 1 : 2. */
static void orientations_count_by_the_light_that_their_windows_pass(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='4' depth='4' height='3'/>"
        "<window wall='south' left='1' sill='1' width='1' height='1' "
        "maintenance='0.8'/>"
        "<window wall='north' left='1' sill='1' width='1' height='1' maintenance='0.8'>"
        "<screen openness='0.25'/></window>"
        "<window wall='west' left='1' sill='1' width='1' height='1' maintenance='0.4'/>"
        "<point x='2' y='2'/></room>";
    struct pp_world *world = pp_test_world(xml);
    const struct pp_hand_case of = {.world = world};
    static const double shares[4] = {4.0 / 7.0, 0.0, 1.0 / 7.0, 2.0 / 7.0};
    for (int i = 0; i < 4; i++) {
        double values[4] = {0.0};
        values[i] = 1.0;
        assert_near(pp_hand_case_by_facade(&of, values), shares[i], 1e-9);
    }
    pp_world_destroy(world);
}

static void wrong_names_are_refused(void **state)
{
    (void)state;
    struct pp_year_methods_choice choice;
    struct pp_error err = {0};
    assert_int_equal(pp_year_method_choose(&choice, "doe2,doe3", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "did you mean doe2"));
    assert_int_equal(pp_year_method_choose(&choice, "doe2,", NULL), PP_BAD_INPUT);
    assert_int_equal(pp_year_method_choose(&choice, "classes,doe2", NULL), PP_OK);
    assert_int_equal(choice.count, 2);
    assert_string_equal(choice.list[0]->name, "doe2");
}

/* Public sources give no coefficients of the lumen method hour by hour. The message says
 * so, instead of listing other names only. */
static void hourly_lumen_method_is_refused_with_its_reason(void **state)
{
    (void)state;
    struct pp_year_methods_choice choice;
    struct pp_error err = {0};
    assert_int_equal(pp_year_method_choose(&choice, "doe2,lumen", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "public sources do not give the coefficients"));
    assert_int_equal(pp_year_method_choose(&choice, "lumen-one", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "lumen-one is not available for the year"));
}

/* A file without cloud cover leaves doe2 without figures, but not the other methods. */
static void doe2_needs_the_cloud_cover(void **state)
{
    (void)state;
    struct made_hand_year year;
    struct made_hand_room made;
    struct pp_hand_year_sheet hand;
    fill_overcast(&year);
    year.hours[0].cloud_cover = NAN;
    made_hand_room_init(&made, 0, "doe2,df-global");
    assert_int_equal(pp_hand_year_of_room(&hand, &made.room, &year.year, &made.annual,
                                          &made.options, NULL),
                     PP_OK);
    assert_string_equal(hand.columns[1].name, "doe2");
    assert_non_null(strstr(hand.columns[1].why, "total sky cover"));
    assert_true(isnan(hand.columns[1].points[0].mean_lx));
    assert_true(hand.columns[0].points[0].mean_lx > 0.0);
    pp_hand_year_sheet_clear(&hand);
    made_hand_room_clear(&made);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(overcast_year_is_the_daylight_factor_times_outside),
        cmocka_unit_test(clear_hours_at_a_node_are_those_of_doe2),
        cmocka_unit_test(single_clear_hours_are_those_of_monthly_methods),
        cmocka_unit_test(orientation_factor_follows_the_facade),
        cmocka_unit_test(overcast_sky_of_four_skies_is_that_of_moon_and_spencer),
        cmocka_unit_test(orientations_count_by_the_light_that_their_windows_pass),
        cmocka_unit_test(rule_scales_diffuse_light_by_orientation),
        cmocka_unit_test(type_1_gives_less_light_to_the_back_of_the_room),
        cmocka_unit_test(wrong_names_are_refused),
        cmocka_unit_test(hourly_lumen_method_is_refused_with_its_reason),
        cmocka_unit_test(doe2_needs_the_cloud_cover),
    };
    add_tests(tests, NULL, NULL);
}
