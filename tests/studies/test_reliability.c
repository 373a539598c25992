/* test_reliability.c - warnings that hand figures are unreliable, for reports with
 * known shares. */
#include "studies/reliability.h"

#include "methods/evaluate.h"
#include "tests/lib/near.h"
#include "tests/lib/box_room.h"

/* A room 3.1 m wide with this depth, by exact+bre and bre-min at two points. */
static struct pp_reliability under(struct pp_sky sky, double depth_m,
                                   double skyline_deg, double ground)
{
    struct box_room box;
    box_room_build(&box, 3.1, depth_m, 2.7, 0.2, 0.5, 0.7);
    box_room_south(&box, 0.4, 0.9, 2.3, 1.5);
    box.light.sky = sky;
    box.light.ground_reflectance = ground;
    if (skyline_deg > 0.0)
        box_room_skyline(&box, skyline_deg * PP_RAD, 1.65, INFINITY);
    const struct pp_receiver points[2] = {
        {{1.5, 0.7, 0.85}, {0, 0, 1}, 0, 0.0},
        {{1.5, depth_m - 0.7, 0.85}, {0, 0, 1}, 0, 0.0}};
    struct pp_report report = {.world = &box.world,
                               .light = box.light,
                               .receivers = points,
                               .receiver_count = 2,
                               .finished = true};
    assert_int_equal(pp_methods_evaluate(&report, "exact+bre,bre-min", NULL), PP_OK);
    struct pp_reliability found = pp_reliability_of(&report);
    pp_report_clear(&report);
    return found;
}

static struct pp_reliability of_room(double depth_m, double skyline_deg, double ground)
{
    return under(pp_sky_overcast(), depth_m, skyline_deg, ground);
}

static void a_shallow_room_under_open_sky_is_relied_on(void **state)
{
    (void)state;
    struct pp_reliability found = of_room(2.6, 0.0, 0.1);
    char text[640];
    pp_reliability_sentence(&found, text, sizeof text);
    assert_false(found.any);
    assert_string_equal(text, "");
    assert_string_equal(found.grounds, "");
}

/* Behind a skyline the back of the room sees no sky, only the face of the skyline. */
static void without_sky_at_the_back_the_average_stands_for_the_darkest_point(
    void **state)
{
    (void)state;
    struct pp_reliability found = of_room(5.6, 50.0, 0.1);
    assert_true(found.is[PP_RELIABILITY_INSIDE]);
    assert_near(found.share[PP_RELIABILITY_INSIDE], 1.0, 0.0);
    assert_false(found.is[PP_RELIABILITY_PROPORTIONS]);
}

static void a_room_more_than_twice_as_deep_as_wide_is_beyond_the_table(void **state)
{
    (void)state;
    assert_false(of_room(6.2, 0.0, 0.1).is[PP_RELIABILITY_PROPORTIONS]);
    struct pp_reliability found = of_room(6.3, 0.0, 0.1);
    assert_true(found.is[PP_RELIABILITY_PROPORTIONS]);
    assert_near(found.share[PP_RELIABILITY_PROPORTIONS], 6.3 / 3.1, 1e-12);
}

static void a_ground_of_snow_is_far_from_the_one_built_in(void **state)
{
    (void)state;
    struct pp_reliability found = of_room(2.6, 0.0, 0.2);
    assert_false(found.is[PP_RELIABILITY_GROUND]);
    assert_non_null(strstr(found.grounds, "bre, bre-min: assumed ground reflectance"));
    assert_true(of_room(2.6, 0.0, 0.8).is[PP_RELIABILITY_GROUND]);
}

/* bre and bre-min give no figure under the uniform sky, so their assumption about the
 * ground is not mentioned. */
static void a_method_that_does_not_answer_is_not_named_for_its_ground(void **state)
{
    (void)state;
    struct pp_reliability found = under(pp_sky_uniform(), 2.6, 0.0, 0.8);
    assert_string_equal(found.grounds, "");
    assert_false(found.is[PP_RELIABILITY_GROUND]);
}

/* Nor is the table of bre-min, which is for the overcast sky. */
static void a_method_that_does_not_answer_is_not_named_for_its_table(void **state)
{
    (void)state;
    struct pp_reliability found = under(pp_sky_uniform(), 6.3, 0.0, 0.1);
    assert_false(found.is[PP_RELIABILITY_PROPORTIONS]);
    assert_true(of_room(6.3, 0.0, 0.1).is[PP_RELIABILITY_PROPORTIONS]);
}

static void every_kind_has_its_measured_band(void **state)
{
    (void)state;
    for (int kind = 0; kind < PP_RELIABILITY_KINDS; kind++) {
        const struct pp_reliability_band *band = pp_reliability_band(kind);
        assert_non_null(band);
        assert_true(band->low > 0.0 && band->low < band->high && band->rooms > 0);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shallow_room_under_open_sky_is_relied_on),
        cmocka_unit_test(
            without_sky_at_the_back_the_average_stands_for_the_darkest_point),
        cmocka_unit_test(a_room_more_than_twice_as_deep_as_wide_is_beyond_the_table),
        cmocka_unit_test(a_ground_of_snow_is_far_from_the_one_built_in),
        cmocka_unit_test(a_method_that_does_not_answer_is_not_named_for_its_ground),
        cmocka_unit_test(a_method_that_does_not_answer_is_not_named_for_its_table),
        cmocka_unit_test(every_kind_has_its_measured_band),
    };
    add_tests(tests, NULL, NULL);
}
