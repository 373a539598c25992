/* test_criterion_margin.c - margin of a room relative to the requirements of a
 * criterion. */
#include "studies/sizing/criterion_margin.h"
#include "studies/sizing/size_room.h"

#include <math.h>
#include <stdio.h>

#include "model/room/building.h"
#include "model/room/room_light.h"
#include "tests/lib/near.h"

static struct pp_study_room room;
static struct pp_building *building;

/* A room 4.1 m wide and 5.7 m deep with one window 1.7 m high and width_m wide. */
static void set_up(double width_m)
{
    char xml[1024];
    struct pp_mistakes mistakes;
    struct pp_world *world;
    struct pp_outside_light light;
    pp_mistakes_init(&mistakes, "test");
    snprintf(xml, sizeof xml,
             "<room version='1'><site latitude='51.5' longitude='-0.1'/>"
             "<plan width='4.1' depth='5.7' height='2.9'/>"
             "<window wall='south' left='0.3' sill='0.9' width='%.10g' height='1.7'/>"
             "</room>",
             width_m);
    if (pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL) != PP_OK)
        fail_msg("%s", mistakes.count ? mistakes.list[0].text : "no building");
    const struct pp_room *only = pp_building_room(building, 0);
    assert_int_equal(pp_world_create(&world, only, &mistakes, NULL), PP_OK);
    assert_int_equal(pp_room_light(&light, only, NULL), PP_OK);
    pp_study_room_init(&room, "test.xml", building, 0, only, world, &light);
    pp_mistakes_clear(&mistakes);
}

static void tear_down(void)
{
    pp_study_room_clear(&room);
    pp_building_destroy(building);
}

static double margin_for(const char *words, char why[200])
{
    struct pp_reading reading;
    struct pp_error err;
    if (pp_criterion_margin(&reading, why, 200, words, &room, room.world,
                            &(struct pp_grid_choice){0}, NULL, &err)
        != PP_OK)
        fail_msg("%s", err.message);
    return reading.value;
}

/* Requirements are glass of 8 % and openings of 12.5 % of the floor; the openings have
 * the lower margin. */
static void a_third_of_the_window_wanted_is_a_third(void **state)
{
    (void)state;
    char why[200];
    double wanted_m = 0.125 * 4.1 * 5.7 / 1.7;
    set_up(wanted_m);
    assert_near(margin_for("glazing-ratio", why), 1.0, 1e-9);
    assert_near(margin_for("glazing-ratio:glass over floor", why), 0.125 / 0.08, 1e-9);
    tear_down();
    set_up(wanted_m / 3.0);
    assert_near(margin_for("glazing-ratio", why), 1.0 / 3.0, 1e-9);
    tear_down();
}

/* d/w + d/h must be at most 2 / (1 - R), where R is the mean reflectance of the rear
 * half of the room: floor and ceiling, 0.2 and 0.7, each 4.1 m by 2.85 m, and walls of
 * 0.5, 2.9 m high. */
static void margin_of_an_upper_limit_is_the_limit_over_the_figure(void **state)
{
    (void)state;
    char why[200];
    set_up(2.1);
    double level = 4.1 * 2.85, walls = 2.9 * (4.1 + 2.0 * 2.85);
    double mean = (0.9 * level + 0.5 * walls) / (2.0 * level + walls);
    double figure = 5.7 / 4.1 + 5.7 / 2.6;
    assert_near(margin_for("limiting-depth", why), 2.0 / (1.0 - mean) / figure, 1e-9);
    tear_down();
}

/* Bedroom, living room and kitchen: 1, 1.5 and 2 % of one average. */
static void a_requirement_of_a_criterion_is_selected_by_its_first_words(void **state)
{
    (void)state;
    char why[200];
    set_up(2.1);
    double bedroom = margin_for("average:bedroom", why),
           kitchen = margin_for("average:kitchen", why);
    assert_near(bedroom, 2.0 * kitchen, 1e-9);
    assert_near(margin_for("average:living", why), bedroom / 1.5, 1e-9);
    assert_near(margin_for("average", why), kitchen, 1e-12);
    tear_down();
}

static void a_figure_without_a_limit_has_no_margin(void **state)
{
    (void)state;
    char why[200];
    set_up(2.1);
    assert_true(isnan(margin_for("no-sky-line", why)));
    assert_non_null(strstr(why, "no requirement"));
    assert_true(isnan(margin_for("former-sky", why)));
    assert_non_null(strstr(why, "before"));
    assert_true(isnan(margin_for("average:attic", why)));
    assert_non_null(strstr(why, "begins with \"attic\""));
    tear_down();
}

static void an_unknown_criterion_is_rejected(void **state)
{
    (void)state;
    struct pp_error err;
    assert_int_equal(pp_criterion_margin_check("uk-annex:kitchen", &err), PP_OK);
    assert_int_equal(pp_criterion_margin_check("uk-anex", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "uk-annex"));
    assert_int_equal(pp_criterion_margin_check("average,uk-annex", &err), PP_BAD_INPUT);
    assert_int_equal(pp_criterion_margin_check("leed-v4.1", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "simulated year"));
}

static bool look_twice(void *data, double done, double error)
{
    int *looks = data;
    assert_in_range((int)(100.0 * done), 0, 95);
    assert_true(isnan(error));
    return ++*looks < 3;
}

static void a_search_by_hand_is_watched(void **state)
{
    (void)state;
    int looks = 0;
    struct pp_study_options study = PP_STUDY_OPTIONS_NONE;
    study.watch = (struct pp_watch){.look = look_twice, .data = &looks};
    const struct pp_size_request request = {.study = &study,
                                            .target = 1.0,
                                            .criterion = "glazing-ratio",
                                            .change = PP_CHANGE_WIDTH};
    struct pp_size_room_result result;
    set_up(1.3);
    assert_int_equal(pp_size_room(&result, &room, &request, NULL), PP_INTERRUPTED);
    assert_int_equal(looks, 3);
    pp_size_room_result_clear(&result);
    tear_down();
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_third_of_the_window_wanted_is_a_third),
        cmocka_unit_test(margin_of_an_upper_limit_is_the_limit_over_the_figure),
        cmocka_unit_test(a_requirement_of_a_criterion_is_selected_by_its_first_words),
        cmocka_unit_test(a_figure_without_a_limit_has_no_margin),
        cmocka_unit_test(an_unknown_criterion_is_rejected),
        cmocka_unit_test(a_search_by_hand_is_watched),
    };
    add_tests(tests, NULL, NULL);
}
