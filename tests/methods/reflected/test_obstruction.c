/* test_obstruction.c - the obstruction angle of an opening: from the wall, of level
 * glass, of the highest skyline. */
#include "methods/reflected/obstruction.h"

#include "tests/methods/box_method.h"
#include "tests/lib/room_of.h"

static double angle_in(const char *site, const char *opening, const char *outside)
{
    char xml[2000];
    snprintf(xml, sizeof xml,
             "<room version='1'>%s<plan width='4' depth='6' height='3'/>%s%s</room>",
             site, opening, outside);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    double angle_rad;
    assert_int_equal(
        pp_obstruction_angle(&angle_rad, world, &light, world->openings, NULL), PP_OK);
    pp_world_destroy(world);
    return angle_rad;
}

/* The file's angle is that at the middle of the wall's one window, 6 m from the
 * skyline, however deep the reveal. */
static void a_reveal_does_not_move_the_skyline(void **state)
{
    (void)state;
    static const char window[] =
        "<window wall='south' left='1' sill='1' width='2' height='1' reveal='%s'/>";
    static const char *const depths[] = {"0", "0.45"};
    for (int i = 0; i < 2; i++) {
        char opening[200];
        snprintf(opening, sizeof opening, window, depths[i]);
        assert_near(
            angle_in("", opening, "<skyline wall='south' angle='30' distance='6'/>"),
            30.0 * PP_RAD, 1e-12);
    }
}

/* Nor does a wall that goes on about it, in the plane of the glass. */
static void a_facade_about_the_glass_is_no_obstruction(void **state)
{
    (void)state;
    assert_near(angle_in("",
                         "<window wall='south' left='1' sill='1' width='2' height='1' "
                         "reveal='0.3'/>",
                         "<facade wall='south' left='20' right='20' up='9'/>"
                         "<skyline wall='south' angle='30' distance='6'/>"),
                30.0 * PP_RAD, 1e-12);
}

/* An endless wall that rises 8 m above level glass, 8 m off, leaves (1 + cos 45)/2 of
 * the uniform sky, and counts as that share of 90 degrees. */
static void level_glass_counts_the_share_of_the_sky_that_is_hidden(void **state)
{
    (void)state;
    double angle_rad = angle_in(
        "<sky type='uniform'/>", "<rooflight x='1.5' y='2.5' width='1' depth='1'/>",
        "<block x='-2998' y='-15' width='6000' depth='10' height='11'/>");
    assert_near(angle_rad, PP_PI / 2.0 * (1.0 - (1.0 + cos(PP_PI / 4.0)) / 2.0), 5e-4);
}

static void of_several_skylines_the_highest_counts(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 6.0, 5.0, 4.0, 0.2, 0.5, 0.7);
    struct pp_opening *window = box_room_south(&box, 0.5, 0.5, 1.0, 1.0);
    struct pp_skyline skylines[3];
    static const double degrees[3] = {20.0, 35.0, 10.0};
    for (int i = 0; i < 3; i++)
        skylines[i] = (struct pp_skyline){.face = window->face,
                                          .angle_rad = degrees[i] * PP_RAD,
                                          .distance_m = INFINITY,
                                          .reflectance = 0.2};
    box.world.skylines = skylines;
    box.world.skyline_count = 3;
    double angle_rad;
    assert_int_equal(
        pp_obstruction_angle(&angle_rad, &box.world, &box.light, window, NULL), PP_OK);
    assert_near(angle_rad, 35.0 * PP_RAD, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_reveal_does_not_move_the_skyline),
        cmocka_unit_test(a_facade_about_the_glass_is_no_obstruction),
        cmocka_unit_test(level_glass_counts_the_share_of_the_sky_that_is_hidden),
        cmocka_unit_test(of_several_skylines_the_highest_counts),
    };
    return cmocka_run_group_tests_name("obstruction angle", tests, NULL, NULL);
}
