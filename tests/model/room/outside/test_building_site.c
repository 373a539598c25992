/* test_building_site.c - rooms placed in a building, and their surroundings. */
#include <math.h>
#include <stdio.h>

#include "methods/exact/exterior.h"
#include "model/room/building.h"
#include "tests/lib/room_of.h"

static struct pp_building *building_of(const char *inside)
{
    char xml[4096];
    snprintf(xml, sizeof xml, "<building version=\"1\" north=\"17\">%s</building>",
             inside);
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    struct pp_error err = {0};
    if (pp_building_parse(&building, xml, strlen(xml), &mistakes, &err) != PP_OK)
        fail_msg("%s: %s", xml, mistakes.count ? mistakes.list[0].text : err.message);
    pp_mistakes_clear(&mistakes);
    return building;
}

static struct pp_world *world_of(struct pp_building *building, int index)
{
    struct pp_world *world;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    if (pp_world_create(&world, pp_building_room(building, index), &mistakes, NULL)
        != PP_OK)
        fail_msg("%s", mistakes.count ? mistakes.list[0].text : "no world");
    pp_mistakes_clear(&mistakes);
    return world;
}

/* Vertical sky component at the first opening. */
static double component_of(const struct pp_world *world)
{
    const struct pp_opening *opening = &world->openings[0];
    const struct pp_sky overcast = pp_sky_overcast();
    double share;
    assert_int_equal(pp_exterior_sky_on_plane(&share, world, opening,
                                              pp_vec_scale(opening->inner.normal, -1.0),
                                              &overcast, NULL),
                     PP_OK);
    return share;
}

static double component_in(const char *inside, int index)
{
    struct pp_building *building = building_of(inside);
    struct pp_world *world = world_of(building, index);
    double share = component_of(world);
    pp_world_destroy(world);
    pp_building_destroy(building);
    return share;
}

static double component_alone(const char *inside)
{
    char xml[2048];
    snprintf(xml, sizeof xml, "<room version=\"1\">%s</room>", inside);
    struct pp_world *world = pp_test_world(xml);
    double share = component_of(world);
    pp_world_destroy(world);
    return share;
}

#define ROOM                                                                           \
    "<plan width='4.2' depth='5.3' height='2.7'/>"                                     \
    "<window wall='south' left='0.9' sill='0.8' width='2.4' height='1.5'/>"

/* Coordinates of a point of the building in the axes of a room at (11.3, -4.7, 6.1),
 * rotated by 30 degrees, calculated independently. */
static void a_placed_room_has_the_site_in_its_own_axes(void **state)
{
    (void)state;
    char alone[1024];
    double c = cos(M_PI / 6.0), s = sin(M_PI / 6.0), dx = 4.9 - 11.3, dy = -22.3 + 4.7;
    snprintf(
        alone, sizeof alone,
        "<site ground-level='-6.5'/>" ROOM
        "<block x='%.17g' y='%.17g' width='17' depth='6' height='19' rotate='-18'/>",
        c * dx + s * dy, -s * dx + c * dy);
    double placed = component_in(
        "<site ground-level='-0.4'/>"
        "<block x='4.9' y='-22.3' width='17' depth='6' height='19' rotate='12'/>"
        "<room x='11.3' y='-4.7' z='6.1' rotate='30'>" ROOM "</room>",
        0);
    assert_near(placed, component_alone(alone), 1e-12);
    assert_true(placed < 0.39);
}

static void a_room_is_turned_with_its_bearing(void **state)
{
    (void)state;
    struct pp_building *building =
        building_of("<room x='1' rotate='30'>" ROOM "</room><room>" ROOM "</room>"
                    "<room north='5'>" ROOM "</room>");
    static const double bearings[] = {17.0 - 30.0, 17.0, 5.0};
    for (int i = 0; i < 3; i++) {
        struct pp_world *world = world_of(building, i);
        assert_near(world->north_rad, bearings[i] * PP_RAD, 1e-15);
        pp_world_destroy(world);
    }
    pp_building_destroy(building);
}

/* A room 5.3 m deep and 2.7 m high, 9.1 m in front of the window, compared with a block
 * of that size. */
static void a_room_shades_as_a_block_of_its_size(void **state)
{
    (void)state;
    double by_room = component_in("<room x='0' y='0'>" ROOM "</room>"
                                  "<room x='-0.7' y='-14.4' z='1.1'>" ROOM "</room>",
                                  0);
    double by_block = component_alone(ROOM "<block x='-0.7' y='-14.4' width='4.2' "
                                           "depth='5.3' base='1.1' height='2.7'/>");
    assert_near(by_room, by_block, 1e-12);
    assert_true(by_room < component_alone(ROOM) - 1e-3);
}

static void a_room_without_position_has_no_neighbours(void **state)
{
    (void)state;
    double alone = component_in("<room>" ROOM "</room><room x='-0.7' y='-14.4'>" ROOM
                                "</room><room>" ROOM "</room>",
                                0);
    assert_near(alone, component_alone(ROOM), 0.0);
}

static void each_state_has_its_own_site(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Mill' x='0' y='-20' width='9' depth='5' height='7'/>"
        "<block name='Shed' state='existing' x='10' y='-20' width='9' depth='5' "
        "height='3'/>"
        "<block name='Tower' state='proposed' x='20' y='-20' width='9' depth='5' "
        "height='30'/>"
        "<room name='Old' state='existing'>" ROOM "</room><room name='Stays'>" ROOM
        "</room>");
    assert_true(pp_building_has_states(building));
    /* As read: proposed. */
    assert_int_equal(pp_building_room_count(building), 1);
    assert_int_equal(pp_building_openings_before(building, 0), 1);
    struct pp_world *world = world_of(building, 0);
    assert_string_equal(world->name, "Stays");
    assert_int_equal(world->block_count, 2);
    assert_string_equal(world->blocks[1].name, "Tower");
    pp_world_destroy(world);

    assert_int_equal(pp_building_set_state(building, PP_STATE_EXISTING, NULL), PP_OK);
    assert_int_equal(pp_building_room_count(building), 2);
    assert_int_equal(pp_building_openings_before(building, 1), 1);
    world = world_of(building, 1);
    assert_string_equal(world->blocks[1].name, "Shed");
    pp_world_destroy(world);
    pp_building_destroy(building);
}

static void the_cumulative_state_has_the_proposal_and_more(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Shed' state='existing' x='10' y='-20' width='9' depth='5' "
        "height='3'/>"
        "<block name='Tower' state='proposed' x='20' y='-20' width='9' depth='5' "
        "height='30'/>"
        "<block name='Next' state='cumulative' x='-20' y='-20' width='9' depth='5' "
        "height='30'/>"
        "<room name='Stays'>" ROOM "</room>");
    assert_true(pp_building_has_cumulative(building));
    struct pp_world *world = world_of(building, 0);
    assert_int_equal(world->block_count, 1);
    pp_world_destroy(world);
    assert_int_equal(pp_building_set_state(building, PP_STATE_CUMULATIVE, NULL), PP_OK);
    world = world_of(building, 0);
    assert_int_equal(world->block_count, 2);
    assert_string_equal(world->blocks[0].name, "Tower");
    assert_string_equal(world->blocks[1].name, "Next");
    pp_world_destroy(world);
    assert_int_equal(pp_building_set_state(building, PP_STATE_EXISTING, NULL), PP_OK);
    world = world_of(building, 0);
    assert_int_equal(world->block_count, 1);
    assert_string_equal(world->blocks[0].name, "Shed");
    pp_world_destroy(world);
    pp_building_destroy(building);
}

static void a_skyline_of_the_site_is_in_front_of_walls_of_that_name(void **state)
{
    (void)state;
    struct pp_building *building =
        building_of("<skyline wall='south' angle='20'/><room>" ROOM "</room>"
                    "<room><plan height='2.7'><vertex x='0' y='0'/>"
                    "<vertex x='4' y='0'/><vertex x='2' y='3'/></plan></room>");
    for (int i = 0; i < 2; i++) {
        struct pp_world *world = world_of(building, i);
        assert_int_equal(world->skyline_count, 1 - i);
        pp_world_destroy(world);
    }
    pp_building_destroy(building);
}

static void a_rectangular_footprint_is_a_box(void **state)
{
    (void)state;
    double box =
        component_alone(ROOM "<block x='-3.1' y='-12.7' width='7.9' depth='4.3' "
                             "height='9.2' rotate='21'/>");
    double footprint = component_alone(
        ROOM "<block x='-3.1' y='-12.7' height='9.2' rotate='21'><vertex x='0' y='0'/>"
             "<vertex x='7.9' y='0'/><vertex x='7.9' y='4.3'/><vertex x='0' y='4.3'/>"
             "</block>");
    assert_near(footprint, box, 1e-12);
}

static bool is_inner(const struct pp_world *world, const char *name)
{
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].name && strcmp(world->surfaces[i].name, name) == 0)
            return world->surfaces[i].is_inner;
    fail_msg("no wall %s", name);
    return false;
}

/* 0.2 m of wall to the east, a court of 3 m to the north, a party wall to the west. */
static void a_wall_before_another_room_is_an_inner_one(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<room x='0'>" ROOM "<wall name='west' kind='party'/></room><room x='4.4'>" ROOM
        "</room><room x='0' y='8.3'>" ROOM "</room>");
    struct pp_world *world = world_of(building, 0);
    assert_true(is_inner(world, "east"));
    assert_true(is_inner(world, "west"));
    assert_false(is_inner(world, "north"));
    assert_false(is_inner(world, "south"));
    pp_world_destroy(world);
    pp_building_destroy(building);
}

/* The ridge of a gable roof hides the same sky as a thin wall of its height in its
 * place, if the eaves are below the line of sight to the ridge. */
static void a_roof_hides_sky_up_to_its_ridge(void **state)
{
    (void)state;
    double flat = component_alone(
        ROOM "<block x='-300' y='-26' width='600' depth='8' height='6'/>");
    double gable = component_alone(ROOM "<block x='-300' y='-26' width='600' depth='8' "
                                        "height='6' roof='gable' pitch='40'/>");
    double ridge_m = 6.0 + 4.0 * tan(40.0 * PP_RAD);
    char wall[512];
    snprintf(wall, sizeof wall,
             ROOM "<block x='-300' y='-22' width='600' depth='0.001' height='%.17g'/>",
             ridge_m);
    /* The eaves, 4 m nearer and 3.4 m lower, are below the line to the ridge. */
    assert_true((6.0 - 1.55) / 18.0 < (ridge_m - 1.55) / 22.0);
    assert_near(gable, component_alone(wall), 1e-6);
    assert_true(gable < flat - 1e-3);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_placed_room_has_the_site_in_its_own_axes),
        cmocka_unit_test(a_room_is_turned_with_its_bearing),
        cmocka_unit_test(a_room_shades_as_a_block_of_its_size),
        cmocka_unit_test(a_room_without_position_has_no_neighbours),
        cmocka_unit_test(each_state_has_its_own_site),
        cmocka_unit_test(the_cumulative_state_has_the_proposal_and_more),
        cmocka_unit_test(a_skyline_of_the_site_is_in_front_of_walls_of_that_name),
        cmocka_unit_test(a_wall_before_another_room_is_an_inner_one),
        cmocka_unit_test(a_rectangular_footprint_is_a_box),
        cmocka_unit_test(a_roof_hides_sky_up_to_its_ridge),
    };
    add_tests(tests, NULL, NULL);
}
