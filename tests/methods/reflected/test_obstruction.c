/* test_obstruction.c - the obstruction angle of an opening: from its wall, of
 * horizontal glass, of the highest skyline; and the angle of visible sky. */
#include "methods/reflected/obstruction.h"
#include "methods/reflected/sky_angle.h"

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

/* The angle in the file applies at the middle of the only window of the wall, 6 m from
 * the skyline, for any depth of the reveal. */
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

/* Nor does a wall that surrounds the glass in the plane of the glass obstruct it. */
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

/* A wall 0.45 m thick with the same surroundings, in the three ways in which a file can
 * describe it: glass at the outer face, at the inner face, and between them. */
static const char *const thick_walls[][2] = {
    {"reveal='0.45'", "<facade wall='south' left='4' right='3' up='2'/>"},
    {"reveal='0'", "<facade wall='south' left='4' right='3' up='2' depth='0.45'/>"},
    {"reveal='0.2'", "<facade wall='south' left='4' right='3' up='2' depth='0.45'/>"},
};
enum { THICK_WALLS = 3 };

static void write_window(char text[200], const char *reveal)
{
    snprintf(text, 200,
             "<window wall='south' left='1' sill='1' width='2' height='1.3' %s/>",
             reveal);
}

/* With a skyline, or with blocks, whose angle is calculated from the sky that they
 * leave. */
static void the_wall_s_own_thickness_is_no_obstruction(void **state)
{
    (void)state;
    static const char *const before[2] = {
        "<skyline wall='south' angle='20'/>",
        "<block x='-3' y='-9' width='5.3' depth='4' height='6.1'/>"
        "<block x='3.1' y='-12' width='4' depth='4' height='9'/>"};
    for (int b = 0; b < 2; b++) {
        double angles[THICK_WALLS];
        for (int i = 0; i < THICK_WALLS; i++) {
            char window[200], outside[400];
            write_window(window, thick_walls[i][0]);
            snprintf(outside, sizeof outside, "%s%s", before[b], thick_walls[i][1]);
            angles[i] = angle_in("", window, outside);
        }
        for (int i = 0; i < THICK_WALLS; i++)
            assert_near(angles[i], b == 0 ? 20.0 * PP_RAD : angles[0], 1e-9);
        assert_true(angles[0] > 15.0 * PP_RAD && angles[0] < 45.0 * PP_RAD);
    }
}

/* The head of the reveal hides the zenith: atan(1.3/2 / 0.45) less 20 degrees. */
static void the_wall_s_own_thickness_limits_the_sky_from_above(void **state)
{
    (void)state;
    for (int i = 0; i < THICK_WALLS; i++) {
        char window[200], xml[1000];
        write_window(window, thick_walls[i][0]);
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='4' depth='6' height='3'/>%s%s"
                 "<skyline wall='south' angle='20'/></room>",
                 window, thick_walls[i][1]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        struct pp_steps steps = {0};
        struct pp_formulary *formulary;
        static const struct pp_formula *const formulae[] = {PP_SKY_ANGLE_FORMULAE,
                                                            NULL};
        assert_int_equal(pp_formulary_create(&formulary, formulae, NULL, NULL), PP_OK);
        struct pp_worksheet sheet = {.steps = &steps, .formulary = formulary};
        assert_int_equal(pp_sky_angle(&sheet, world, &light, &world->openings[0], NULL),
                         PP_OK);
        const struct pp_calculation_step *theta = pp_steps_find(&steps, 0, "theta");
        assert_non_null(theta);
        assert_near(theta->value, atan(1.3 / 2.0 / 0.45) - 20.0 * PP_RAD, 1e-12);
        pp_formulary_destroy(formulary);
        pp_steps_clear(&steps);
        pp_world_destroy(world);
    }
}

/* An infinitely long wall 8 m away, which rises 8 m above horizontal glass, leaves (1 +
 * cos 45)/2 of the uniform sky. Its angle is the hidden share of 90 degrees. */
static void level_glass_counts_the_share_of_the_sky_that_is_hidden(void **state)
{
    (void)state;
    double angle_rad = angle_in(
        "<sky type='uniform'/>", "<rooflight x='1.5' y='2.5' width='1' depth='1'/>",
        "<block x='-2998' y='-15' width='6000' depth='10' height='11'/>");
    assert_near(angle_rad, PP_PI / 2.0 * (1.0 - (1.0 + cos(PP_PI / 4.0)) / 2.0), 5e-4);
}

static void the_highest_of_several_skylines_counts(void **state)
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

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_reveal_does_not_move_the_skyline),
        cmocka_unit_test(a_facade_about_the_glass_is_no_obstruction),
        cmocka_unit_test(the_wall_s_own_thickness_is_no_obstruction),
        cmocka_unit_test(the_wall_s_own_thickness_limits_the_sky_from_above),
        cmocka_unit_test(level_glass_counts_the_share_of_the_sky_that_is_hidden),
        cmocka_unit_test(the_highest_of_several_skylines_counts),
    };
    add_tests(tests, NULL, NULL);
}
