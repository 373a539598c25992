/* test_trees_left_out.c - trees in front of windows, which some criteria leave out. */
#include "studies/criteria/trees_left_out.h"

#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<room version='1'><site>%s</site>\n<plan width='4' depth='5' height='2.8'/>\n"    \
    "<window wall='south' left='0.9' sill='0.8' width='2.2' height='1.5'/>\n"          \
    "<window wall='east' left='0.9' sill='1.1' width='1.2' height='1.1'/></room>"

/* Finds the trees of a room with these trees that was assessed by two criteria. */
static bool find_trees(struct pp_trees_left_out *found, struct pp_world **world,
                       const char *trees, const struct pp_criterion *one,
                       const struct pp_criterion *other)
{
    char xml[2000];
    snprintf(xml, sizeof xml, ROOM, trees);
    *world = pp_test_world(xml);
    struct pp_study_room room = {.world = *world};
    struct pp_answer answers[] = {{.criterion = one}, {.criterion = other}};
    const struct pp_assessment assessment = {.room = &room, .answers = {answers, 2}};
    return pp_trees_left_out_find(found, &assessment);
}

/* The centre of the south window is at a height of 1.55 m. The near edge of the crown
 * is 4.5 m in front of it: tan h = (9 - 1.55) / 4.5. */
static void the_highest_crown_before_a_window_is_named(void **state)
{
    (void)state;
    struct pp_trees_left_out found;
    struct pp_world *world;
    assert_true(find_trees(&found, &world,
                           "<tree x='2' y='-20' height='7' crown-width='4' "
                           "transmittance='0.2'/>\n<tree x='2' y='-6' height='9' "
                           "crown-width='3' transmittance='0.2'/>",
                           &pp_criterion_vertical_sky, &pp_criterion_average));
    assert_near(found.altitude_rad, atan2(7.45, 4.5), 1e-9);
    assert_int_equal(found.line, 2);
    assert_true(found.opening == &world->openings[0]);
    assert_int_equal(found.count, 1);
    assert_true(found.criteria[0] == &pp_criterion_vertical_sky);
    pp_world_destroy(world);
}

/* West of the room no tree is in front of its south and east windows. The crown of the
 * other tree is lower than the centres of the windows. */
static void trees_that_no_window_faces_or_below_it_do_not_matter(void **state)
{
    (void)state;
    struct pp_trees_left_out found;
    struct pp_world *world;
    assert_false(find_trees(&found, &world,
                            "<tree x='-9' y='4' height='9' crown-width='4' "
                            "transmittance='0.2'/><tree x='2' y='-6' height='1.5' "
                            "crown-width='3' transmittance='0.2'/>",
                            &pp_criterion_vertical_sky, &pp_criterion_no_sky_line));
    pp_world_destroy(world);
}

static void criteria_by_daylight_factors_do_not_leave_trees_out(void **state)
{
    (void)state;
    struct pp_trees_left_out found;
    struct pp_world *world;
    assert_false(find_trees(&found, &world,
                            "<tree x='2' y='-6' height='9' crown-width='3' "
                            "transmittance='0.2'/>",
                            &pp_criterion_en17037, &pp_criterion_average));
    pp_world_destroy(world);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_highest_crown_before_a_window_is_named),
        cmocka_unit_test(trees_that_no_window_faces_or_below_it_do_not_matter),
        cmocka_unit_test(criteria_by_daylight_factors_do_not_leave_trees_out),
    };
    add_tests(tests, NULL, NULL);
}
